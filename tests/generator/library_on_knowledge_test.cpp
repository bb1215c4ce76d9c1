#include <gtest/gtest.h>

#include <algorithm>

#include "generator/goal_parts.h"
#include "generator/specification.h"
#include "logic/evaluate.h"
#include "small_home.h"

namespace unietp {
namespace {

/// The property that the whole pipeline rests on: whoever meets the start constraints has not done any of the work.
TEST(LibraryOnKnowledge, NoPartOfAGoalHoldsInAnyStartThatMeetsItsConstraints) {
  const auto knowledge = small_home(Simulator::Ai2thor);
  for (const auto& source : library()) {
    SCOPED_TRACE(source.name);
    std::size_t starts = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const auto binding = sample_binding(source, knowledge, {}, Rng(seed));
      ASSERT_TRUE(binding);
      const auto made = instantiate(source, knowledge, *binding);
      ASSERT_TRUE(made) << format(made.error());
      for (const auto& start : starts_by_rejection(*made, knowledge, Rng(seed).fork("starts", 0), 1500)) {
        ++starts;
        ASSERT_FALSE(holds(made->goal, start));
        for (const auto& part : goal_parts(made->goal)) ASSERT_FALSE(holds(part, start)) << to_text(part);
        EXPECT_TRUE(empty_domains(made->goal, start).empty() || source.name == "slice-and-place-on");
      }
    }
    EXPECT_GE(starts, 20U) << "too few random starts met the constraints for the test to say anything";
  }
}

TEST(LibraryOnKnowledge, EveryBindingOfEveryTemplateCanBeInstantiated) {
  for (const auto simulator : kSimulators) {
    const auto knowledge = small_home(simulator);
    for (const auto& source : library()) {
      const auto bindings = enumerate_bindings(source, knowledge, 12);
      const bool meant =
          std::find(source.simulators.begin(), source.simulators.end(), simulator) != source.simulators.end();
      EXPECT_EQ(!bindings.empty(), meant) << source.name;
      for (const auto& binding : bindings) {
        const auto made = instantiate(source, knowledge, binding);
        EXPECT_TRUE(made) << source.name << ": " << format(made.error());
      }
    }
  }
}

}  // namespace
}  // namespace unietp
