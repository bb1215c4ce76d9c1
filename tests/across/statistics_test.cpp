#include "report/statistics.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "dataset/lines.h"
#include "record/home_cache.h"
#include "report/charts.h"
#include "report/figure_table.h"
#include "report/report_page.h"
#include "scene/scene_json.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Histogram of(std::initializer_list<int> values) {
  Histogram histogram;
  for (const int value : values) histogram.add(value);
  return histogram;
}

DatasetStatistics small(const std::string& name) {
  DatasetStatistics set;
  set.name = name;
  set.tasks = 3;
  set.by_simulator_and_split = {{{"ai2thor", "atomic"}, 2}, {{"habitat", "logical"}, 1}};
  set.templates = {{"open-one", 2}, {"close-one", 1}};
  set.instruction_words = of({4, 5, 12});
  set.plan_lengths = {{"M1", of({3, 4, 8})}};
  set.actions = {{"M1", {{"go_to", 7}, {"stop", 3}}}};
  set.failed_steps = {{"M1", 0}};
  set.funnel = {{"close-one", 1, {{"expert: action-failed", 2}}}, {"open-one", 2, {}}};
  set.evenness = {{"template", {{"open-one", 2}, {"close-one", 1}}, 1.8, 1.89, 0.33}};
  return set;
}

TEST(Histogram, KnowsItsMiddle) {
  EXPECT_DOUBLE_EQ(of({4, 5, 12}).mean(), 7);
  EXPECT_DOUBLE_EQ(of({4, 5, 12}).median(), 5);
  EXPECT_DOUBLE_EQ(of({1, 2, 4, 9}).median(), 3);
  EXPECT_EQ(of({4, 5, 12}).most(), 12);
  EXPECT_DOUBLE_EQ(Histogram().mean(), 0);
  EXPECT_DOUBLE_EQ(Histogram().median(), 0);
}

/// A home of one kitchen with so many mugs.
Scene home_of(const std::string& id, int mugs) {
  Scene home;
  home.id = id;
  home.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}}};
  for (int i = 1; i <= mugs; ++i) {
    Node mug;
    mug.id = "mug_" + std::to_string(i);
    mug.category = "Mug";
    mug.size = {0.1, 0.1, 0.1};
    mug.pose.position = {0.5 * i, 1, 0.05};
    home.nodes.push_back(std::move(mug));
  }
  return home;
}

TaskEntry entry(const std::string& id, const std::string& home, const std::string& name, const std::string& text,
                const std::string& goal) {
  TaskEntry task;
  task.id = task.scene = id;
  task.simulator = "ai2thor";
  task.split = "atomic";
  task.template_name = name;
  task.layout = home;
  task.bindings = {{"A", "Bowl"}};
  task.goal_text = goal;
  task.goal = *parse_formula("goal", goal, FormulaUse::Goal);
  task.changes = "{}";
  task.instruction = {text, "grammar", Style::Direct, {}, ""};
  if (name == "open-one") task.purpose = {"preparing", {"mug is closed"}};
  task.expert = {{Mode::M1, 2, 1}};
  return task;
}

/// A folder of three tasks in two homes: the last task is in the home of the first.
class SetOfThree {
 public:
  SetOfThree() {
    for (const auto& home : {home_of("first", 2), home_of("second", 5)})
      EXPECT_TRUE(write_file(scratch_.path(), home_file(home.id), gzip(scene_to_json(home))));
    write("tasks.jsonl", {line_of(entry("t-1", "first", "open-one", "Put the mug on a table.",
                                        "(at-end (exists (?a - Mug) (clean ?a)))")),
                          line_of(entry("t-2", "second", "close-one", "Wash 2 stir-fry pans -",
                                        "(at-end (exists (?a - Mug) (not (clean ?a))))")),
                          line_of(entry("t-3", "first", "open-one", "put THE mug's lid on two mugs, please!",
                                        "(exists (?a - Mug) (sometime (held ?a)))"))});
    const Command open{"open", {{"mug_1", std::nullopt}}}, stop{"stop", {}};
    const Delta none;
    const std::vector<Delta> at_once;
    std::vector<std::string> shown;
    for (const char* task : {"t-1", "t-2", "t-3"})
      shown.push_back(demonstration_line(task, Mode::M1,
                                         {{open, false, "too-far", "It is too far.", {}, none, at_once},
                                          {stop, true, "none", "", {}, none, at_once}}));
    write("demonstrations/M1.jsonl", shown);
    const RejectionEntry given_up{3, 0, "open-one", "ai2thor", "atomic", "expert", "action-failed", ""};
    write("rejections.jsonl", {line_of(given_up), line_of(given_up)});
    set.folder = scratch_.path();
    set.name = "three";
    set.modes = {Mode::M1};
  }
  FinishedSet set;

