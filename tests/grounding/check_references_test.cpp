// Whether people in a home would tell things apart as a goal does.
#include "grounding/check_references.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "homes.h"

namespace unietp {
namespace {

/// Two mugs, two desks and a fridge in two rooms, and what else holds of them: "on mug_1 desk_1", "closed fridge".
Trace home_with(const std::vector<std::string>& facts) {
  Trace trace;
  const std::array<std::array<std::string, 2>, 5> objects{
      {{"mug_1", "Mug"}, {"mug_2", "Mug"}, {"desk_1", "Desk"}, {"desk_2", "Desk"}, {"fridge", "Fridge"}}};
  for (const auto& [id, category] : objects) trace.entities.push_back({Entity::Kind::Object, id, category, ""});
  for (const char* room : {"kitchen", "office"}) trace.entities.push_back({Entity::Kind::Room, room, room, ""});
  const auto index = [&](const std::string& id) {
    EntityIndex at;
    while (trace.entities[at].id != id) ++at;
    return at;
  };
  Facts now;
  for (EntityIndex at; at.index() < trace.entities.size(); ++at) now.set_exists(at);
  for (const std::string& fact : facts) {
    std::istringstream words(fact);
    std::string name, first, second;
    words >> name >> first >> second;
    const Predicate predicate = *predicate_named(name);
    if (second.empty()) {
      now.set(predicate, index(first));
    } else if (info(predicate).arguments[1] == ArgumentKind::Symbol) {
      now.set(predicate, index(first), second);
    } else {
      now.set(predicate, index(first), index(second));
    }
  }
  trace.states.push_back(std::move(now));
  return trace;
}

/// What is odd about "pick up the mug that TEST" there; "" when it is natural.
std::string odd(const std::string& test, const std::vector<std::string>& facts) {
  Specification asked;
  asked.goal = parsed("(exists (?a - (Mug :where " + test + ")) (at-end (held ?a)))", FormulaUse::Goal);
  const auto problem = check_references(asked, home_with(facts));
  if (!problem) return "";
  EXPECT_EQ(problem->reason, RejectionReason::OddReference);
  return problem->detail.substr(problem->detail.rfind(": ") + 2);
}

const std::string kOnDesk = "(exists (?p - Desk) (on ?a ?p))", kInFridge = "(exists (?p - Fridge) (inside ?a ?p))",
                  kBesideFridge = "(exists (?p - Fridge) (next_to ?a ?p))",
                  kNearestFridge = "(exists (?p - Fridge) (nearest ?a ?p))";

TEST(CheckReferences, AcceptThePlaceThatIsAloneAndRefuseOneOfSeveral) {
  EXPECT_EQ(odd(kInFridge, {"inside mug_1 fridge", "on mug_2 desk_1"}), "");
  EXPECT_EQ(odd(kOnDesk, {"on mug_1 desk_1", "inside mug_2 fridge"}), "there are several of those");
}

TEST(CheckReferences, WantAnotherInAWrongPlaceOfTheSameSort) {
  const std::string none = "none of the others is at such a place of another thing";
  EXPECT_EQ(odd(kInFridge, {"inside mug_1 fridge"}), none);
  EXPECT_EQ(odd(kInFridge, {"inside mug_1 fridge", "next_to mug_2 desk_1"}), none);
  const std::vector<std::string> together{"next_to mug_1 fridge", "in_room mug_1 kitchen", "in_room fridge kitchen"};
  const auto with = [&](const std::string& more) {
    auto facts = together;
    facts.push_back(more);
    return odd(kBesideFridge, facts);
  };
  EXPECT_EQ(with("on mug_2 desk_1"), none);
  EXPECT_EQ(with("next_to mug_2 desk_1"), "");
}

TEST(CheckReferences, RefuseALandmarkInAnotherRoom) {
  EXPECT_EQ(odd(kBesideFridge,
                {"next_to mug_1 fridge", "next_to mug_2 desk_1", "in_room mug_1 kitchen", "in_room fridge kitchen"}),
            "");
  EXPECT_EQ(odd(kBesideFridge,
                {"next_to mug_1 fridge", "next_to mug_2 desk_1", "in_room mug_1 office", "in_room fridge kitchen"}),
            "that is in another room");
}

TEST(CheckReferences, WantWhatIsNotSomewhereInARoomWithOneThatIs) {
  const std::string elsewhere = "(not " + kInFridge + ")";
  EXPECT_EQ(odd(elsewhere, {"inside mug_2 fridge", "in_room mug_1 kitchen", "in_room mug_2 kitchen"}), "");
  EXPECT_EQ(odd(elsewhere, {"inside mug_2 fridge", "in_room mug_1 office", "in_room mug_2 kitchen"}),
            "the others are in other rooms");
}

TEST(CheckReferences, CompareSizesWithinARoom) {
  EXPECT_EQ(odd("(size ?a large)", {"size mug_1 large", "in_room mug_1 office", "in_room mug_2 office"}), "");
  EXPECT_EQ(odd("(size ?a large)", {"size mug_1 large", "in_room mug_1 office", "in_room mug_2 kitchen"}),
            "the others are in other rooms");
}

TEST(CheckReferences, MeasureNearnessAmongWhatIsSeenInOneRoom) {
  const std::vector<std::string> together{"nearest mug_1 fridge", "in_room mug_1 kitchen", "in_room mug_2 kitchen",
                                          "in_room fridge kitchen", "closed fridge"};
  const auto with = [&](const std::string& more) {
    auto facts = together;
    facts.push_back(more);
    return odd(kNearestFridge, facts);
  };
  EXPECT_EQ(with("next_to mug_1 desk_1"), "");
  EXPECT_EQ(with("on mug_1 fridge"), "it is on or in that");
  EXPECT_EQ(odd(kNearestFridge, {"nearest mug_1 fridge", "in_room mug_1 kitchen", "in_room mug_2 kitchen",
                                 "in_room fridge kitchen", "on mug_1 desk_1", "on desk_1 fridge"}),
            "it is on or in that");
  EXPECT_EQ(with("inside mug_1 fridge"), "it is shut away");
  EXPECT_EQ(with("inside mug_2 fridge"), "no other one is seen in the room");
  EXPECT_EQ(odd(kNearestFridge, {"nearest mug_1 fridge", "in_room mug_1 office", "in_room fridge kitchen"}),
            "that is in another room");
}

/// "The mug on the desk", not "the mug nearest to the fridge".
TEST(CheckReferences, TellByTheOnlySuchPlaceRatherThanByNearness) {
  std::vector<std::string> facts{"nearest mug_1 fridge",   "in_room mug_1 kitchen", "in_room mug_2 kitchen",
                                 "in_room fridge kitchen", "closed fridge",         "in_room desk_1 kitchen",
                                 "on mug_1 desk_1"};
  const auto with = [&](const std::vector<std::string>& more) {
    auto all = facts;
    all.insert(all.end(), more.begin(), more.end());
    return odd(kNearestFridge, all);
  };
  EXPECT_EQ(with({"in_room desk_2 office"}), "what it is on or in says which it is");
  EXPECT_EQ(with({"in_room desk_2 kitchen"}), "") << "the room has two";
  EXPECT_EQ(with({"in_room desk_2 office", "on mug_2 desk_2"}), "") << "both are on a desk";
}

TEST(CheckReferences, LeaveStatesAndColorsToOtherChecks) {
  EXPECT_EQ(odd("(dirty ?a)", {"dirty mug_1", "in_room mug_1 office", "in_room mug_2 kitchen"}), "");
}

}  // namespace
}  // namespace unietp
