// What an agent of M2 or M3 is shown of a home.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "expert/window.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

TEST(EpisodeWindow, ShowsNothingMovableThatIsNotInViewAndNoStateOfFurnitureOutOfView) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene scene = house();
  set_state(scene, "television_1", Predicate::PowerOn);
  const Scene start = at_rest(std::move(scene));
  const Formula wanted = goal("(exists (?x - Mug) (at-end (held ?x)))");
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  EpisodeWindow window(executions, Mode::M2);
  for (const Node& node : window.known_scene().nodes) {
    EXPECT_FALSE(node.movable) << node.id;
    EXPECT_FALSE(node.states.has(Predicate::PowerOn)) << node.id;
  }
  EXPECT_TRUE(window.known_scene().edges.empty());
  const auto& visible = executions.world().visible();
  EXPECT_EQ(window.view().size(), visible.size());
  for (const Node& node : window.view()) {
    EXPECT_TRUE(std::any_of(visible.begin(), visible.end(), [&](const auto& object) { return object.id == node.id; }));
  }
}

TEST(EpisodeWindow, TellsInM3OfRoomsAndShowsWhatIsInThePictureByNamesOfItsOwn) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = at_rest(house());
  const Formula wanted = goal("(exists (?x - Mug) (at-end (held ?x)))");
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  EpisodeWindow window(executions, Mode::M3);
  EXPECT_TRUE(window.known_scene().nodes.empty());
  EXPECT_EQ(window.known_scene().rooms, start.rooms);
  std::map<std::string, int> of_category;
  const std::vector<Node> seen = window.view();
  EXPECT_FALSE(seen.empty());
  EXPECT_LE(seen.size(), executions.world().pictured().size());
  for (Node node : seen) {
    const std::string stem = node.id.substr(0, node.id.rfind('_'));
    EXPECT_EQ(node.id, stem + "_" + std::to_string(++of_category[stem]));
    const auto same = std::find_if(start.nodes.begin(), start.nodes.end(), [&](const Node& there) {
      node.id = there.id;
      return node == there;
    });
    ASSERT_NE(same, start.nodes.end());
    EXPECT_TRUE(executions.world().unique_box(same->id));
  }
  EXPECT_FALSE(window.act({ActionType::GoTo, {"a_9"}}).success) << "nothing was called so";
  EXPECT_TRUE(window.act({ActionType::GoTo, {start.rooms.front().id}}).success);
  const std::vector<Node> later = window.view();  // what is seen again keeps its name
  for (const Node& node : later) {
    const auto before = std::find_if(seen.begin(), seen.end(), [&](const Node& one) { return one.id == node.id; });
    EXPECT_TRUE(before == seen.end() || *before == node) << node.id;
  }
}

}  // namespace
}  // namespace unietp::testing
