#include "annotator/another_meaning.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "logic/formula.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

Node thing(const std::string& category) {
  Node node;
  node.id = category + "_1";
  node.category = category;
  return node;
}

/// A home of BEHAVIOR with one thing of each category, in a room of the type that comes with it.
Scene home_with(const std::vector<std::pair<std::string, std::string>>& things) {
  Scene home;
  for (const auto& [category, type] : things) {
    home.nodes.push_back(thing(category));
    const Room room{type + "_1", type, {}};
    if (std::find(home.rooms.begin(), home.rooms.end(), room) == home.rooms.end()) home.rooms.push_back(room);
    home.edges.insert({Predicate::InRoom, category + "_1", room.id});
  }
  return home;
}

bool is_unclear(const std::string& text, const std::string& goal, const Scene& home,
                Simulator simulator = Simulator::Behavior) {
  const Knowledge& knowledge = committed_knowledge(simulator);
  const NounTable nouns(knowledge, committed_names());
  return may_mean_another(text, *parse_formula("test", goal, FormulaUse::Goal), home, knowledge, nouns);
}

TEST(AnotherMeaning, IsThatOfWhatIsCalledSoToo) {
  const std::string goal = "(exists (?a - frying_pan) (exists (?b - burner) (at-end (on ?a ?b))))";
  const std::string text = "Put the frying pan on the burner.";
  EXPECT_FALSE(is_unclear(text, goal, home_with({{"frying_pan", "kitchen"}, {"burner", "kitchen"}})));
  EXPECT_TRUE(
      is_unclear(text, goal, home_with({{"frying_pan", "kitchen"}, {"burner", "kitchen"}, {"stove", "kitchen"}})));
}

TEST(AnotherMeaning, IsNotThatOfWhatIsInAnotherRoomThanTheNameSays) {
  const std::string goal = "(exists (?a - sponge) (exists (?b - pedestal_sink) (at-end (inside ?a ?b))))";
  const std::string text = "Put the sponge in the bathroom sink.";
  EXPECT_FALSE(is_unclear(text, goal, home_with({{"pedestal_sink", "bathroom"}, {"furniture_sink", "kitchen"}})));
  EXPECT_TRUE(is_unclear(text, goal, home_with({{"pedestal_sink", "bathroom"}, {"furniture_sink", "bathroom"}})));
}

TEST(AnotherMeaning, IsThatOfFurnitureThatIsNotWhereItsNameSays) {
  const std::string goal = "(exists (?a - carton) (exists (?b - breakfast_table) (at-end (on ?a ?b))))";
  const std::string text = "Put the cardboard box on the dining table.";
  EXPECT_FALSE(is_unclear(text, goal, home_with({{"breakfast_table", "kitchen"}})));
  EXPECT_TRUE(is_unclear(text, goal, home_with({{"breakfast_table", "office"}})));
  // An imported home may not tell what its rooms are for.
  EXPECT_FALSE(is_unclear(text, goal, home_with({{"breakfast_table", "room"}})));
}

TEST(AnotherMeaning, IsThatOfWhatWouldDoAsWell) {
  const std::string goal =
      "(exists (?a - (either bottle_of_gin bottle_of_rum)) (exists (?b - coffee_table) (at-end (on ?a ?b))))";
  const std::string text = "Get an alcoholic drink and put it on the coffee table.";
  EXPECT_FALSE(is_unclear(text, goal, home_with({{"bottle_of_gin", "kitchen"}, {"coffee_table", "living_room"}})));
  EXPECT_TRUE(is_unclear(text, goal, home_with({{"bottle_of_gin", "kitchen"}, {"wine_bottle", "kitchen"}})));
}

TEST(AnotherMeaning, IsThatOfAnotherOfTheKindThatWouldDo) {
  const std::string goal = "(exists (?a - (either apple bananas)) (exists (?b - kitchencounter) (at-end (on ?a ?b))))";
  const std::string text = "Put a snack on the kitchen counter.";
  const auto is_unclear_with = [&](const std::string& category) {
    return is_unclear(text, goal, home_with({{"kitchencounter", "kitchen"}, {category, "kitchen"}}),
                      Simulator::Virtualhome);
  };
  EXPECT_FALSE(is_unclear_with("plate"));
  EXPECT_TRUE(is_unclear_with("poundcake"));
}

/// A kettle of AI2-THOR cannot be washed.
TEST(AnotherMeaning, IsThatOfWhatThePhraseMeansThoughTheGoalDoesNotAcceptIt) {
  const std::string goal = "(exists (?a - Pot) (exists (?b - CounterTop) (at-end (and (clean ?a) (on ?a ?b)))))";
  const std::string text = "I'm about to make some tea. Wash something to heat the water in and put it on a counter.";
  const auto is_unclear_with = [&](const std::string& category) {
    return is_unclear(text, goal, home_with({{"Pot", "kitchen"}, {"CounterTop", "kitchen"}, {category, "kitchen"}}),
                      Simulator::Ai2thor);
  };
  EXPECT_FALSE(is_unclear_with("Pan"));
  EXPECT_TRUE(is_unclear_with("Kettle"));
  // "a vegetable peeler" is not "a vegetable".
  EXPECT_FALSE(
      is_unclear("Put a vegetable peeler in the sink.",
                 "(exists (?a - vegetable_peeler) (exists (?b - furniture_sink) (at-end (inside ?a ?b))))",
                 home_with({{"vegetable_peeler", "kitchen"}, {"furniture_sink", "kitchen"}, {"carrot", "kitchen"}})));
}

