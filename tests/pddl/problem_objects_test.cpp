#include "pddl/problem_objects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/text.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

/// A problem stays small in a home with many places: two kinds of furniture on which to put a thing aside are enough.
TEST(PddlProblemObjects, HaveTwoKindsOfFurnitureToPutAThingAside) {
  const auto& knowledge = committed_knowledge(Simulator::Ai2thor);
  Scene home;
  const auto add = [&](const std::string& category) {
    Node node;
    node.id = lower(category) + "_1";
    node.category = category;
    node.movable = knowledge.find(category)->movable;
    home.nodes.push_back(node);
  };
  add("Mug");
  for (const Placement* place : knowledge.placements_of("Mug", Predicate::On)) {
    const bool treats = std::ranges::any_of(knowledge.effects(),
                                            [&](const Effect& effect) { return effect.tool == place->receptacle; });
    if (!knowledge.find(place->receptacle)->movable && !treats) add(place->receptacle);
  }
  ASSERT_GT(home.nodes.size(), 6U);
  const auto goal = parse_formula("test", "(exists (?a - Mug) (at-end (held ?a)))", FormulaUse::Goal);
  ASSERT_TRUE(goal);
  EXPECT_EQ(pddl::problem_objects(home, knowledge, *goal, {}).size(), 3U);
}

}  // namespace
}  // namespace unietp