  void write(const std::string& file, const std::vector<std::string>& lines) const {
    std::string text;
    for (const auto& line : lines) text += line + "\n";
    EXPECT_TRUE(write_file(scratch_.path(), file, text));
  }

 private:
  ScratchFolder scratch_;
};

Category category(const std::string& name) {
  Category one;
  one.name = name;
  return one;
}

DatasetStatistics counted(const FinishedSet& set) {
  const Knowledge knowledge(Simulator::Ai2thor, {category("Bowl"), category("Mug"), category("Plate")}, {}, {}, {}, {});
  const Knowledge unused(Simulator::Habitat, {category("bowl")}, {}, {}, {}, {});
  auto statistics = statistics_of_set(set, {&knowledge, &unused}, 2);
  EXPECT_TRUE(statistics) << format(statistics.error());
  return statistics ? *statistics : DatasetStatistics();
}

TEST(Statistics, CountEachWordAndEachDistinctWordOnce) {
  const auto statistics = counted(SetOfThree().set);
  // put the mug on a table | mug's lid two mugs please | wash 2 stir-fry pans
  EXPECT_EQ(statistics.distinct_words, 15);
  EXPECT_EQ(statistics.instruction_words.counts, (std::map<int, int>{{4, 1}, {6, 1}, {8, 1}}));
  EXPECT_EQ(statistics.words, (Tally{{"put", 2},
                                     {"mug", 1},
                                     {"table", 1},
                                     {"mug's", 1},
                                     {"lid", 1},
                                     {"two", 1},
                                     {"mugs", 1},
                                     {"wash", 1},
                                     {"2", 1},
                                     {"stir-fry", 1},
                                     {"pans", 1}}));
}

TEST(Statistics, CountHomesOnceAndGoalsByTask) {
  const SetOfThree three;
  const auto statistics = counted(three.set);
  EXPECT_EQ(statistics.tasks, 3);
  EXPECT_EQ(statistics.homes, 2);
  EXPECT_EQ(statistics.rooms.counts, (std::map<int, int>{{1, 2}}));
  EXPECT_EQ(statistics.objects.counts, (std::map<int, int>{{2, 1}, {5, 1}}));
  EXPECT_EQ(statistics.templates, (Tally{{"close-one", 1}, {"open-one", 2}}));
  EXPECT_EQ(statistics.purposes, (Tally{{"preparing", 2}}));
  EXPECT_EQ(statistics.predicates, (Tally{{"clean", 2}, {"held", 1}}));
  EXPECT_EQ(statistics.operators.at("at-end"), 2);
  EXPECT_EQ(statistics.operators.at("sometime"), 1);
  EXPECT_EQ(statistics.plan_lengths.at("M1").counts, (std::map<int, int>{{2, 3}}));
  EXPECT_EQ(statistics.actions.at("M1"), (Tally{{"open", 3}, {"stop", 3}}));
  EXPECT_EQ(statistics.failed_steps.at("M1"), 3);
  ASSERT_EQ(statistics.things.size(), 1U);
  EXPECT_EQ(statistics.things[0].objects, 3);  // the mug that each opens
  ASSERT_EQ(statistics.coverage.size(), 1U);   // nothing of the other simulator
  EXPECT_EQ(statistics.coverage[0].known, 3);
  EXPECT_EQ(statistics.coverage[0].handled, 1);
  EXPECT_EQ(statistics.coverage[0].in_homes, 2);
}

/// A task that opened one mug and picked up another one and a bowl; the start added the first and moved the bowl.
FinishedTask with_edits() {
  FinishedTask task;
  task.record.goal_tree =
      *parse_formula("goal", "(exists (?a - Mug) (exists (?b - Bowl) (at-end (next_to ?a ?b))))", FormulaUse::Goal);
  task.record.edits = {"added Mug mug_4 on counter_top_1, dirty", "moved bowl_2 on counter_top_1",
                       "made plate_1 dirty"};
  auto& steps = task.shown[Mode::M1].steps;
  for (const char* id : {"mug_4", "mug_7", "bowl_2", "counter_top_1", "mug_7"})
    steps.push_back({{"go_to", {{id, std::nullopt}}}, true, "", "", {}, {}});
  return task;
}

TEST(GoalThings, AreWhatTheDemonstrationActsOnAndTheGoalNames) {
  const auto things = goal_things_of(with_edits());
  EXPECT_EQ(things.categories, (std::set<std::string>{"Bowl", "Mug"}));
  EXPECT_EQ(things.objects, 3);  // two mugs and the bowl; the countertop is not in the goal
  EXPECT_EQ(things.added, 1);
  EXPECT_EQ(things.moved, 1);
}

