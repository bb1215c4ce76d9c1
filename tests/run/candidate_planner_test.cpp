#include "run/candidate_planner.h"

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../resources/committed.h"
#include "run/category_weights.h"

namespace unietp {
namespace {

RunConfiguration small_homes(int count) {
  RunConfiguration configuration;
  configuration.count = count;
  configuration.rooms = 5;
  configuration.objects = 25;
  return configuration;
}

std::vector<int> all_of(const std::vector<TaskSlot>& slots) {
  std::vector<int> open;
  for (const auto& slot : slots) open.push_back(slot.index);
  return open;
}

void count(const CandidatePlan& plan, const TaskSlot& slot, Frequencies& counts) {
  const auto& source = committed().templates[plan.source];
  const std::string simulator(name_of(slot.simulator));
  counts.add({Dimension::Template, source.name});
  counts.add({Dimension::Scene, simulator + std::to_string(plan.home)});
  if (!plan.binding) return;
  for (std::size_t i = 0; i < plan.binding->size(); ++i)
    counts.add({dimension_of(source.parameters[i], source), simulator + (*plan.binding)[i].second});
}

/// What one round of all slots is worth when it balances, and when each slot is planned alone and so knows of no
/// frequency: as many equally frequent values, by dimension.
struct Worth {
  std::map<Dimension, double> balanced, uniform;
};
Worth worth_of(const RunConfiguration& configuration) {
  const auto slots = plan_slots(configuration, committed());
  EXPECT_TRUE(slots);
  LayoutPool layouts(configuration, committed(), 6);
  CandidatePlanner balancing(configuration, committed(), layouts, *slots);
  CandidatePlanner blind(configuration, committed(), layouts, *slots);
  Frequencies balanced, uniform;
  for (const auto& plan : balancing.round(all_of(*slots), 0, {}))
    count(plan, (*slots)[static_cast<std::size_t>(plan.slot)], balanced);
  for (const auto& slot : *slots) {
    for (const auto& plan : blind.round({slot.index}, 0, {})) count(plan, slot, uniform);
  }
  Worth worth;
  for (const auto& spread : balanced.spreads()) worth.balanced[spread.dimension] = spread.effective;
  for (const auto& spread : uniform.spreads()) worth.uniform[spread.dimension] = spread.effective;
  return worth;
}

TEST(CandidatePlanner, PrefersWhatTheHomeHasHoweverOftenItsRoomsWereUsed) {
  const auto homes = small_homes(1);
  LayoutPool layouts(homes, committed(), 1);
  const auto& layout = layouts.layout(Simulator::Ai2thor, 0);
  ASSERT_TRUE(layout);
  const auto source = std::find_if(committed().templates.begin(), committed().templates.end(),
                                   [](const Template& one) { return one.name == "place-one-on"; });
  ASSERT_NE(source, committed().templates.end());
  const RoomTypes rooms = room_types_in(*layout);
  for (const int used : {0, 1000}) {
    Frequencies counts;
    for (const Room& room : layout->home.scene.rooms) counts.add({Dimension::Room, "ai2thor/" + room.type}, used);
    const auto weight = weight_in(*layout, *source, Split::Atomic, counts, &rooms);
    double least_there = 1, most_lacking = 0;
    for (const Category& category : committed().backend(Simulator::Ai2thor).knowledge.categories()) {
      if (!category.movable) continue;
      const double wanted = weight(source->parameters.front(), category.name);
      if (layout->home.places.of(category.name).empty()) {
        most_lacking = std::max(most_lacking, wanted);
      } else {
        least_there = std::min(least_there, wanted);
      }
    }
    EXPECT_GT(most_lacking, 0);
    EXPECT_GT(least_there, 1000 * most_lacking) << used;
  }
}

TEST(CandidatePlanner, IsFlatterThanUniformDrawsOverReceptacles) {
  auto worth = worth_of(small_homes(240));
  EXPECT_GT(worth.balanced[Dimension::Receptacle], 1.02 * worth.uniform[Dimension::Receptacle]);
}

/// With all templates, level templates also mean more tasks whose only sink or stove is bound each time; so categories
/// are compared where templates leave the choice.
TEST(CandidatePlanner, IsFlatterThanUniformDrawsOverCategoriesAndHomes) {
  auto configuration = small_homes(60);
  configuration.simulators = {Simulator::Ai2thor};
  configuration.templates = {"place-one-on"};
  configuration.splits = {Split::Atomic};
  auto worth = worth_of(configuration);
  for (const auto dimension : {Dimension::Category, Dimension::Receptacle})
    EXPECT_GT(worth.balanced[dimension], 1.05 * worth.uniform[dimension]) << name_of(dimension);
  EXPECT_GT(worth.balanced[Dimension::Scene], 0.95 * 6);  // of six homes, which uniform draws level almost as well
}

TEST(CandidatePlanner, EqualRoundsGiveEqualPlansWhoeverDrewTheHomes) {
  const auto configuration = small_homes(24);
  const auto slots = plan_slots(configuration, committed());
  ASSERT_TRUE(slots);
  LayoutPool forwards(configuration, committed(), 2), backwards(configuration, committed(), 2);
  for (const auto simulator : kSimulators) {
    for (int i = backwards.size(simulator); i-- > 0;) (void)backwards.layout(simulator, i);
  }
  CandidatePlanner first(configuration, committed(), forwards, *slots),
      second(configuration, committed(), backwards, *slots);
  Frequencies taken;
  taken.add({Dimension::Template, committed().templates[0].name});
  for (int attempt = 0; attempt < 5; ++attempt)
    EXPECT_EQ(first.round(all_of(*slots), attempt, taken), second.round(all_of(*slots), attempt, taken)) << attempt;
}

RunConfiguration one_atomic_slot() {
  auto configuration = small_homes(1);
  configuration.simulators = {Simulator::Habitat};
  configuration.splits = {Split::Atomic};
  return configuration;
}

TEST(CandidatePlanner, ASlotKeepsTheTemplateDealtToItForAWhileAndThenTriesAnother) {
  const auto configuration = one_atomic_slot();
  const auto slots = plan_slots(configuration, committed());
  ASSERT_TRUE(slots);
  LayoutPool layouts(configuration, committed(), 1);
  CandidatePlanner planner(configuration, committed(), layouts, *slots);
  const auto choices = slots->front().templates.size();
  ASSERT_GT(choices, 2U);
  std::set<std::size_t> seen;
  int attempt = 0;
  for (std::size_t turn = 0; turn < choices; ++turn) {
    std::set<std::size_t> now;
    const int more = turn == 0 ? CandidatePlanner::kAttemptsForUnused : 0;
    for (int i = 0; i < CandidatePlanner::kAttemptsPerTemplate + more; ++i)
      now.insert(planner.round({0}, attempt++, {}).front().source);
    EXPECT_EQ(now.size(), 1U);
    if (turn == 0) {
      EXPECT_EQ(*now.begin(), slots->front().templates[slots->front().first_template]);
    }
    EXPECT_TRUE(seen.insert(*now.begin()).second) << "a template comes again before all had their turn";
  }
}

TEST(CandidatePlanner, ASlotKeepsItsFirstTemplateNoLongerOnceATaskHasIt) {
  const auto configuration = one_atomic_slot();
  const auto slots = plan_slots(configuration, committed());
  ASSERT_TRUE(slots);
  LayoutPool layouts(configuration, committed(), 1);
  CandidatePlanner planner(configuration, committed(), layouts, *slots);
  const std::size_t first = slots->front().templates[slots->front().first_template];
  Frequencies taken;
  taken.add({Dimension::Template, committed().templates[first].name});
  for (int attempt = 0; attempt < CandidatePlanner::kAttemptsPerTemplate; ++attempt)
    EXPECT_EQ(planner.round({0}, attempt, taken).front().source, first);
  EXPECT_NE(planner.round({0}, CandidatePlanner::kAttemptsPerTemplate, taken).front().source, first);
}

TEST(CandidatePlanner, ASlotTakesAnotherTemplateWhenItsOwnIsDropped) {
  const auto configuration = one_atomic_slot();
  const auto slots = plan_slots(configuration, committed());
  ASSERT_TRUE(slots);
  LayoutPool layouts(configuration, committed(), 1);
  CandidatePlanner planner(configuration, committed(), layouts, *slots);
  const auto first = planner.round({0}, 0, {}).front().source;
  planner.drop_template(0);
  EXPECT_NE(planner.round({0}, 1, {}).front().source, first);
}

TEST(CandidatePlanner, ASlotTakesATemplateThatNoTaskHasBeforeAnyOther) {
  const auto configuration = one_atomic_slot();
  const auto slots = plan_slots(configuration, committed());
  ASSERT_TRUE(slots);
  const auto& choices = slots->front().templates;
  ASSERT_GT(choices.size(), 3U);
  for (const std::size_t lacking : choices) {
    if (lacking == choices[slots->front().first_template]) continue;
    LayoutPool layouts(configuration, committed(), 1);
    CandidatePlanner planner(configuration, committed(), layouts, *slots);
    Frequencies taken;
    for (const std::size_t source : choices)
      if (source != lacking) taken.add({Dimension::Template, committed().templates[source].name});
    (void)planner.round({0}, 0, taken);
    planner.drop_template(0);
    EXPECT_EQ(planner.round({0}, 1, taken).front().source, lacking);
  }
}

TEST(CandidatePlanner, ASlotTakesAnotherTemplateWhenNoHomeOffersItABinding) {
  auto configuration = small_homes(1);
  configuration.simulators = {Simulator::Ai2thor};
  configuration.splits = {Split::Atomic};
  configuration.sense = Grade::Senseless;
  configuration.binding = {{"A", "Book"}};  // can be put, but not switched
  const auto slots = plan_slots(configuration, committed());
  ASSERT_TRUE(slots);
  LayoutPool layouts(configuration, committed(), 2);
  CandidatePlanner planner(configuration, committed(), layouts, *slots);
  int without = 0;
  std::optional<std::size_t> futile;
  for (int attempt = 0; attempt < 12; ++attempt) {
    const auto plan = planner.round({0}, attempt, {}).front();
    if (futile) {
      EXPECT_NE(plan.source, *futile) << attempt;
    }
    futile = plan.binding ? std::nullopt : std::optional(plan.source);
    without += futile ? 1 : 0;
  }
  EXPECT_GT(without, 1);
}

TEST(CandidatePlanner, KeepsTheCategoriesThatWereGiven) {
  auto configuration = small_homes(4);
  configuration.simulators = {Simulator::Ai2thor};
  configuration.templates = {"place-one-on"};
  configuration.splits = {Split::Atomic};
  configuration.binding = {{"A", "Book"}};
  const auto slots = plan_slots(configuration, committed());
  ASSERT_TRUE(slots);
  LayoutPool layouts(configuration, committed(), 2);
  CandidatePlanner planner(configuration, committed(), layouts, *slots);
  for (const auto& plan : planner.round(all_of(*slots), 0, {})) {
    ASSERT_TRUE(plan.binding);
    EXPECT_EQ(plan.binding->front(), (std::pair<std::string, std::string>("A", "Book")));
  }
}

/// A kitchen with a table and nothing else: hardly any template finds in it what it is about.
TEST(CandidatePlanner, PassesOverTemplatesThatNoGivenHomeCanBind) {
  const auto configuration = [] {
    auto asked = small_homes(20);
    asked.simulators = {Simulator::Ai2thor};
    return asked;
  }();
  Resources resources = committed();
  Scene home;
  home.id = "bare";
  home.simulator = Simulator::Ai2thor;
  home.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}}};
  home.agent.position = {1, 1};
  Node table;
  table.id = "dining_table_1";
  table.category = "DiningTable";
  table.archetype = Archetype::Table;
  table.size = {1.2, 0.8, 0.75};
  table.mass = 30;
  table.pose = {{2.5, 2.5, 0.375}, Quat::Identity()};
  home.nodes.push_back(table);
  resources.homes = {home};
  const auto slots = plan_slots(configuration, resources);
  ASSERT_TRUE(slots);
  LayoutPool layouts(configuration, resources, 1);
  CandidatePlanner planner(configuration, resources, layouts, *slots);
  int other = 0;
  for (const auto& plan : planner.round(all_of(*slots), 0, {})) {
    const auto& slot = (*slots)[static_cast<std::size_t>(plan.slot)];
    EXPECT_TRUE(plan.binding) << committed().templates[plan.source].name;
    other += plan.source != slot.templates[slot.first_template] ? 1 : 0;
  }
  EXPECT_GT(other, 0);  // some of the templates dealt first cannot be bound here
}

}  // namespace
}  // namespace unietp
