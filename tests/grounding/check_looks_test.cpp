// Whether what the words tell apart can be told apart by eye.
#include "grounding/check_looks.h"

#include <gtest/gtest.h>

#include "homes.h"
#include "scene/trace.h"
#include "simulation/portrait.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

/// What is wrong with "pick up the COLOR mug" where another mug has the color `other`.
std::optional<GroundingFailure> problem_with(const std::string& color, const std::string& other) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  Scene scene;
  scene.simulator = Simulator::Ai2thor;
  for (const std::string& one : {color, other}) {
    Node mug = object_of(knowledge, *knowledge.find("Mug"), static_cast<std::uint32_t>(scene.nodes.size()));
    mug.color = one;
    scene.nodes.push_back(mug);
  }
  Specification asked;
  asked.split = Split::InstanceGrounding;
  asked.goal = parsed("(exists (?a - (Mug :where (colour ?a " + color + "))) (at-end (held ?a)))", FormulaUse::Goal);
  return check_looks(asked, scene, NodeIndex(scene.nodes), to_logic(scene, {}, true));
}

TEST(CheckLooks, RefusesWordsForWhatLooksTheSame) {
  const auto problem = problem_with("clear", "transparent");
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->reason, RejectionReason::LooksAlike);
  EXPECT_EQ(problem->detail, "pictures do not tell object_1 and object_2 by colour");
}

TEST(CheckLooks, AcceptsWordsForWhatIsSeen) { EXPECT_FALSE(problem_with("red", "blue")); }

}  // namespace
}  // namespace unietp
