#include "validator/nearest_tasks.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/validator/edited_homes.h"
#include "validator/repeats.h"

namespace unietp::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<std::string> kThings{"Mug", "Cup", "Bowl"}, kVerbs{"Put", "Place"}, kEnds{".", " please.", " now."};

struct HomeTask {
  TaskRecord record;
  Scene home;
};

HomeTask home_task(const std::string& id, const Scene& home, const std::string& thing, const std::string& text) {
  HomeTask task;
  task.record.id = id;
  task.record.layout = home.id;
  task.record.instruction = text;
  task.record.goal_text = "(exists (?a - " + thing + ") (exists (?b - Sofa) (at-end (on ?a ?b))))";
  task.record.goal_tree = *parse_formula("goal", task.record.goal_text, FormulaUse::Goal);
  task.home = home;
  return task;
}

std::vector<HomeTask> drawn_tasks(const std::string& name, std::size_t count, std::uint64_t seed) {
  std::vector<HomeTask> tasks;
  Rng rng(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& thing = rng.pick(kThings);
    Scene home = with_rooms(drawn_home(rng.below(4)), 1 + rng.below(3));
    home.id += name + std::to_string(i);
    tasks.push_back(home_task(name + std::to_string(i), home, thing,
                              rng.pick(kVerbs) + " a " + thing + " on the sofa" + rng.pick(kEnds)));
  }
  return tasks;
}

/// As print_of makes it of a folder.
SetFingerprint print_of_tasks(const std::vector<HomeTask>& tasks) {
  SetFingerprint print;
  print.folder = "other";
  for (const auto& task : tasks) {
    print.home_keys.insert(home_key_of(task.home));
    print.compared.tasks.push_back({task.record.id, print.compared.homes.size(), print_of_goal(task.record.goal_tree),
                                    print_of_text(task.record.instruction)});
    print.compared.homes.push_back({task.home.id, std::make_shared<HomeFingerprint>(print_of_home(task.home))});
  }
  return print;
}

/// The kinds of what is wrong with tasks of which `other` has the second ones, without those of the seed.
std::vector<ProblemKind> leaks(const std::vector<HomeTask>& own, const std::vector<HomeTask>& other) {
  LeakSearch search(print_of_tasks(other));
  const Knowledge nothing_known(Simulator::Ai2thor, {}, {}, {}, {}, {});
  for (const auto& task : own) {
    TaskReading reading;
    reading.name = task.record.id;
    reading.where = "tasks.jsonl:1";
    reading.record = task.record;
    search.add(reading, facts_of(task.record, task.home, task.home, {}, nothing_known),
               search.nearest(reading, task.home));
  }
  std::vector<ProblemKind> kinds;
  for (const auto& problem : search.problems(1).take()) kinds.push_back(problem.kind);
  return kinds;
}

const HomeTask kTask = home_task("one", drawn_home(1), "Mug", "Put a mug on the sofa.");

TEST(NearestTasks, AreThoseOfASearchThroughAll) {
  const auto own = drawn_tasks("own", 30, 1), others = drawn_tasks("other", 40, 2);
  const NearestTasks search(print_of_tasks(others).compared);
  for (const auto& task : own) {
    const auto found = search.of(task.record, task.home);
    ASSERT_TRUE(found);
    double home = 0, goal = 0, text = 0, nearness = 0;
    for (const auto& other : others) {
      const TaskLikeness one{
          likeness_of_homes(print_of_home(task.home), print_of_home(other.home)),
          likeness_of_goals(print_of_goal(task.record.goal_tree), print_of_goal(other.record.goal_tree)),
          likeness_of_texts(print_of_text(task.record.instruction), print_of_text(other.record.instruction), -1)};
      home = std::max(home, one.home);
      goal = std::max(goal, one.goal);
      text = std::max(text, one.text);
      nearness = std::max(nearness, one.nearness());
      const auto place = static_cast<std::size_t>(&other - others.data());
      for (const auto& nearest : {found->by_goal, found->by_text, found->by_all}) {
        if (place == nearest.place) {
          EXPECT_EQ(nearest.likeness.text, one.text);
        }
      }
    }
    EXPECT_EQ(found->home, home);
    EXPECT_EQ(found->by_goal.likeness.goal, goal);
    EXPECT_EQ(found->by_text.likeness.text, text);
    EXPECT_EQ(found->by_all.likeness.nearness(), nearness);
  }
}

TEST(Leaks, ThereAreNoneBetweenSetsOfTheirOwn) {
  const auto other = home_task("two", drawn_home(2), "Cup", "Place the cup on a sofa, please.");
  EXPECT_THAT(leaks({kTask}, {other}), IsEmpty());
  EXPECT_THAT(leaks({kTask}, {}), IsEmpty());
}