TEST(GoalThings, OfASimulatorSayWhatIsNamedMostAndWhatIsCommonButInNoGoal) {
  auto mug = category("Mug"), bowl = category("Bowl"), plate = category("Plate"), sink = category("Sink");
  mug.movable = bowl.movable = plate.movable = true;
  sink.movable = false;
  const Knowledge knowledge(Simulator::Ai2thor, {bowl, mug, plate, sink}, {}, {}, {}, {});
  GoalThings things;
  things.add({{"Mug", "Sink"}, 2, 1, 0});
  things.add({{"Bowl", "Mug"}, 2, 0, 1});
  things.finish(knowledge, {{"Mug", 3}, {"Plate", 9}, {"Sink", 20}});
  EXPECT_EQ(things.tasks, 2);
  EXPECT_EQ(things.objects, 4);
  EXPECT_EQ(things.movable, 3);
  EXPECT_EQ(things.categories, (Tally{{"Bowl", 1}, {"Mug", 2}}));
  EXPECT_EQ(things.most_named(), "Mug");
  EXPECT_THAT(things.common_unused, ElementsAre("Plate"));
}

TEST(Statistics, EvennessAndTheFunnelAreOfTheCandidates) {
  SetOfThree three;
  three.set.level["template"] = {{"close-one", 1}, {"open-one", 3}};
  const auto statistics = counted(three.set);
  ASSERT_EQ(statistics.evenness.size(), 1U);
  EXPECT_DOUBLE_EQ(statistics.evenness[0].effective, 1.6);       // 16 / (9 + 1)
  EXPECT_NEAR(statistics.evenness[0].by_entropy, 1.7548, 1e-4);  // exp(-3/4 ln 3/4 - 1/4 ln 1/4)
  EXPECT_DOUBLE_EQ(statistics.evenness[0].variation, 0.5);       // of 3 and 1
  EXPECT_EQ(statistics.candidates(), 5);
  ASSERT_EQ(statistics.funnel.size(), 2U);
  EXPECT_EQ(statistics.funnel[1].accepted, 2);
  EXPECT_EQ(statistics.funnel[1].causes, (Tally{{"expert: action-failed", 2}}));
}

TEST(Statistics, AreTheSameForAnyNumberOfThreads) {
  const SetOfThree three;
  const auto one = statistics_of_set(three.set, {}, 1), four = statistics_of_set(three.set, {}, 4);
  ASSERT_TRUE(one && four);
  EXPECT_EQ(statistics_json({*one}), statistics_json({*four}));
}

TEST(Statistics, OfUsualCategoriesAreWrittenAsJson) {
  const std::string text = usual_coverage_json(
      {{"mine",
        {{"ai2thor", 5, {"Mug", "Pen"}, {{"Pen", {"pick-up-one"}, 2}}, {{"Cup", {"pour-wine-into-one"}, 3, 4, 9}}},
         {"habitat", 0, {}, {}, {}}}}});
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["format"], "unietp-usual-coverage/1");
  const auto& of_set = json["sets"][0];
  EXPECT_EQ(of_set["name"], "mine");
  EXPECT_EQ(of_set["simulators"][0],
            nlohmann::json::parse(
                R"({"simulator": "ai2thor", "with_usual_goals": 5, "in_goals": 3, "in_no_goal": ["Mug", "Pen"],
                    "common_in_no_goal": [{"category": "Pen", "templates": ["pick-up-one"], "tasks": 2}],
                    "only_choice": [{"category": "Cup", "templates": ["pour-wine-into-one"], "tasks": 3, "named": 4,
                                     "all": 9}]})"));
  EXPECT_EQ(of_set["simulators"][1]["in_goals"], 0);
}

TEST(Statistics, NameTheLineThatCannotBeRead) {
  const SetOfThree three;
  three.write("rejections.jsonl", {"{}"});
  const auto statistics = statistics_of_set(three.set, {}, 2);
  ASSERT_FALSE(statistics);
  EXPECT_THAT(format(statistics.error()), HasSubstr("rejections.jsonl:1"));
}

TEST(Examples, AreSpreadOverTheFileAndRoundRobinOverSimulatorsAndSplits) {
  DatasetStatistics statistics;
  statistics.tasks = 7;
  statistics.by_simulator_and_split = {
      {{"ai2thor", "atomic"}, 4}, {{"habitat", "atomic"}, 2}, {{"ai2thor", "logical"}, 1}};
  EXPECT_THAT(example_places(statistics, 4),
              ElementsAre(ExamplePlace{"atomic", "ai2thor", 0}, ExamplePlace{"atomic", "habitat", 0},
                          ExamplePlace{"logical", "ai2thor", 0}, ExamplePlace{"atomic", "ai2thor", 1}));
  const auto all = example_places(statistics, 100);
  EXPECT_EQ(std::set<ExamplePlace>(all.begin(), all.end()).size(), 7U);
}

