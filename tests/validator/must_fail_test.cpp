// Spoilt plans in each mode. The expert shows the goals; what the validator makes of its plans is its own.
#include "validator/must_fail.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expert/mode_expert.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SpoiltPlans : public ::testing::TestWithParam<Mode> {
 protected:
  std::vector<Action> plan_for(const std::string& text) const {
    auto shown = demonstrate(goal(text), start_, knowledge_, profile_, {});
    if (GetParam() != Mode::M1)
      shown = demonstrate_in(GetParam(), goal(text), start_, knowledge_, profile_, std::get<Demonstration>(shown));
    std::vector<Action> plan;
    for (const DemonstrationStep& step : std::get<Demonstration>(shown).steps)
      if (step.action.type != ActionType::Stop) plan.push_back(step.action);
    return plan;
  }
  MustFail spoilt(const std::string& text, const std::vector<Action>& plan) const {
    const auto world = World::create(start_, knowledge_, profile_);
    return must_fail(goal(text), *world, GetParam(), TraceMaker(start_, false, false), plan, "M.jsonl:1");
  }

  const Knowledge knowledge_ = house_knowledge();
  const Profile profile_ = house_profile();
  const Scene start_ = at_rest(house());
};

constexpr const char* kCooled = "(exists (?x - Mug) (exists (?b - SideTable) (at-end (and (cool ?x) (on ?x ?b)))))";

TEST_P(SpoiltPlans, FailWhereEveryStepIsNeeded) {
  const auto plan = plan_for(kCooled);
  const auto found = spoilt(kCooled, plan);
  EXPECT_THAT(found.problems, IsEmpty());
  EXPECT_GE(found.tried, static_cast<int>(plan.size()));
}

TEST_P(SpoiltPlans, GiveAwayAStepThatIsNotNeeded) {
  auto plan = plan_for(kCooled);
  plan.insert(plan.begin(), Action{ActionType::TurnLeft, {}});
  plan.insert(plan.begin() + 1, Action{ActionType::TurnRight, {}});
  plan.push_back({ActionType::TurnLeft, {}});
  const auto found = spoilt(kCooled, plan);
  ASSERT_FALSE(found.problems.empty());
  EXPECT_EQ(found.problems.back().kind, ProblemKind::NeedlessStep);
  EXPECT_THAT(found.problems.back().error.message, HasSubstr("turn_left"));
}

/// In M3 what a plan points at in another order is not what its looks show then, so that it fails all the same.
class SpoiltOrders : public SpoiltPlans {};

TEST_P(SpoiltOrders, GiveAwayAnOrderThatTheGoalDoesNotNeed) {
  const std::string either =
      "(exists (?x - Apple) (exists (?y - Mug) (exists (?b - SideTable) (and (or (before (on ?x ?b) (on ?y ?b)) "
      "(before (on ?y ?b) (on ?x ?b))) (at-end (and (on ?x ?b) (on ?y ?b)))))))";
  const auto found = spoilt(either, plan_for(either));
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_EQ(found.problems[0].kind, ProblemKind::AnyOrder);
}

INSTANTIATE_TEST_SUITE_P(InEachMode, SpoiltOrders, ::testing::Values(Mode::M1, Mode::M2),
                         [](const auto& mode) { return std::string(name_of(mode.param)); });
INSTANTIATE_TEST_SUITE_P(InEachMode, SpoiltPlans, ::testing::Values(Mode::M1, Mode::M2, Mode::M3),
                         [](const auto& mode) { return std::string(name_of(mode.param)); });

}  // namespace
}  // namespace unietp::testing
