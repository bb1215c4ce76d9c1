// What an agent of M2 or M3 is shown of a home.
#include <algorithm>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expert/recognition.h"
#include "expert/window.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

TEST(EpisodeWindow, ShowsNothingMovableThatIsNotInViewAndNeitherStateNorLookOfFurnitureOutOfView) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene scene = house();
  set_state(scene, "television_1", Predicate::PowerOn);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    Node& node = scene.nodes.edit(i);
    node.color = "red";
    node.material = "wood";
    node.asset = "model_" + std::to_string(i);
  }
  const Scene start = at_rest(std::move(scene));
  const Formula wanted = goal("(exists (?x - Mug) (at-end (held ?x)))");
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  EpisodeWindow window(executions, Mode::M2);
  for (const Node& node : window.known_scene().nodes) {
    EXPECT_FALSE(node.movable) << node.id;
    EXPECT_FALSE(node.states.has(Predicate::PowerOn)) << node.id;
    EXPECT_EQ(node.color + node.material + node.asset, "") << node.id;
  }
  EXPECT_TRUE(window.known_scene().edges.empty());
  const auto& visible = executions.world().visible();
  EXPECT_EQ(window.view().size(), visible.size());
  for (const Node& node : window.view()) {
    EXPECT_EQ(node.color, "red") << node.id;
    EXPECT_TRUE(std::any_of(visible.begin(), visible.end(), [&](const auto& object) { return object.id == node.id; }));
  }
}

TEST(EpisodeWindow, TellsInM3OfRoomsAndShowsByBoxesWhatIsInThePicture) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene home = house();
  for (std::size_t i = 0; i < home.nodes.size(); ++i) {
    home.nodes.edit(i).asset = "model_" + std::to_string(i);
    home.nodes.edit(i).mass = 7;
  }
  const Scene start = at_rest(std::move(home));
  const Formula wanted = goal("(exists (?x - Mug) (at-end (held ?x)))");
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  EpisodeWindow window(executions, Mode::M3);
  EXPECT_TRUE(window.known_scene().nodes.empty());
  EXPECT_EQ(window.known_scene().rooms, start.rooms);
  const std::vector<Node> seen = window.view();
  EXPECT_FALSE(seen.empty());
  EXPECT_LE(seen.size(), executions.world().pictured().size());
  for (const Node& node : seen) {
    const std::string id = window.meant().find(node.id)->second;
    const Node& there = *find_node(start, id);
    EXPECT_EQ(find_node(start, node.id), nullptr) << "an id of the home";
    EXPECT_EQ(node.pose, there.pose);
    EXPECT_EQ(node.states, there.states);
    EXPECT_TRUE(node.asset.empty());
    EXPECT_NE(node.mass, there.mass);
    const auto box = executions.world().unique_box(id);
    ASSERT_TRUE(box);
    EXPECT_TRUE(node.id.starts_with(std::to_string((*box)[0]) + " ")) << node.id;
  }
  EXPECT_FALSE(window.act({ActionType::GoTo, {"1 2 3 4"}}).success) << "nothing is there";
  EXPECT_TRUE(window.act({ActionType::GoTo, {start.rooms.front().id}}).success);
}

/// Shows what it is told to.
struct Staged : Window {
  const Scene& known_scene() const override { return rooms; }
  std::vector<Node> view() const override { return nodes; }
  const Agent& body() const override { return agent; }
  Outcome act(const Action& action) override {
    said.push_back(action);
    return {.success = true, .failure = Failure::None, .feedback = ""};
  }
  void show(std::string name, double x, const std::string& color = "red") {
    Node node;
    node.id = std::move(name);
    node.category = "Mug";
    node.movable = true;
    node.size = Vec3(0.1, 0.1, 0.1);
    node.pose.position = Vec3(x, 0, 1);
    node.color = color;
    nodes.push_back(std::move(node));
  }
  Scene rooms;
  std::vector<Node> nodes;
  Agent agent;
  std::vector<Action> said;
};

std::vector<std::string> names_in(const Recognition& recognition) {
  std::vector<std::string> names;
  for (const Node& node : recognition.view()) names.push_back(node.id);
  return names;
}

using ::testing::ElementsAre;

struct RecognitionInM3 : ::testing::Test {
  RecognitionInM3() {
    staged.show("0 0 9 9", 1);
    staged.show("20 0 29 9", 2);
    recognition.emplace(staged, Mode::M3);
  }
  Staged staged;
  std::optional<Recognition> recognition;
};

TEST_F(RecognitionInM3, CallsThingsByKindAndNumberAndPointsWithTheirBoxes) {
  EXPECT_THAT(names_in(*recognition), ElementsAre("mug_1", "mug_2"));
  (void)recognition->act({ActionType::GoTo, {"mug_2"}});
  EXPECT_THAT(staged.said, ElementsAre(Action{ActionType::GoTo, {"20 0 29 9"}}));
}

TEST_F(RecognitionInM3, KnowsThingsAgainByTheirPlaceWhateverTheWindowCallsThem) {
  staged.nodes.clear();
  staged.show("0 0 9 9", 2);
  staged.show("20 0 29 9", 1);
  recognition->look();
  EXPECT_THAT(names_in(*recognition), ElementsAre("mug_2", "mug_1"));
}

TEST_F(RecognitionInM3, TakesForNewWhatIsElsewhereOrLooksOtherwise) {
  staged.nodes.clear();
  staged.show("0 0 9 9", 1.5);
  staged.show("20 0 29 9", 2, "blue");
  recognition->look();
  EXPECT_THAT(names_in(*recognition), ElementsAre("mug_3", "mug_4"));
}

TEST_F(RecognitionInM3, FollowsWhatTheAgentTakesAndPutsDown) {
  (void)recognition->act({ActionType::PickUp, {"mug_2"}});
  staged.nodes.clear();
  staged.show("0 0 9 9", 1);
  staged.show("in hand 1", 5);
  staged.agent.held = {"in hand 1"};
  recognition->look();
  EXPECT_THAT(names_in(*recognition), ElementsAre("mug_1", "mug_2"));
  EXPECT_THAT(recognition->body().held, ElementsAre("mug_2"));

  (void)recognition->act({ActionType::PlaceOn, {"mug_1"}});
  Delta put_down;
  put_down.nodes.push_back(recognition->view().back());
  put_down.nodes.back().pose.position = Vec3(1.1, 0, 1);
  recognition->expect(put_down);
  staged.agent.held.clear();
  staged.nodes.clear();
  staged.show("0 0 9 9", 1.3);  // near where it should be
  staged.show("20 0 29 9", 1);
  recognition->look();
  EXPECT_THAT(names_in(*recognition), ElementsAre("mug_2", "mug_1"));
}

TEST_F(RecognitionInM3, NeverCallsAThingWhatOneThatIsGoneWasCalled) {
  Delta cut;
  cut.removed = {"mug_1"};
  recognition->expect(cut);
  staged.nodes.clear();
  staged.show("0 0 9 9", 1);
  recognition->look();
  EXPECT_THAT(names_in(*recognition), ElementsAre("mug_3"));
}

}  // namespace
}  // namespace unietp::testing
