#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expert/repositioning.h"
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
    if (const auto* rejection = std::get_if<Rejection>(&result))
      return std::string(name_of(rejection->reason)) + ": " + rejection->detail;
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

TEST_F(Placing, PutsAThingBesideItsNeighborAndNotOnlyOnTheSameTable) {
  const Scene scene = at_rest(house_with({"lamp_1", "potato_1"}));
  const std::string steps = plan("(exists (?x - Lamp) (exists (?y - Potato) (at-end (next_to ?x ?y))))", scene);
  EXPECT_THAT(steps, HasSubstr("place_on(diningtable_1)"));
}

TEST_F(Placing, TakesTheNeighborToWhereThereIsRoomBesideIt) {
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

/// A table of four meters, all of it taken but for one end.
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
  const auto way = steps_to_act(*world, put, "diningtable_1", {});
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

TEST_F(Placing, CarriesAwayWhatStandsBehindSomethingElseInTheWay) {
  Scene scene = house_with({"plate_1", "plate_2", "potato_1"});
  erase_if(scene.nodes, [](const Node& node) { return node.id == "sidetable_2"; });
  // A niche as high as the eye. What fills it at the back is larger than what hides it.
  edit_node(scene, "sidetable_1")->size = {0.6, 0.36, 1.35};
  move_to(scene, "sidetable_1", 8.0, 3.8, 0);
  for (const auto& [id, x] : {std::pair("countertop_2", 7.35), std::pair("countertop_3", 8.65)}) {
    add(scene, knowledge, id, "CounterTop", x, 3.8, 0).size = {0.68, 0.4, 1.8};
    move_to(scene, id, x, 3.8, 0);
  }
  edit_node(scene, "plate_2")->size = {0.5, 0.2, 0.02};
  edit_node(scene, "plate_2")->archetype = Archetype::Box;
  move_to(scene, "plate_2", 8.0, 3.87, 1.351);
  edit_node(scene, "potato_1")->size = {0.4, 0.12, 0.2};
  move_to(scene, "potato_1", 7.91, 3.69, 1.351);
  add(scene, knowledge, "potato_2", "Potato", 8.21, 3.69, 1.351).size = {0.16, 0.12, 0.2};
  move_to(scene, "potato_2", 8.21, 3.69, 1.351);
  const std::string steps = plan(
      "(exists (?x - (Plate :where (exists (?d - DiningTable) (on ?x ?d)))) (exists (?y - SideTable) (at-end (on "
      "?x ?y))))",
      at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("pick_up(plate_2)"));
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

/// Counters on three sides of who stands before the fridge; its open door is the fourth.
Scene behind_the_open_door(const Knowledge& knowledge) {
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
  return scene;
}

TEST_F(Placing, LeavesTheCornerBehindAnOpenDoor) {
  const std::string steps = plan("(exists (?x - Apple) (exists (?y - SideTable) (at-end (on ?x ?y))))",
                                 at_rest(behind_the_open_door(knowledge)));
  EXPECT_THAT(steps, HasSubstr("close(fridge_1)"));
  EXPECT_THAT(steps, HasSubstr("place_on(sidetable_"));
}

/// Two fridges in a corner, whose doors cross each other's way; one is open.
Scene with_doors_in_a_corner(const Knowledge& knowledge) {
  Scene scene = house_with({"apple_1"});
  erase_if(scene.nodes, [](const Node& node) { return node.id == "sink_1" || node.id == "diningtable_1"; });
  add(scene, knowledge, "fridge_2", "Fridge", 4.0, 3.55, 0);
  edit_node(scene, "fridge_1")->pose = upright(Vec3(4.35, 2.75, 0.85), -std::numbers::pi / 2);
  edit_node(scene, "apple_1")->pose.position = Vec3(8.5, 3.3, 0.7);
  return scene;
}

TEST_F(Placing, ShutsAnOpenDoorThatIsInTheWayOfAnother) {
  Scene scene = with_doors_in_a_corner(knowledge);
  set_state(scene, "fridge_2", Predicate::Open);
  const std::string steps = plan("(exists (?x - (Fridge :where (closed ?x))) (at-end (open ?x)))", at_rest(scene));
  EXPECT_THAT(steps, HasSubstr("close(fridge_2)"));
}

TEST_F(Placing, ShutsADoorThatBarsTheWayIntoARoom) {
  Scene scene = behind_the_open_door(knowledge);
  const std::string steps =
      plan("(exists (?x - Apple) (at-end (exists (?r - living_room) (in_room ?x ?r))))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("close(fridge_1)"));
}

/// The open door bars the way to the sink beside it, and another sink in the next room can be walked to.
TEST_F(Placing, GoesToTheNearSinkThatAnOpenDoorBarsTheWayTo) {
  Scene scene = behind_the_open_door(knowledge);
  erase_if(scene.nodes, [](const Node& node) { return node.id == "countertop_2" || node.id == "apple_1"; });
  add(scene, knowledge, "countertop_5", "CounterTop", 3.2, 0.5, 0).size = {0.5, 1.0, 0.9};
  add(scene, knowledge, "sink_1", "Sink", 1.8, 3.6, 0);
  add(scene, knowledge, "sink_2", "Sink", 7.0, 3.6, 0);
  add(scene, knowledge, "mug_1", "Mug", 3.2, 3.55, 0.9);
  set_state(scene, "mug_1", Predicate::Dirty);
  const std::string steps = plan("(exists (?x - Mug) (at-end (clean ?x)))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("close(fridge_1)"));
  EXPECT_THAT(steps, HasSubstr("(sink_1)"));
  EXPECT_THAT(steps, ::testing::Not(HasSubstr("(sink_2)")));
}

TEST_F(Placing, LetsAThingFallElsewhereInARoomThanWhereOneComesIn) {
  Scene scene = house_with({"mug_3"});
  erase_if(scene.nodes, [](const Node& node) { return node.id.starts_with("sidetable"); });
  // Screens on three sides of the middle, to which one is led.
  erase_if(scene.nodes, [](const Node& node) { return node.id == "television_1"; });
  for (const auto& [id, x, y, yaw] :
       {std::tuple("television_1", 7.4, 2.0, std::numbers::pi / 2), std::tuple("television_2", 7.0, 2.4, 0.0),
        std::tuple("television_3", 7.0, 1.6, 0.0)}) {
    Node& screen = add(scene, knowledge, id, "Television", x, y, 0.451, yaw);
    screen.size = {0.8, 0.1, 1.5};
  }
  const std::string steps =
      plan("(exists (?x - Mug) (at-end (exists (?r - living_room) (in_room ?x ?r))))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("drop stop"));
}

TEST_F(Placing, TakesOutWhatIsCutWhereItsSlicesCannotBeGotAt) {
  Scene scene = house_with({"knife_1", "apple_1"});
  erase_if(scene.nodes, [](const Node& node) { return node.id == "countertop_1" || node.id == "microwave_1"; });
  move_to(scene, "diningtable_1", 7.0, 1.0, 0);
  move_to(scene, "knife_1", 7.0, 1.0, 0.751);
  // As long as a loaf of bread, in a fridge as deep as a tunnel: only its near end is within reach.
  Node& fridge = *edit_node(scene, "fridge_1");
  fridge.size = {0.7, 2.6, 1.7};
  fridge.pose.position = Vec3(2.0, 2.7, 0.85);
  Node& apple = *edit_node(scene, "apple_1");
  apple.archetype = Archetype::Box;
  apple.size = {0.06, 1.4, 0.06};
  move_to(scene, "apple_1", 2.0, 3.1, 1.27);
  const std::string steps =
      plan("(exists (?x - Apple/slice) (exists (?y - SideTable) (at-end (on ?x ?y))))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("pick_up(apple_1)"));
}

TEST_F(Placing, LeavesRoomForAThingThatIsStillShutAway) {
  Scene scene = house_with({"plate_1", "plate_2"});
  erase_if(scene.nodes, [](const Node& node) {
    return node.id == "sidetable_2" || node.id == "countertop_1" || node.id == "microwave_1";
  });
  add(scene, knowledge, "fridge_2", "Fridge", 1.8, 3.55, 0);
  move_to(scene, "plate_1", 1.8, 3.55, 0.9);
  move_to(scene, "plate_2", 4.4, 3.55, 0.9);
  // Put in the middle, a plate leaves no room for the other.
  edit_node(scene, "sidetable_1")->size = {0.6, 0.4, 0.6};
  move_to(scene, "sidetable_1", 8.5, 2.0, 0);
  const std::string steps =
      plan("(exists (?y - SideTable) (at-end (forall (?x - Plate) (on ?x ?y))))", at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("place_on(sidetable_1) stop"));
}

TEST_F(Placing, PutsABoxWhereItsLidCanBeLifted) {
  Scene scene = house_with({"box_1", "plate_1", "plate_2"});
  erase_if(scene.nodes, [](const Node& node) { return node.id == "sidetable_2"; });
  for (const auto& [plate, y] : {std::pair("plate_1", 3.35), std::pair("plate_2", 3.65)})
    move_to(scene, plate, 7.82, y, 0.601);
  edit_node(scene, "sidetable_1")->size = {1.6, 0.6, 0.6};
  edit_node(scene, "sidetable_1")->pose.position = Vec3(7.2, 3.5, 0.3);
  Node& shelf = add(scene, knowledge, "countertop_2", "CounterTop", 7.0, 3.5, 0);
  shelf.size = {1.2, 0.6, 0.3};
  shelf.pose.position.z() = 0.6 + 0.24 + 0.15;  // over all of the table but its end
  const std::string steps = plan("(exists (?x - Box) (exists (?y - SideTable) (at-end (and (open ?x) (on ?x ?y)))))",
                                 at_rest(std::move(scene)));
  EXPECT_THAT(steps, HasSubstr("pick_up(plate_"));
}

TEST_F(Placing, ShutsABoxThatDoesNotFitWithItsLidUp) {
  Scene scene = house_with({"box_1", "apple_1"});
  add(scene, knowledge, "countertop_2", "CounterTop", 8.5, 3.5, 0).size = {0.6, 0.6, 0.3};
  Node& above = scene.nodes.edit(scene.nodes.size() - 1);
  above.pose.position.z() = 0.6 + 0.26 + 0.15;  // a quarter of a meter over the table
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
  EXPECT_FALSE(steps_to_act(*world, {ActionType::PlaceOn, {"sidetable_1"}}, "sidetable_1", {}));
}

}  // namespace
}  // namespace unietp::testing