TEST(AnotherMeaning, IsThatOfTwoThingsThatPeopleCallAlike) {
  const Scene home = home_with({{"eyeglasses", "bedroom"}, {"spectacles", "bedroom"}, {"console_table", "corridor"}});
  const auto goal = [](const std::string& thing, const std::string& other) {
    return "(exists (?a - " + thing + ") (exists (?b - " + other + ") (exists (?c - console_table) (at-end (and " +
           "(on ?a ?c) (on ?b ?c))))))";
  };
  EXPECT_TRUE(is_unclear("Place the pair of eyeglasses and the pair of glasses on the console table.",
                         goal("eyeglasses", "spectacles"), home, Simulator::Habitat));
  EXPECT_FALSE(is_unclear("Place the pair of eyeglasses and the hat on the console table.", goal("eyeglasses", "hat"),
                          home_with({{"eyeglasses", "bedroom"}, {"hat", "bedroom"}, {"console_table", "corridor"}}),
                          Simulator::Habitat));
}

TEST(AnotherMeaning, IsThatOfWhatItsSentenceLeavesOpen) {
  const auto is_unclear_after = [&](const std::string& sentence) {
    return is_unclear(sentence + " Get something to drink it from and put it on the coffee table.",
                      "(exists (?a - (either coffee_cup mug)) (exists (?b - coffee_table) (at-end (on ?a ?b))))",
                      home_with({{"mug", "kitchen"}, {"coffee_table", "living_room"}, {"wineglass", "kitchen"}}));
  };
  EXPECT_FALSE(is_unclear_after("I just brewed some coffee."));
  EXPECT_TRUE(is_unclear_after("I'd like some water with ice."));
}

TEST(AnotherMeaning, IsThatOfASynonymAlone) {
  const std::string goal = "(exists (?a - towel) (exists (?b - kitchencounter) (at-end (on ?a ?b))))";
  const Scene home = home_with({{"kitchencounter", "kitchen"}, {"bathroomcounter", "bathroom"}});
  EXPECT_TRUE(is_unclear("Put the towel on the counter.", goal, home, Simulator::Virtualhome));
  EXPECT_FALSE(is_unclear("Put the towel on the kitchen counter.", goal, home, Simulator::Virtualhome));
  EXPECT_FALSE(is_unclear("Put the towel on the counter.", goal, home_with({{"kitchencounter", "kitchen"}}),
                          Simulator::Virtualhome));
}

TEST(AnotherMeaning, OfAWishIsThatOfAPieceYetToBeCut) {
  const std::string goal = "(exists (?a - BreadSliced) (exists (?b - Plate) (at-end (and (hot ?a) (on ?a ?b)))))";
  const Scene home = home_with({{"BreadSliced", "kitchen"}, {"Bread", "kitchen"}, {"Plate", "kitchen"}});
  EXPECT_TRUE(is_unclear("I could use a warm piece of bread. Set it on the plate.", goal, home, Simulator::Ai2thor));
  EXPECT_FALSE(is_unclear("Heat the piece of bread and put it on the plate.", goal, home, Simulator::Ai2thor));
  EXPECT_FALSE(is_unclear("I could use a warm piece of bread. Set it on the plate.", goal,
                          home_with({{"BreadSliced", "kitchen"}, {"Plate", "kitchen"}}), Simulator::Ai2thor));
}

TEST(AnotherMeaning, IsThatOfWhatStandsAtTheDoorOfTheRoom) {
  const std::string goal =
      "(exists (?a - vase) (exists (?b - (nightstand :where (exists (?r - bedroom) (in_room ?b ?r)))) "
      "(at-end (on ?a ?b))))";
  const std::string text = "Put the vase on the nightstand in the bedroom.";
  Scene home = home_with({{"bed", "bedroom"}, {"nightstand", "bedroom"}});
  Node outside = thing("nightstand");
  outside.id = "nightstand_2";
  home.nodes.push_back(outside);
  home.rooms.push_back({"corridor_1", "corridor", {}});
  home.edges.insert({Predicate::InRoom, "nightstand_2", "corridor_1"});
  EXPECT_FALSE(is_unclear(text, goal, home));
  home.edges.insert({Predicate::NextTo, "nightstand_2", "bed_1"});
  EXPECT_TRUE(is_unclear(text, goal, home));
}

}  // namespace
}  // namespace unietp
