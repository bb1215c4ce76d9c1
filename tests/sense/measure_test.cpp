#include "sense/measure.h"

#include <gtest/gtest.h>

#include "sense/swap_pool.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

Item item(const std::string& thing, const Role& role, const std::string& group) {
  return {{thing, role, 1, group, "metadata:activity_definitions"}, group};
}

TEST(Measure, HoldsOutWholeActivities) {
  int held = 0;
  for (int i = 0; i < 400; ++i) {
    const auto group = "activity " + std::to_string(i);
    held += is_held_out(item("cup", "wash", group)) ? 1 : 0;
    EXPECT_EQ(is_held_out(item("cup", "wash", group)), is_held_out(item("book", "on:desk", group)));
  }
  EXPECT_GT(held, 60);
  EXPECT_LT(held, 140);
}

TEST(Measure, JudgmentsOfHeldOutItemsCanBeLeftOut) {
  std::vector<Item> items;
  for (int i = 0; i < 40; ++i)
    items.push_back(item("cup", "in:role " + std::to_string(i), "activity " + std::to_string(i)));
  Judgments judgments{{{"cup", "wash"}, Grade::Usual}};
  for (const auto& one : items) judgments.emplace(std::pair(one.evidence.thing, one.evidence.role), Grade::Usual);
  const auto left = without_held_out(judgments, items);
  EXPECT_TRUE(left.contains({"cup", "wash"}));
  for (const auto& one : items) EXPECT_NE(left.contains({"cup", one.evidence.role}), is_held_out(one));
}

TEST(Measure, GradesOnlyWhatWasHeldOut) {
  std::vector<Item> items;
  int held = 0;
  for (int i = 0; i < 40; ++i) {
    items.push_back(item("cup", "in:kitchen_cabinet", "activity " + std::to_string(i)));
    held += is_held_out(items.back()) ? 1 : 0;
  }
  const auto& kinds = test::committed_sense().kinds();
  const auto figures = measure_held_out(items, kinds, {}, {}, {}, committed_knowledge(Simulator::Ai2thor));
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_EQ(static_cast<int>(figures.front().items.size()), held);
  // The others made it usual, with no judgment at all.
  EXPECT_EQ(figures.front().real[static_cast<std::size_t>(Grade::Senseless)], 0);
}

TEST(Measure, SwapsOneRoleForWhatIsPhysicallyPossible) {
  const auto& sense = test::committed_sense();
  const SwapPool pool(sense, committed_knowledge(Simulator::Ai2thor));
  const Evidence placed{"cup", "in:fridge", 1, "", "test"};
  for (std::uint64_t draw = 0; draw < 40; ++draw) {
    const auto other = pool.swapped(placed, SwapPool::By::Physics, draw);
    ASSERT_TRUE(other);
    EXPECT_NE(other->thing == placed.thing, other->role == placed.role);  // exactly one of the two
    EXPECT_FALSE(sense.kinds().is_a(other->thing, "place")) << other->thing;
  }
  const Evidence opened{"fridge", "open", 1, "", "test"};
  for (std::uint64_t draw = 0; draw < 20; ++draw) {
    const auto other = pool.swapped(opened, SwapPool::By::Physics, draw);
    ASSERT_TRUE(other);
    EXPECT_NE(other->thing, "fridge");
    EXPECT_NE(other->thing, "fruit");  // it has nothing to open
  }
}

}  // namespace
}  // namespace unietp
