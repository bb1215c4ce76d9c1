#include "pddl/domain.h"

#include <gtest/gtest.h>

#include "pddl/names.h"
#include "reader.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

TEST(PddlDomain, OfEachSimulatorReadsStrictly) {
  for (const auto simulator : kSimulators) {
    SCOPED_TRACE(name_of(simulator));
    const auto text = pddl::domain_text(committed_knowledge(simulator));
    ASSERT_NO_THROW(testing::read_pddl_domain(text));
    const auto domain = testing::read_pddl_domain(text);
    EXPECT_EQ(domain.name, pddl::domain_name(simulator));
    for (const char* action : {"go_to", "pick_up", "place_on", "place_in", "open-shut", "close", "note", "judge"})
      EXPECT_EQ(domain.actions.count(action), 1U) << action;
    // Some planners keep one list of names for all that a domain declares.
    for (const auto& [name, action] : domain.actions) {
      EXPECT_EQ(domain.predicates.count(name), 0U) << name;
      EXPECT_EQ(domain.types.count(name), 0U) << name;
    }
    for (const auto& [name, parent] : domain.types) EXPECT_EQ(domain.predicates.count(name), 0U) << name;
  }
  const auto habitat = testing::read_pddl_domain(pddl::domain_text(committed_knowledge(Simulator::Habitat)));
  EXPECT_EQ(habitat.actions.count("turn_on"), 0U) << "an action that the simulator does not offer";
}

TEST(PddlDomain, OfTheWideProfileHasTheActionsOfTheTableAndReadsStrictly) {
  for (const auto simulator : kSimulators) {
    SCOPED_TRACE(name_of(simulator));
    const auto domain =
        testing::read_pddl_domain(pddl::domain_text(committed_knowledge(simulator), ActionProfile::Wide));
    for (const ActionInfo& action : extension_actions()) {
      const auto count =
          domain.actions.count(std::string(action.name)) + domain.actions.count(std::string(action.name) + "-held");
      EXPECT_EQ(count > 0, offers(action, simulator)) << action.name;
      if (count == 0 || action.changes.empty()) continue;
      EXPECT_EQ(domain.predicates.count(std::string(info(action.changes.front().state).name)), 1U) << action.name;
    }
    for (const auto& [name, action] : domain.actions) EXPECT_EQ(domain.predicates.count(name), 0U) << name;
  }
}

TEST(PddlDomain, WhoSitsOrLiesIsSeated) {
  const std::string text = pddl::domain_text(committed_knowledge(Simulator::Virtualhome), ActionProfile::Wide);
  for (const char* name : {"(:action sit_on", "(:action lie_on", "(:action open"}) {
    const auto begin = text.find(name);
    ASSERT_NE(begin, std::string::npos) << name;
    const std::string action = text.substr(begin, text.find("(:action", begin + 1) - begin);
    const std::string effect = action.substr(action.find(":effect"));
    EXPECT_EQ(effect.find("(seated)") != std::string::npos, std::string(name) != "(:action open") << action;
  }
}

TEST(PddlDomain, AStrictReaderRefusesWhatIsNotDeclared) {
  const std::string head =
      "(define (domain d) (:requirements :strips :typing) (:types a b - object) (:predicates (p ?x - a)) ";
  const auto refuses = [&](const std::string& action) {
    EXPECT_THROW(testing::read_pddl_domain(head + action + ")"), std::runtime_error) << action;
  };
  EXPECT_NO_THROW(testing::read_pddl_domain(
      head + "(:action go :parameters (?x - a) :precondition (and (p ?x)) :effect (and (not (p ?x)))))"));
  refuses("(:action go :parameters (?x - b) :precondition (and (p ?x)) :effect (and))");
  refuses("(:action go :parameters (?x - a) :precondition (and (q ?x)) :effect (and))");
  refuses("(:action go :parameters (?x - a) :precondition (and (not (p ?x))) :effect (and))");
  refuses("(:action go :parameters (?x - a) :precondition (and) :effect (forall (?y - a) (p ?y)))");
  refuses("(:action go :parameters (?x - a) :precondition (and (p ?y)) :effect (and))");
  refuses("(:action go :parameters (?x - c) :precondition (and) :effect (and))");
}

TEST(PddlNames, AreWordsOfPddlAndDifferWhateverTheCase) {
  EXPECT_EQ(pddl::name_for("coffee_table.n.01"), "coffee_table_n_01");
  EXPECT_EQ(pddl::name_for("3d printer"), "x_3d_printer");
  EXPECT_EQ(pddl::name_for("Object"), "object_1");
  EXPECT_EQ(pddl::name_for("Room"), "room_1");              // a type
  EXPECT_EQ(pddl::name_for("m12"), "m12_1");                // a monitor
  EXPECT_EQ(pddl::name_for("hold-after"), "hold-after_1");  // a word of PDDL 3
  EXPECT_EQ(pddl::names_for({"Mug 1", "mug_1", "MUG_1"}), (std::vector<std::string>{"mug_1", "mug_1-2", "mug_1-3"}));
}

}  // namespace
}  // namespace unietp
