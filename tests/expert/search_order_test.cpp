// What the expert of M2 and M3 looks for, and where.
#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expert/belief.h"
#include "expert/search_needs.h"
#include "expert/search_order.h"
#include "expert/window.h"
#include "scene/scene.h"
#include "tests/expert/house.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/household.h"

namespace unietp::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

TEST(SearchNeeds, TellWhatToLookForAndWhere) {
  const SearchNeeds one = search_needs(
      goal("(exists (?x - (Mug :where (exists (?f - Fridge) (inside ?x ?f)))) (exists (?y - SideTable) (at-end (on ?x "
           "?y))))"));
  ASSERT_EQ(one.needs.size(), 3U);  // the fridge of the phrase too
  const auto mug = std::find_if(one.needs.begin(), one.needs.end(),
                                [](const SearchNeed& need) { return need.categories.front() == "Mug"; });
  ASSERT_NE(mug, one.needs.end());
  EXPECT_THAT(mug->places, ElementsAre("Fridge"));
  EXPECT_FALSE(mug->every);
  const SearchNeeds all = search_needs(goal("(exists (?y - Fridge) (forall (?x - Mug) (at-end (inside ?x ?y))))"));
  EXPECT_TRUE(std::any_of(all.needs.begin(), all.needs.end(), [](const SearchNeed& need) {
    return need.every && need.categories.front() == "Mug" && need.places.empty();
  }));
  const SearchNeeds none = search_needs(goal("(exists (?y - SideTable) (at-end (count = 0 (?x - Mug) (on ?x ?y))))"));
  EXPECT_TRUE(std::any_of(none.needs.begin(), none.needs.end(), [](const SearchNeed& need) {
    return need.every && need.at_least == 0 && need.places == std::vector<std::string>{"SideTable"};
  }));
}

TEST(SearchNeeds, WhatIsNearAThingIsLookedForThere) {
  const auto places_of_mugs = [](const std::string& text) {
    std::vector<std::string> places;
    for (const SearchNeed& need : search_needs(goal(text)).needs) {
      if (need.categories.front() == "Mug") places.insert(places.end(), need.places.begin(), need.places.end());
    }
    return places;
  };
  EXPECT_THAT(places_of_mugs("(exists (?x - (Mug :where (exists (?y - Sink) (next_to ?x ?y)))) (at-end (held ?x)))"),
              ElementsAre("Sink"));
  EXPECT_THAT(places_of_mugs("(forall (?y - SideTable) (forall (?x - Mug) (at-end (not (on ?x ?y)))))"),
              ElementsAre("SideTable"));
}

TEST(SearchNeeds, TheNearestIsLookedForAroundAThingAndElsewhere) {
  for (const SearchNeed& need :
       search_needs(goal("(exists (?x - (Mug :where (exists (?y - Sink) (nearest ?x ?y)))) (at-end (held ?x)))"))
           .needs) {
    if (need.categories.front() != "Mug") continue;
    EXPECT_TRUE(need.every);
    EXPECT_THAT(need.near, ElementsAre("Sink"));
    EXPECT_THAT(need.places, IsEmpty());
  }
}

TEST(SearchNeeds, OnlyWhatIsForbiddenKeepsSomethingShut) {
  EXPECT_THAT(search_needs(goal("(exists (?y - Fridge) (and (always (closed ?y)) (at-end (clean ?y))))")).shut,
              UnorderedElementsAre("Fridge"));
  EXPECT_THAT(search_needs(goal("(exists (?y - Fridge) (before (open ?y) (power_on ?y)))")).shut, IsEmpty());
}

TEST(SearchNeeds, SlicesAskForSomethingToCutWith) {
  const auto asks_to_cut_apples = [](const std::string& text) {
    const SearchNeeds needs = search_needs(goal(text));
    return std::any_of(needs.states.begin(), needs.states.end(), [](const WantedState& wanted) {
      return wanted.state.predicate == Predicate::Sliced && wanted.positive && !wanted.stated &&
             wanted.categories == std::vector<std::string>{"Apple"};
    });
  };
  EXPECT_TRUE(asks_to_cut_apples("(exists (?s - Apple/slice) (exists (?b - SideTable) (at-end (on ?s ?b))))"));
  EXPECT_TRUE(asks_to_cut_apples("(exists (?b - SideTable) (at-end (count = 2 (?s - Apple/slice) (on ?s ?b))))"));
  EXPECT_FALSE(asks_to_cut_apples("(exists (?b - SideTable) (at-end (count = 0 (?s - Apple/slice) (on ?s ?b))))"));
  EXPECT_FALSE(asks_to_cut_apples("(exists (?s - Apple) (exists (?b - SideTable) (at-end (on ?s ?b))))"));
}

bool out_of_reach(const std::string& /*id*/) { return false; }

struct LookingForAMug : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = at_rest(house());
  const Formula wanted = goal("(exists (?x - Mug) (at-end (held ?x)))");
  ExecutionTree executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  EpisodeWindow window{executions, Mode::M2};
  unietp::Belief belief{window.known_scene(), search_needs(wanted), {"Mug"}};
};

TEST_F(LookingForAMug, BeginsWhereTheGoalSaysAndOpensWhatIsShut) {
  const SearchOrder order(window.known_scene(), knowledge, nullptr, {}, profile);
  const auto look = order.next({{"Mug", {"Fridge"}, {}, false}}, belief, "", out_of_reach);
  ASSERT_TRUE(look);
  EXPECT_EQ(look->id, "fridge_1");
  EXPECT_TRUE(look->opens);
  const SearchOrder shut(window.known_scene(), knowledge, nullptr, {"Fridge"}, profile);
  const auto other = shut.next({{"Mug", {"Fridge"}, {}, false}}, belief, "", out_of_reach);
  EXPECT_TRUE(!other || !other->opens || other->id != "fridge_1");
}