TEST(Leaks, AnotherHomeUnderTheSameNameIsNone) {
  HomeTask other = home_task("two", drawn_home(2), "Cup", "Place the cup on a sofa, please.");
  other.home.id = other.record.layout = kTask.home.id;
  EXPECT_THAT(leaks({kTask}, {other}), IsEmpty());
}

TEST(Leaks, AHomeUnderOtherNamesIsOne) {
  HomeTask copy = kTask;
  copy.home.id = copy.record.layout = "another";
  copy.record.instruction = "Wash the windows.";
  for (Room& room : copy.home.rooms) room.id += "_of_mine";
  for (std::size_t i = 0; i < copy.home.nodes.size(); ++i) copy.home.nodes.edit(i).id += "_of_mine";
  EXPECT_THAT(leaks({copy}, {kTask}), ElementsAre(ProblemKind::SharedLayout));
}

TEST(Leaks, AHomeThatWasChangedALittleIsOne) {
  for (const HomeEdit& edit : kHomeEdits) {
    HomeTask copy = kTask;
    copy.record.instruction = "Wash the windows.";
    copy.home = edit.made(kTask.home, Rng(4));
    copy.home.id = copy.record.layout = "another";
    const auto found = leaks({copy}, {kTask});
    ASSERT_EQ(found.size(), 1U) << edit.name;
    EXPECT_TRUE(found[0] == ProblemKind::SimilarHome || found[0] == ProblemKind::SharedLayout) << edit.name;
  }
}

TEST(Leaks, ATaskWithAnotherArticleIsOneInASimilarHomeOnly) {
  const Scene part = with_rooms_of(kTask.home, 1, drawn_home(17));  // one of five rooms is the same
  const auto copied = home_task("two", part, "Mug", "Put the mug on the sofa.");
  EXPECT_THAT(leaks({copied}, {kTask}), ElementsAre(ProblemKind::SimilarTask));
  const auto elsewhere = home_task("two", drawn_home(3), "Mug", "Put the mug on the sofa.");
  EXPECT_THAT(leaks({elsewhere}, {kTask}), IsEmpty());
  const auto other_goal = home_task("two", part, "Cup", "Put the mug on the sofa.");
  EXPECT_THAT(leaks({other_goal}, {kTask}), IsEmpty());
  const auto other_text = home_task("two", part, "Mug", "The sofa is where I would like to have that mug.");
  EXPECT_THAT(leaks({other_text}, {kTask}), IsEmpty());
}

TEST(Leaks, TheSameWordsAreOneInASimilarHomeWithTheSameGoalOnly) {
  const std::string& words = kTask.record.instruction;
  const Scene part = with_rooms_of(kTask.home, 1, drawn_home(17));
  EXPECT_THAT(leaks({home_task("two", part, "Mug", words)}, {kTask}), ElementsAre(ProblemKind::SimilarTask));
  EXPECT_THAT(leaks({home_task("two", drawn_home(3), "Mug", words)}, {kTask}), IsEmpty());
  EXPECT_THAT(leaks({home_task("two", part, "Cup", words)}, {kTask}), IsEmpty());
}

TEST(Leaks, TheReportCountsTextsThatTheOtherSetHas) {
  const NearestTasks search(print_of_tasks({kTask}).compared);
  LikenessCount count("other");
  const auto add = [&](const std::string& text) {
    const auto task = home_task("two", drawn_home(3), "Cup", text);
    count.add(task.record, *search.of(task.record, task.home), search.other());
  };
  add("put the mug on a sofa");  // the same but for articles
  add("Put a cup on the sofa.");
  EXPECT_EQ(count.report().shared_texts, 1);
}

TEST(Leaks, TheReportHasTheDistributionAndTheClosestPairs) {
  const auto own = drawn_tasks("own", 30, 1), others = drawn_tasks("other", 40, 2);
  const NearestTasks search(print_of_tasks(others).compared);
  LikenessCount count("other");
  for (const auto& task : own) count.add(task.record, *search.of(task.record, task.home), search.other());
  count.add(own[0].record, *search.of(own[0].record, own[0].home), search.other());  // a second task in one home
  const auto report = count.report();
  for (const auto& measure : report.measures) {
    SCOPED_TRACE(measure.name);
    EXPECT_EQ(measure.values.size(), measure.name == "homes" ? 30U : 31U);
    ASSERT_EQ(measure.closest.size(), 10U);
    for (std::size_t i = 0; i < 10; ++i)
      EXPECT_EQ(measure.closest[i].value, measure.values[measure.values.size() - 1 - i]);
    EXPECT_EQ(measure.quantile(0), measure.values.front());
    EXPECT_EQ(measure.quantile(0.5), measure.values[(measure.values.size() - 1) / 2]);
    EXPECT_EQ(measure.quantile(1), measure.values.back());
  }
  EXPECT_THAT(report.measures[0].closest[0].own, HasSubstr("own"));
  EXPECT_THAT(report.measures[0].closest[0].other, HasSubstr("other"));
}

}  // namespace
}  // namespace unietp::testing