TEST(Examples, AreReadInTheOrderOfTheirPlaces) {
  const SetOfThree three;
  const auto examples = read_examples(three.set, {{"atomic", "ai2thor", 2}, {"atomic", "ai2thor", 0}}, 2);
  ASSERT_TRUE(examples) << format(examples.error());
  ASSERT_EQ(examples->size(), 2U);
  EXPECT_EQ((*examples)[0].record.id, "t-3");
  EXPECT_EQ((*examples)[1].record.id, "t-1");
  ASSERT_EQ((*examples)[0].plans.size(), 1U);
  EXPECT_EQ((*examples)[0].plans[0].steps[0].feedback, "It is too far.");
  EXPECT_FALSE(read_examples(three.set, {{"atomic", "ai2thor", 3}}, 2));
}

TEST(FunnelRow, AddsUp) { EXPECT_EQ(small("a").candidates(), 5); }

TEST(Tables, OneSetHasACrossTableAndSeveralStandSideBySide) {
  const std::vector<DatasetStatistics> sets{small("a"), small("b")};
  const auto one = table_text(tables_of({sets.data(), 1}), 100);
  EXPECT_THAT(one, HasSubstr("  simulator  atomic  logical  all\n  ai2thor         2        0    2\n"));
  EXPECT_THAT(one, HasSubstr("close-one               1 of 3  expert: action-failed (2)"));
  const auto two = table_text(tables_of(sets), 100);
  EXPECT_THAT(two, HasSubstr("                       a       b\n  tasks                3       3\n"));
  EXPECT_THAT(two, HasSubstr("  ai2thor, atomic"));
}

TEST(Tables, ALongOneSaysWhatItLeavesOut) {
  auto set = small("a");
  for (const auto& word : {"a1", "a2", "a3"}) set.words[word] = 1;
  EXPECT_THAT(table_text(tables_of({&set, 1}), 2), HasSubstr("… and 1 more; --json prints all"));
}

TEST(Numbers, AreWrittenForPeople) {
  EXPECT_EQ(count_text(1234567), "1,234,567");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(decimal_text(3), "3.0");
  EXPECT_EQ(percent_text(0.8163), "81.6 %");
}

TEST(Charts, EachHasATableAndAsManyValuesAsLabels) {
  const auto set = small("a");
  std::vector<std::string> tables;
  for (const auto& table : tables_of({&set, 1})) tables.push_back(table.id);
  for (const auto& section : chart_sections(set)) {
    for (const auto& chart : section.charts) {
      EXPECT_THAT(tables, ::testing::Contains(chart.table));
      for (const auto& series : chart.series) EXPECT_EQ(series.values.size(), chart.labels.size()) << chart.id;
    }
  }
}

TEST(Charts, TheFunnelStacksWhatBecameOfEachTemplatesCandidates) {
  auto set = small("a");
  set.funnel = {{"close-one", 1, {{"expert: action-failed", 2}, {"grounding: no-layout", 5}}},
                {"open-one", 2, {{"expert: no-plan", 3}}},
                {"place-one", 4, {}}};
  bool found = false;
  for (const auto& section : chart_sections(set)) {
    for (const auto& chart : section.charts) {
      if (chart.id != "funnel") continue;
      found = true;
      EXPECT_TRUE(chart.stacked && chart.horizontal && chart.wide);
      EXPECT_THAT(chart.labels, ElementsAre("close-one", "open-one"));
      ASSERT_EQ(chart.series.size(), 3U);
      EXPECT_THAT(chart.series[0].values, ElementsAre(1, 2));
      EXPECT_EQ(chart.series[1].name, "rejected by the expert");
      EXPECT_THAT(chart.series[1].values, ElementsAre(2, 3));
      EXPECT_THAT(chart.series[2].values, ElementsAre(5, 0));
    }
  }
  EXPECT_TRUE(found);
}

TEST(Charts, BinsAreWideEnoughForAllValues) {
  auto set = small("a");
  set.objects = of({3, 250});
  for (const auto& section : chart_sections(set)) {
    for (const auto& chart : section.charts) {
      if (chart.id != "objects") continue;
      EXPECT_LE(chart.labels.size(), 24U);
      EXPECT_EQ(chart.labels.front(), "0–19");
      EXPECT_EQ(chart.series[0].values.front(), 1);
      EXPECT_EQ(chart.series[0].values.back(), 1);
    }
  }
}

}  // namespace
}  // namespace unietp
