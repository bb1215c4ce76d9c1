// An agent walks through generated homes, by the actions that demonstrations are made of: from the entrance to every
// room and every receptacle, of which those in something shut are opened up first.
#include <cstdio>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grounding/floor_plan.h"
#include "grounding/layout_library.h"
#include "homes.h"
#include "simulation/world.h"

namespace unietp {
namespace {

constexpr std::uint64_t kHomes = 30, kSeed = 29;

bool is_receptacle(const Knowledge& knowledge, const std::string& category) {
  return !knowledge.placements_at(category, Predicate::On).empty() ||
         !knowledge.placements_at(category, Predicate::Inside).empty();
}

class EveryWalk : public ::testing::TestWithParam<Simulator> {
 protected:
  /// Performs the action; says so when it fails.
  bool move(World& world, ActionType type, const std::string& id) {
    ++moves_;
    const ActionResult result = world.step({type, {id}});
    if (!result.success)
      failed_.push_back(world.scene().id + ": " + to_text(Action{type, {id}}) +
                        " fails: " + std::string(name_of(result.failure)));
    return result.success;
  }

  /// To the receptacle, and into what is shut around it first, which is shut again.
  void visit(World& world, const std::string& id) {
    std::vector<std::string> opened;
    bool on_the_way = true;
    for (std::string door = world.closed_around(id); on_the_way && !door.empty(); door = world.closed_around(id)) {
      on_the_way = move(world, ActionType::GoTo, door) && move(world, ActionType::Open, door);
      if (on_the_way) opened.push_back(door);
    }
    if (on_the_way) move(world, ActionType::GoTo, id);
    for (; !opened.empty(); opened.pop_back()) {
      move(world, ActionType::GoTo, opened.back());
      move(world, ActionType::Close, opened.back());
    }
  }

  int moves_ = 0;
  std::vector<std::string> failed_;
};

TEST_P(EveryWalk, FromTheEntranceToEveryRoomAndReceptacleOfThirtyHomesHasNoFailedMove) {
  const auto style = style_of(GetParam());
  ASSERT_TRUE(style);
  int rooms = 0, furniture = 0, things = 0;
  std::vector<std::string> failed_at_things;
  for (std::uint64_t n = 0; n < kHomes; ++n) {
    const auto home = training_layout(style->recipe, style->knowledge, style->profile, n, kSeed);
    ASSERT_TRUE(home) << n;
    const auto entrance = entrance_of(home->rooms);
    ASSERT_TRUE(entrance) << home->id;
    EXPECT_LT((home->agent.position - entrance->at).norm(), 1) << home->id;
    auto world = World::create(*home, style->knowledge, style->profile);
    ASSERT_TRUE(world) << format(world.error());
    for (const Room& room : home->rooms) rooms += move(*world, ActionType::GoTo, room.id) ? 1 : 0;
    for (const bool movable : {false, true}) {
      if (movable) {
        EXPECT_THAT(failed_, ::testing::IsEmpty());
      }
      for (const Node& node : home->nodes) {
        if (node.movable != movable || !is_receptacle(style->knowledge, node.category)) continue;
        visit(*world, node.id);
        ++(movable ? things : furniture);
      }
    }
    std::move(failed_.begin(), failed_.end(), std::back_inserter(failed_at_things));
    failed_.clear();
  }
  std::printf("%s: %d moves to %d rooms, %d pieces of furniture and %d things that hold something\n",
              std::string(name_of(GetParam())).c_str(), moves_, rooms, furniture, things);
  EXPECT_GT(rooms, 100);
  EXPECT_GT(furniture, 500);
  EXPECT_GT(things, 200);
  EXPECT_THAT(failed_at_things, ::testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Simulators, EveryWalk, ::testing::ValuesIn(kSimulators),
                         [](const auto& tested) { return std::string(name_of(tested.param)); });

}  // namespace
}  // namespace unietp
