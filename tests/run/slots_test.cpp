#include "run/slots.h"

#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../resources/committed.h"
#include "dataset/configuration_json.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

Template small(const std::string& name, Split split, std::vector<Simulator> simulators) {
  Template source;
  source.name = name;
  source.split = split;
  source.simulators = std::move(simulators);
  return source;
}

Resources three_templates() {
  const std::vector<Simulator> all(kSimulators.begin(), kSimulators.end());
  Resources resources = committed();
  resources.templates = {small("a", Split::Atomic, all), small("b", Split::Atomic, all),
                         small("c", Split::Logical, {Simulator::Ai2thor})};
  return resources;
}

TEST(PlanSlots, SharesSimulatorsAndSplitsEquallyForAnySeed) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    RunConfiguration configuration;
    configuration.seed = seed;
    configuration.count = 48;
    const auto slots = plan_slots(configuration, three_templates());
    ASSERT_TRUE(slots) << format(slots.error());
    std::map<Simulator, int> by_simulator;
    std::map<std::pair<Simulator, Split>, int> by_kind;
    for (const auto& slot : *slots) {
      ++by_simulator[slot.simulator];
      ++by_kind[{slot.simulator, slot.split}];
      for (const auto index : slot.templates) EXPECT_LT(index, 3U);
    }
    for (const auto& [simulator, count] : by_simulator) EXPECT_EQ(count, 12);
    // AI2-THOR has atomic, logical and the two refined splits; the others lack a logical template.
    EXPECT_EQ((by_kind[{Simulator::Ai2thor, Split::Logical}]), 3);
    EXPECT_EQ((by_kind[{Simulator::Habitat, Split::Logical}]), 0);
    EXPECT_EQ((by_kind[{Simulator::Habitat, Split::Atomic}]), 4);
  }
}

TEST(PlanSlots, ARefinedSplitTakesAnyTemplateAndTheOthersTheirOwn) {
  RunConfiguration configuration;
  configuration.count = 4;
  configuration.simulators = {Simulator::Ai2thor};
  const auto slots = plan_slots(configuration, three_templates());
  ASSERT_TRUE(slots);
  for (const auto& slot : *slots) {
    const std::map<Split, std::vector<std::size_t>> expected{{Split::Atomic, {0, 1}},
                                                             {Split::Logical, {2}},
                                                             {Split::InstanceGrounding, {0, 1, 2}},
                                                             {Split::Linguistic, {0, 1, 2}}};
    EXPECT_EQ(slot.templates, expected.at(slot.split)) << name_of(slot.split);
  }
}

TEST(PlanSlots, EqualSeedsPlanEqually) {
  RunConfiguration configuration;
  const auto first = plan_slots(configuration, three_templates());
  const auto second = plan_slots(configuration, three_templates());
  ASSERT_TRUE(first && second);
  for (std::size_t i = 0; i < first->size(); ++i) EXPECT_EQ((*first)[i].templates, (*second)[i].templates);
}

TEST(PlanSlots, DealsTemplatesLevelWhereverTheirSlotsAllow) {
  RunConfiguration configuration;
  configuration.count = 48;
  const auto slots = plan_slots(configuration, three_templates());
  ASSERT_TRUE(slots) << format(slots.error());
  std::map<std::size_t, int> dealt;
  for (const auto& slot : *slots) ++dealt[slot.templates[slot.first_template]];
  EXPECT_EQ(dealt[2], 9);  // of the 48, no more fit "c"
  EXPECT_NEAR(dealt[0], dealt[1], 1);
}

TEST(PlanSlots, TheBenchmarkBeginsWithEachTemplateOfTheLibraryWhateverItsSeed) {
  auto configuration =
      read_configuration(std::filesystem::path(UNIETP_SOURCE_DIR) / "data" / "runs" / "benchmark.json");
  ASSERT_TRUE(configuration) << format(configuration.error());
  for (configuration->seed = 1; configuration->seed < 20; ++configuration->seed) {
    const auto slots = plan_slots(*configuration, committed());
    ASSERT_TRUE(slots) << format(slots.error());
    std::vector<int> dealt(committed().templates.size(), 0);
    for (const auto& slot : *slots) ++dealt[slot.templates[slot.first_template]];
    for (std::size_t i = 0; i < dealt.size(); ++i)
      EXPECT_GE(dealt[i], 2) << committed().templates[i].name << ", seed " << configuration->seed;
  }
}

TEST(PlanSlots, RefusesAnUnknownTemplateAndASplitThatNoneMakes) {
  RunConfiguration configuration;
  configuration.templates = {"d"};
  const auto unknown = plan_slots(configuration, three_templates());
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, HasSubstr("a, b, c"));
  configuration.templates = {"c"};
  const auto nowhere = plan_slots(configuration, three_templates());
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, HasSubstr("virtualhome"));
  configuration.templates = {};
  configuration.splits = {Split::Compositional};
  const auto none = plan_slots(configuration, three_templates());
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("compositional"));
}

TEST(PlanSlots, MeetsQuotasOfBothKindsAndSpreadsThemEvenly) {
  RunConfiguration configuration;
  configuration.quotas = {{{Split::Atomic, 30}, {Split::Logical, 10}},
                          {{Simulator::Ai2thor, 24}, {Simulator::Habitat, 16}}};
  configuration.count = 40;
  const auto slots = plan_slots(configuration, three_templates());
  ASSERT_TRUE(slots) << format(slots.error());
  ASSERT_EQ(slots->size(), 40U);
  std::map<std::pair<Simulator, Split>, int> by_kind, in_first_half;
  for (const auto& slot : *slots) {
    ++by_kind[{slot.simulator, slot.split}];
    if (slot.index < 20) ++in_first_half[{slot.simulator, slot.split}];
  }
  // Only AI2-THOR has a logical template, so all of that split is its own.
  EXPECT_EQ((by_kind[{Simulator::Ai2thor, Split::Logical}]), 10);
  EXPECT_EQ((by_kind[{Simulator::Ai2thor, Split::Atomic}]), 14);
  EXPECT_EQ((by_kind[{Simulator::Habitat, Split::Atomic}]), 16);
  for (const auto& [kind, count] : by_kind) EXPECT_NEAR(in_first_half[kind], count / 2.0, 1);
}

TEST(PlanSlots, RefusesQuotasThatNoTemplatesCanMeet) {
  RunConfiguration configuration;
  configuration.quotas = {{{Split::Logical, 10}}, {{Simulator::Habitat, 10}}};
  configuration.count = 10;
  const auto slots = plan_slots(configuration, three_templates());
  ASSERT_FALSE(slots);
  EXPECT_THAT(slots.error().message, HasSubstr("cannot be met"));
}

TEST(PlanSlots, LeavesOutTemplates) {
  RunConfiguration configuration;
  configuration.count = 12;
  configuration.without = {"a"};
  const auto slots = plan_slots(configuration, three_templates());
  ASSERT_TRUE(slots) << format(slots.error());
  for (const auto& slot : *slots) EXPECT_THAT(slot.templates, ::testing::Not(::testing::Contains(0U)));
  configuration.without = {"z"};
  EXPECT_FALSE(plan_slots(configuration, three_templates()));
}

}  // namespace
}  // namespace unietp
