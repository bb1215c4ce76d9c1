// Whether search was needless is judged from what was known at that moment, not by who knows where everything is.
#include "expert/search_marks.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "expert/belief_expert.h"
#include "expert/mode_expert.h"
#include "expert/window.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::IsEmpty;

void mugs_hidden(Scene& scene) {
  erase_if(scene.nodes, [](const Node& node) { return node.id == "mug_2" || node.id == "mug_3"; });
  mug_in_fridge(scene);
}
void knife_hidden(Scene& scene) { move_to(scene, "knife_1", 4.4, 3.55, 0.9); }

const HouseCase kSearches[] = {
    {"a_mug_in_the_fridge", "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))", mugs_hidden},
    {"a_knife_in_the_fridge", "(exists (?s - Potato/slice) (exists (?b - SideTable) (at-end (on ?s ?b))))",
     knife_hidden},
    {"a_mug_in_sight", "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))"},
};

struct Search : ::testing::TestWithParam<HouseCase> {
  Search() {
    Scene scene = house();
    if (GetParam().edit != nullptr) GetParam().edit(scene);
    start = at_rest(std::move(scene));
    auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
    const auto in_m1 = demonstrate(executions, {});
    auto made = demonstrate_in(Mode::M2, executions, std::get<Demonstration>(in_m1));
    EXPECT_TRUE(std::holds_alternative<Demonstration>(made));
    if (std::holds_alternative<Demonstration>(made)) shown = std::get<Demonstration>(std::move(made));
  }

  /// How many steps were done before a thing came into view.
  std::size_t steps_before_seeing(const std::string& id) const {
    const auto shows = [&id](const DemonstrationStep& step) {
      return std::any_of(step.visible.begin(), step.visible.end(),
                         [&id](const VisibleObject& seen) { return seen.id == id; });
    };
    return static_cast<std::size_t>(std::find_if(shown.steps.begin(), shown.steps.end(), shows) - shown.steps.begin());
  }

  /// When the last thing was seen that it picks up and that was there at the start: M2 is told of nothing movable.
  std::size_t steps_before_all_is_seen() const {
    std::size_t last = 0;
    for (const DemonstrationStep& step : shown.steps) {
      const bool takes =
          step.action.type == ActionType::PickUp && find_node(start, step.action.args.front()) != nullptr;
      if (takes) last = std::max(last, steps_before_seeing(step.action.args.front()));
    }
    return last;
  }

  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Formula wanted = goal(GetParam().goal);
  Scene start;
  Demonstration shown;
};

TEST_P(Search, IsOverAsSoonAsAllThatIsNeededWasSeen) {
  const std::size_t seen = steps_before_all_is_seen();
  for (std::size_t i = seen; i < shown.steps.size(); ++i)
    EXPECT_FALSE(shown.steps[i].search) << to_text(shown.steps[i].action);
}

TEST_P(Search, IsNoneOfTheStepsThatTheGoalCanDoWithout) {
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  EXPECT_THAT(needless_steps(executions, shown), IsEmpty()) << "who knew no better had to look";
  const bool searched =
      std::any_of(shown.steps.begin(), shown.steps.end(), [](const DemonstrationStep& step) { return step.search; });
  EXPECT_TRUE(searched || GetParam().edit == nullptr) << "nothing was hidden";
}

INSTANTIATE_TEST_SUITE_P(InM2, Search, ::testing::ValuesIn(kSearches),
                         [](const auto& param) { return std::string(param.param.name); });

/// Refuses to end.
class Endless : public EpisodeWindow {
 public:
  using EpisodeWindow::EpisodeWindow;
  Outcome act(const Action& action) override {
    if (action.type != ActionType::Stop) return EpisodeWindow::act(action);
    Outcome refused;
    refused.failure = Failure::InvalidAction;
    refused.feedback = "It is over.";
    return refused;
  }
};

TEST(BeliefExpert, GivesUpWhereItMayNotStop) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = at_rest(house());
  const Formula held = goal("(exists (?x - Mug) (at-end (held ?x)))");
  for (const Mode mode : {Mode::M2, Mode::M3}) {
    auto executions = *ExecutionTree::of(held, start, knowledge, profile);
    Endless window(executions, mode);
    const auto trouble = reach_by_belief({held, knowledge, profile, nullptr, mode}, window);
    ASSERT_TRUE(trouble);
    EXPECT_EQ(trouble->text, "for stop(): It is over.");
  }
}

}  // namespace
}  // namespace unietp::testing
