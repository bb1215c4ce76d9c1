// Whether what a goal asks for seems to be so already.
#include "grounding/check_seeming.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "homes.h"

namespace unietp {
namespace {

struct Fact {
  std::string thing;
  Predicate relation;
  std::string place;
};

/// What is dirty and what is clean.
struct Dirt {
  std::vector<std::string> dirty, clean;
};

/// An apple, two bowls, a counter, a table, a fridge, a sink and a cabinet, of which the facts hold.
Trace home_with(const std::vector<Fact>& facts, const Dirt& dirt = {}) {
  Trace trace;
  const std::array<std::array<std::string, 2>, 8> objects{{{"apple", "Apple"},
                                                           {"bowl_1", "Bowl"},
                                                           {"bowl_2", "Bowl"},
                                                           {"counter", "CounterTop"},
                                                           {"table", "DiningTable"},
                                                           {"fridge", "Fridge"},
                                                           {"sink", "Sink"},
                                                           {"cabinet", "Cabinet"}}};
  for (const auto& [id, category] : objects) trace.entities.push_back({Entity::Kind::Object, id, category, ""});
  const auto index = [&](const std::string& id) {
    EntityIndex at;
    while (trace.entities[at].id != id) ++at;
    return at;
  };
  Facts now;
  for (EntityIndex at; at.index() < trace.entities.size(); ++at) now.set_exists(at);
  for (const Fact& fact : facts) now.set(fact.relation, index(fact.thing), index(fact.place));
  for (const std::string& id : dirt.dirty) now.set(Predicate::Dirty, index(id));
  for (const std::string& id : dirt.clean) now.set(Predicate::Clean, index(id));
  trace.states.push_back(std::move(now));
  return trace;
}

bool seems(const std::string& goal, const std::vector<Fact>& facts, const Dirt& dirt = {}) {
  const auto problem =
      check_seeming(parsed(goal, FormulaUse::Goal), home_with(facts, dirt), committed_knowledge(Simulator::Ai2thor));
  EXPECT_TRUE(!problem || problem->reason == RejectionReason::PartHolds);
  return problem.has_value();
}

using enum Predicate;
const std::string kOntoCounter = "(exists (?a - Apple) (exists (?b - CounterTop) (at-end (on ?a ?b))))",
                  kIntoFridge = "(exists (?a - Apple) (exists (?b - Fridge) (at-end (inside ?a ?b))))";

TEST(Seeming, IsWhatIsInABowlAtThePlace) {
  EXPECT_TRUE(seems(kOntoCounter, {{"apple", Inside, "bowl_1"}, {"bowl_1", On, "counter"}}));
  EXPECT_TRUE(seems(kOntoCounter, {{"apple", On, "bowl_1"}, {"bowl_1", On, "bowl_2"}, {"bowl_2", On, "counter"}}));
  EXPECT_TRUE(seems(kIntoFridge, {{"apple", On, "bowl_1"}, {"bowl_1", Inside, "fridge"}}));
  EXPECT_FALSE(seems(kOntoCounter, {{"apple", Inside, "bowl_1"}, {"bowl_1", On, "table"}}));
  EXPECT_FALSE(seems(kOntoCounter, {{"apple", On, "table"}, {"bowl_1", On, "counter"}}));
}

TEST(Seeming, IsNothingThatIsInFurniture) {
  EXPECT_FALSE(seems(kOntoCounter, {{"apple", Inside, "fridge"}, {"fridge", On, "counter"}}));
}

TEST(Seeming, IsLookedForInDescriptionsAndProhibitions) {
  const std::vector<Fact> both{
      {"bowl_1", On, "counter"}, {"bowl_2", On, "apple"}, {"apple", On, "counter"}, {"apple", On, "bowl_1"}};
  EXPECT_TRUE(seems("(exists (?a - (Bowl :where (exists (?p - CounterTop) (on ?a ?p)))) (at-end (clean ?a)))", both));
  EXPECT_TRUE(seems("(at-end (forall (?a - Bowl) (not (exists (?p - CounterTop) (on ?a ?p)))))", both));
  EXPECT_FALSE(seems("(exists (?a - (Bowl :where (clean ?a))) (exists (?b - CounterTop) (at-end (on ?a ?b))))", both));
}

TEST(Seeming, IsOfCleanThingsThatAreToBeWashed) {
  const std::string into_sink = "(exists (?a - Bowl) (exists (?b - Sink) (at-end (inside ?a ?b))))",
                    wash_all = "(forall (?a - Bowl) (at-end (clean ?a)))";
  const Dirt mixed{{"bowl_1"}, {"bowl_2"}};
  EXPECT_TRUE(seems(into_sink, {}, mixed));
  EXPECT_TRUE(seems(wash_all, {}, mixed));
  EXPECT_FALSE(seems(into_sink, {{"bowl_2", Inside, "sink"}}, mixed));  // the dirty one is left
  EXPECT_FALSE(seems(into_sink, {}, {{"bowl_1", "bowl_2"}, {}}));
  EXPECT_FALSE(seems(wash_all, {}, {{"bowl_1", "bowl_2"}, {}}));
  EXPECT_TRUE(seems(into_sink, {}, {{}, {"bowl_1", "bowl_2"}}));
  EXPECT_FALSE(seems("(exists (?a - Bowl) (exists (?b - DiningTable) (at-end (on ?a ?b))))", {}, mixed));
  EXPECT_FALSE(
      seems("(exists (?a - (Bowl :where (dirty ?a))) (exists (?b - Sink) (at-end (inside ?a ?b))))", {}, mixed));
}

TEST(Seeming, IsNotAskedBesideWhatWaitsInTheSink) {
  const std::string beside = "(exists (?a - Apple) (exists (?b - Bowl) (at-end (next_to ?a ?b))))";
  EXPECT_TRUE(seems(beside, {{"bowl_1", Inside, "sink"}}));
  EXPECT_FALSE(seems(beside, {{"bowl_1", Inside, "fridge"}}));
}

TEST(Seeming, IsNotAskedOfDirtyThingsThatWaitInTheSink) {
  const std::string out = "(exists (?b - Sink) (at-end (count = 0 (?a - Bowl) (inside ?a ?b))))";
  EXPECT_TRUE(seems(out, {{"bowl_1", Inside, "sink"}}, {{"bowl_1"}, {}}));
  EXPECT_FALSE(seems(out, {{"bowl_1", Inside, "sink"}}, {{}, {"bowl_1"}}));
}

TEST(Seeming, IsNotAskedOfABowlThatIsPutAway) {
  const std::string into = "(exists (?a - Apple) (exists (?b - Bowl) (at-end (inside ?a ?b))))",
                    and_on =
                        "(exists (?a - Apple) (exists (?b - Bowl) (exists (?c - DiningTable) (at-end (and (inside ?a "
                        "?b) (on ?b ?c))))))";
  const std::vector<Fact> stored{{"bowl_1", Inside, "cabinet"}, {"bowl_2", Inside, "cabinet"}};
  EXPECT_TRUE(seems(into, stored));
  EXPECT_FALSE(seems(and_on, stored));  // it is taken out
  EXPECT_FALSE(seems(into, {{"bowl_1", Inside, "cabinet"}, {"bowl_2", On, "table"}}));
  EXPECT_FALSE(seems(into, {{"bowl_1", Inside, "fridge"}, {"bowl_2", Inside, "fridge"}}));
  const std::vector<Fact> in_sink{{"bowl_1", Inside, "sink"}, {"bowl_2", Inside, "sink"}};
  const std::string washed = "(exists (?a - Apple) (exists (?b - Bowl) (at-end (and (clean ?b) (inside ?a ?b)))))";
  EXPECT_TRUE(seems(into, in_sink));
  EXPECT_FALSE(seems(washed, in_sink));  // it is washed first
}

TEST(Seeming, EndsWhereContactsGoInACircle) {
  EXPECT_FALSE(seems(kOntoCounter, {{"apple", On, "bowl_1"}, {"bowl_1", On, "bowl_2"}, {"bowl_2", On, "bowl_1"}}));
}

}  // namespace
}  // namespace unietp