TEST_F(LookingForAMug, OpensFromWhereItStandsWhatIsInReach) {
  SearchOrder order(window.known_scene(), knowledge, nullptr, {}, profile);
  for (const Node& node : window.known_scene().nodes) {
    if (node.id != "fridge_1") order.give_up(node.id);
  }
  for (const Room& room : window.known_scene().rooms) order.give_up(room.id);
  const auto far = order.next({{"Mug"}}, belief, "", out_of_reach);
  ASSERT_TRUE(far);
  EXPECT_TRUE(far->opens && !far->from_here);
  const auto near = order.next({{"Mug"}}, belief, "", [](const std::string& id) { return id == "fridge_1"; });
  ASSERT_TRUE(near);
  EXPECT_TRUE(near->opens && near->from_here);
}

TEST_F(LookingForAMug, GoesUpToWhatItPeekedInto) {
  SearchOrder order(window.known_scene(), knowledge, nullptr, {}, profile);
  const std::vector<SearchTarget> inside{{"Mug", {"Fridge"}, {}, false}};
  Node open = *belief.find("fridge_1");
  open.states.set({Predicate::Open, ""});
  belief.see({open}, belief.scene().agent);
  const double before = order.unseen_share(inside.front(), belief);
  order.peeked_into("fridge_1");
  const double peeked = order.unseen_share(inside.front(), belief);
  EXPECT_LT(peeked, before);
  EXPECT_EQ(order.next(inside, belief, "", out_of_reach)->id, "fridge_1");
  order.looked_at("fridge_1", belief);
  const double looked = order.unseen_share(inside.front(), belief);
  EXPECT_LT(looked, peeked);
  open.states.clear(Predicate::Open);
  belief.see({open}, belief.scene().agent);
  EXPECT_DOUBLE_EQ(order.unseen_share(inside.front(), belief), looked)
      << "what was seen in it is known after it closes";
}

TEST_F(LookingForAMug, LooksAtAPlaceFromOtherAnglesLater) {
  const SearchOrder order(window.known_scene(), knowledge, nullptr, {}, profile);
  const Action go{ActionType::GoTo, {"sidetable_1"}};
  EXPECT_THAT(order.way_to({"sidetable_1"}, ""), ElementsAre(go));
  EXPECT_THAT(order.way_to({"sidetable_1"}, "sidetable_1"), IsEmpty());
  EXPECT_THAT(order.way_to({"sidetable_1", false, 1}, ""), ElementsAre(go, Action{ActionType::LookDown, {}}));
  EXPECT_THAT(order.way_to({"sidetable_1", false, 2}, ""), ElementsAre(go, Action{ActionType::LookUp, {}}));
  EXPECT_THAT(order.way_to({"kitchen_1", false, 1, true}, "kitchen_1"),
              ::testing::Each(Action{ActionType::TurnLeft, {}}));
  EXPECT_THAT(order.way_to({"fridge_1", true, 0, false, true}, ""), IsEmpty());
}

TEST_F(LookingForAMug, GoesOnElsewhereOnceAPlaceWasLookedAt) {
  SearchOrder order(window.known_scene(), knowledge, nullptr, {}, profile);
  const std::vector<SearchTarget> mug{{"Mug"}};
  const double before = order.unseen_share(mug.front(), belief);
  const auto first = order.next(mug, belief, "", out_of_reach);
  ASSERT_TRUE(first);
  order.looked_at(first->id, belief);
  EXPECT_LT(order.unseen_share(mug.front(), belief), before);
  const auto second = order.next(mug, belief, "", out_of_reach);
  ASSERT_TRUE(second);
  EXPECT_TRUE(second->id != first->id || second->opens);
  order.give_up(second->id);
  const auto third = order.next(mug, belief, "", out_of_reach);
  EXPECT_TRUE(!third || third->id != second->id);
}

/// With the tables of lived-in homes: balls lie on floors, spoons do not.
TEST(SearchOrder, LooksOnTheFloorForWhatUsuallyLiesThere) {
  const Knowledge& known = committed_knowledge(Simulator::Ai2thor);
  const auto usual = read_household(std::filesystem::path(UNIETP_SOURCE_DIR) / "data" / "sense", known);
  ASSERT_TRUE(usual);
  Scene known_scene;
  known_scene.simulator = Simulator::Ai2thor;
  known_scene.rooms = {{"living_room_1", "living_room", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}}};
  known_scene.nodes.push_back(node_of(known, "shelf_1", "Shelf", 1, 1, 1));
  known_scene.nodes.push_back(node_of(known, "dining_table_1", "DiningTable", 3, 3, 0));
  const unietp::Belief belief(known_scene, {}, {});
  Profile profile = house_profile();
  profile.turn_deg = 90;
  SearchOrder order(known_scene, known, &*usual, {}, profile);
  for (int look = 0; look < 4; ++look) order.looked_at("living_room_1", belief);
  EXPECT_LT(order.unseen_share({"BasketBall"}, belief), 0.9);
  EXPECT_GT(order.unseen_share({"Spoon"}, belief), 0.95);
}

}  // namespace
}  // namespace unietp::testing
