#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expert/footing.h"
#include "tests/expert/house.h"

// Where things go when the nearest way does not lead there.
namespace unietp::testing {
namespace {

using ::testing::HasSubstr;

struct Placing : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  Profile profile = house_profile();

  std::string plan(const std::string& text, const Scene& start) const {
    const Formula formula = goal(text);
    auto result = demonstrate(formula, start, knowledge, profile, {});
    if (const auto* rejection = std::get_if<Rejection>(&result)) return rejection->reason + ": " + rejection->detail;
    EXPECT_EQ(replay(formula, start, std::get<Demonstration>(result), knowledge, profile), "");
    return plan_of(std::get<Demonstration>(result));
  }
};

/// The house with only some of its small things.
Scene house_with(const std::vector<std::string>& movable) {
  Scene scene = house();
  erase_if(scene.nodes, [&](const Node& node) {
    return node.movable && std::find(movable.begin(), movable.end(), node.id) == movable.end();
  });
  return scene;
}

TEST_F(Placing, PutsAThingBesideItsNeighbourAndNotOnlyOnTheSameTable) {
  const Scene scene = at_rest(house_with({"lamp_1", "potato_1"}));
  const std::string steps = plan("(exists (?x - Lamp) (exists (?y - Potato) (at-end (next_to ?x ?y))))", scene);
  EXPECT_THAT(steps, HasSubstr("place_on(diningtable_1)"));
}

TEST_F(Placing, TakesTheNeighbourToWhereThereIsRoomBesideIt) {
  Scene scene = house_with({"lamp_1", "potato_1"});
  erase_if(scene.nodes, [](const Node& node) { return node.id == "diningtable_1"; });
  // On a stool that is hardly larger than itself.
  Node& stool = add(scene, knowledge, "sidetable_3", "SideTable", 2.75, 1.25, 0);
  stool.size = {0.12, 0.12, 0.6};
  edit_node(scene, "potato_1")->pose.position.z() = 0.631;
  profile.actions[static_cast<std::size_t>(ActionType::Drop)] = false;
  const std::string steps =
      plan("(exists (?x - Lamp) (exists (?y - Potato) (at-end (next_to ?x ?y))))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("pick_up(potato_1)"));
}

/// A table of four metres, all of it taken but for one end.
Scene with_a_long_table(const Knowledge& knowledge) {
  Scene scene = house_with({"plate_1"});
  edit_node(scene, "plate_1")->pose.position = Vec3(2.3, 3.5, 0.914);  // on the counter
  erase_if(scene.nodes, [](const Node& node) { return node.id == "diningtable_1"; });
  add(scene, knowledge, "diningtable_1", "DiningTable", 2.5, 1.5, 0).size = {4.0, 0.8, 0.75};
  Node& block = add(scene, knowledge, "countertop_2", "CounterTop", 2.325, 1.5, 0.76);
  block.size = {3.65, 0.6, 0.3};
  block.pose.position.z() = 0.76 + 0.15;
  return at_rest(std::move(scene));
}

TEST_F(Placing, WalksAlongATableToWhereThereIsRoom) {
  const std::string text = "(exists (?x - Plate) (exists (?y - DiningTable) (at-end (on ?x ?y))))";
  const Scene scene = with_a_long_table(knowledge);
  auto world = World::create(scene, knowledge, profile);
  ASSERT_TRUE(world);
  for (const auto& [type, id] : {std::pair(ActionType::GoTo, "plate_1"), std::pair(ActionType::PickUp, "plate_1"),
                                 std::pair(ActionType::GoTo, "dresser_1")})
    ASSERT_TRUE(world->step({type, {id}}).success);
  const Action put{ActionType::PlaceOn, {"diningtable_1"}};
  EXPECT_FALSE(World(*world).step(put).success) << "at the other end";
  const auto way = way_to_do(*world, put, "diningtable_1", {});
  ASSERT_TRUE(way);
  for (const Action& step : *way) EXPECT_TRUE(world->step(step).success) << to_text(step);
  EXPECT_TRUE(world->step(put).success);
  EXPECT_THAT(plan(text, scene), HasSubstr("place_on(diningtable_1)"));
}

TEST_F(Placing, CarriesAwayWhatTakesUpTheOnlyPlace) {
  Scene scene = house_with({"plate_1"});
  erase_if(scene.nodes, [](const Node& node) { return node.id == "sidetable_2"; });
  int count = 0;
  for (const double dx : {-0.15, 0.15}) {
    for (const double dy : {-0.15, 0.15})
      add(scene, knowledge, "box_" + std::to_string(++count), "Box", 8.5 + dx, 3.5 + dy, 0.601);
  }
  const std::string steps =
      plan("(exists (?x - Plate) (exists (?y - SideTable) (at-end (on ?x ?y))))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("pick_up(box_"));
  EXPECT_THAT(steps, HasSubstr("place_on(sidetable_1)"));
}

TEST_F(Placing, OpensElsewhereWhatCannotOpenWhereItStands) {
  Scene scene = house_with({"box_1"});
  Node& shelf = add(scene, knowledge, "countertop_2", "CounterTop", 1.95, 1.2, 0);
  shelf.size = {1.4, 0.6, 0.3};
  shelf.pose.position.z() = 1.0 + 0.15;  // right above its lid
  const std::string steps = plan("(exists (?x - Box) (at-end (open ?x)))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("pick_up(box_1)"));
  EXPECT_THAT(steps, HasSubstr("open(box_1)"));
}

TEST_F(Placing, TakesWhatIsInTheWayOfADoorOutOfIt) {
  Scene scene = house_with({"box_1"});
  Node& box = *edit_node(scene, "box_1");
  box.pose.position = Vec3(1.5, 3.34, 0.902 + 0.1);  // before the microwave, on the same counter
  const std::string steps = plan("(exists (?x - Microwave) (at-end (open ?x)))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("pick_up(box_1)"));
  EXPECT_THAT(steps, HasSubstr("open(microwave_1)"));
}

TEST_F(Placing, LeavesTheCornerBehindAnOpenDoor) {
  // Counters on three sides of who stands before the fridge; its open door is the fourth.
  Scene scene = house_with({"apple_1"});
  erase_if(scene.nodes, [](const Node& node) {
    return node.id == "sink_1" || node.id == "diningtable_1" || node.id == "countertop_1" || node.id == "microwave_1";
  });
  edit_node(scene, "fridge_1")->pose.position.x() = 3.2;
  edit_node(scene, "apple_1")->pose.position = Vec3(3.2, 3.55, 0.95);
  add(scene, knowledge, "countertop_2", "CounterTop", 3.8, 2.25, 0).size = {0.5, 2.1, 0.9};
  add(scene, knowledge, "countertop_3", "CounterTop", 3.2, 1.2, 0).size = {1.7, 0.5, 0.9};
  add(scene, knowledge, "countertop_4", "CounterTop", 2.6, 1.95, 0).size = {0.5, 1.0, 0.9};
  set_state(scene, "fridge_1", Predicate::Open);
  scene.agent.position = {3.2, 2.0};
  const std::string steps =
      plan("(exists (?x - Apple) (exists (?y - SideTable) (at-end (on ?x ?y))))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("close(fridge_1)"));
  EXPECT_THAT(steps, HasSubstr("place_on(sidetable_"));
}

TEST_F(Placing, ShutsABoxThatDoesNotFitWithItsLidUp) {
  Scene scene = house_with({"box_1", "apple_1"});
  add(scene, knowledge, "countertop_2", "CounterTop", 8.5, 3.5, 0).size = {0.6, 0.6, 0.3};
  Node& above = scene.nodes.edit(scene.nodes.size() - 1);
  above.pose.position.z() = 0.6 + 0.26 + 0.15;  // a quarter of a metre over the table
  add(scene, knowledge, "countertop_3", "CounterTop", 8.5, 0.5, 0).size = {0.6, 0.6, 0.3};
  scene.nodes.edit(scene.nodes.size() - 1).pose.position.z() = 0.6 + 0.26 + 0.15;
  const std::string steps = plan(
      "(exists (?x - Apple) (exists (?b - Box) (exists (?y - SideTable) (at-end (and (inside ?x ?b) (on ?b ?y))))))",
      at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("close(box_1)"));
}

TEST_F(Placing, BringsAThingIntoARoomOnWhateverStandsThere) {
  profile.actions[static_cast<std::size_t>(ActionType::Drop)] = false;
  Scene scene = house_with({});
  add(scene, knowledge, "applesliced_1", "AppleSliced", 2.5, 1.0, 0.751);  // usual on nothing
  const std::string steps = plan("(exists (?x - AppleSliced) (at-end (exists (?r - living_room) (in_room ?x ?r))))",
                                 at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("place_on(sidetable_"));
}

TEST_F(Placing, NothingIsFoundWhereNoSpotIsFree) {
  Scene scene = house_with({"mug_3"});
  Node& block = add(scene, knowledge, "countertop_2", "CounterTop", 8.5, 3.5, 0.61);
  block.size = {0.6, 0.6, 0.3};
  block.pose.position.z() = 0.61 + 0.15;
  auto world = World::create(at_rest(std::move(scene)), knowledge, profile);
  ASSERT_TRUE(world);
  ASSERT_TRUE(world->step({ActionType::GoTo, {"mug_3"}}).success);
  EXPECT_TRUE(world->free_spots("sidetable_2", false).empty()) << "with empty hands";
  ASSERT_TRUE(world->step({ActionType::PickUp, {"mug_3"}}).success);
  EXPECT_FALSE(world->free_spots("sidetable_2", false).empty());
  EXPECT_TRUE(world->free_spots("sidetable_1", false).empty());
  EXPECT_FALSE(way_to_do(*world, {ActionType::PlaceOn, {"sidetable_1"}}, "sidetable_1", {}));
}

}  // namespace
}  // namespace unietp::testing
