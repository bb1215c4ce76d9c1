#include "generator/propose.h"

#include <gtest/gtest.h>

#include <set>

#include "small_home.h"

namespace unietp {
namespace {

GateRefusal refusal_of(const std::string& name, const Binding& binding, Simulator simulator = Simulator::Ai2thor) {
  const auto proposed = propose(library_template(name), small_home(simulator), binding);
  const auto* refusal = std::get_if<GateRefusal>(&proposed);
  return refusal == nullptr ? GateRefusal{} : *refusal;
}

TEST(Gate, LetsASoundCandidateThrough) {
  const auto proposed = propose(library_template("open-one"), small_home(Simulator::Ai2thor), {{"A", "Fridge"}});
  ASSERT_TRUE(std::holds_alternative<Specification>(proposed));
  EXPECT_EQ(to_text(std::get<Specification>(proposed).goal), "(exists (?a - Fridge) (at-end (open ?a)))");
}

TEST(Gate, SaysWhichGateRefusedWhatWasAskedAndWhatWouldHaveToChange) {
  const auto simulator = refusal_of("wash-one", {{"A", "Mug"}, {"T", "Sink"}}, Simulator::Habitat);
  EXPECT_EQ(simulator.gate, Gate::Simulator);
  EXPECT_NE(simulator.remedy.find("ai2thor, behavior"), std::string::npos) << simulator.remedy;

  const auto unbound = refusal_of("place-one-on", {{"A", "Mug"}});
  EXPECT_EQ(unbound.gate, Gate::Placeholder);
  EXPECT_EQ(unbound.about, "B");

  const auto unknown = refusal_of("open-one", {{"A", "Unicorn"}});
  EXPECT_EQ(unknown.gate, Gate::Placeholder);
  EXPECT_EQ(unknown.reason, "'Unicorn' is not a category of ai2thor");

  const auto affordance = refusal_of("open-one", {{"A", "Table"}});
  EXPECT_EQ(affordance.gate, Gate::Affordance);
  EXPECT_EQ(affordance.reason, "'Table' cannot be A, which asks for: openable; it is not openable");
  EXPECT_NE(affordance.remedy.find("override"), std::string::npos);

  const auto constraint = refusal_of("wash-one", {{"A", "Mug"}, {"T", "Fridge"}});
  EXPECT_EQ(constraint.gate, Gate::Constraint);
  EXPECT_EQ(constraint.about, "(washes Fridge Mug)");
}

Specification about(Simulator simulator, const std::string& goal, const std::vector<std::string>& init) {
  Specification made;
  made.simulator = simulator;
  auto read = parse_formula("test", goal, FormulaUse::Goal);
  EXPECT_TRUE(read) << format(read.error());
  made.goal = *read;
  for (const auto& text : init) made.init.push_back(*parse_formula("test", text, FormulaUse::State));
  return made;
}

GateRefusal refusal_of(const Specification& made) {
  return refused_by(made, small_home(made.simulator)).value_or(GateRefusal{});
}

TEST(Gate, RefusesWhatNoActionOfTheSimulatorBringsAbout) {
  const auto dirty = refusal_of(
      about(Simulator::Ai2thor, "(exists (?a - Mug) (at-end (dirty ?a)))", {"(forall (?a - Mug) (clean ?a))"}));
  EXPECT_EQ(dirty.gate, Gate::Reachable);
  EXPECT_EQ(dirty.about, "(dirty Mug)");
  EXPECT_EQ(dirty.reason, "no action that ai2thor offers, with what the start has, makes (dirty Mug) true");
  const std::string lamp = "(exists (?a - Lamp) (at-end (power_on ?a)))";
  const std::vector<std::string> off = {"(forall (?a - Lamp) (power_off ?a))"};
  EXPECT_EQ(refusal_of(about(Simulator::Habitat, lamp, off)).gate, Gate::Reachable);
  EXPECT_EQ(refused_by(about(Simulator::Ai2thor, lamp, off), small_home(Simulator::Ai2thor)), std::nullopt);
}

TEST(Gate, AToolThatTheStartDoesNotHaveIsNoTool) {
  const std::string sliced = "(exists (?a - Apple) (at-end (sliced ?a)))";
  std::vector<std::string> init = {"(forall (?a - Apple) (whole ?a))"};
  EXPECT_EQ(refusal_of(about(Simulator::Ai2thor, sliced, init)).gate, Gate::Reachable);
  init.push_back("(exists (?k - Knife) (and))");
  EXPECT_EQ(refused_by(about(Simulator::Ai2thor, sliced, init), small_home(Simulator::Ai2thor)), std::nullopt);
}

TEST(Gate, CountsWhatCanBeReached) {
  const auto more = refusal_of(
      about(Simulator::Ai2thor, "(at-end (count >= 3 (?a - Mug) (held ?a)))", {"(count = 2 (?a - Mug) (and))"}));
  EXPECT_EQ(more.gate, Gate::Reachable);
}

TEST(Gate, ARefusalCountsUnderTheGatesName) {
  EXPECT_EQ(name_of(rejection_of(Gate::ExclusiveStates)), "gate-exclusive-states");
  EXPECT_EQ(name_of(rejection_of(Gate::Start)), "gate-start");
}

TEST(Gate, EveryGateHasANameOfItsOwnAndAMeaning) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Gate::Reachable); ++i) {
    EXPECT_TRUE(names.insert(name_of(static_cast<Gate>(i))).second);
    EXPECT_FALSE(meaning_of(static_cast<Gate>(i)).empty());
  }
}

}  // namespace
}  // namespace unietp
