// Episodes that are acted out in a simulator, too: it may refuse what our physics allow, and its state is judged.
#include "environment/acting_simulator.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "environment/environment.h"
#include "expert/mode_expert.h"
#include "tests/environment/house_task.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;
using testing::house_task;

const SharedTask& the_task() {
  static const SharedTask kTask = house_task();
  return kTask;
}

/// Does what another environment does, but for one action, which it refuses, forgets, tells two stories of, or breaks
/// at.
class Twin : public ActingSimulator {
 public:
  enum class Whim { None, Refuses, Forgets, Contradicts, Breaks };
  explicit Twin(Whim whim = Whim::None, ActionType at = ActionType::Stop) : whim_(whim), at_(at) {}

  Result<Done> begin(const EnvironmentTask&) override {
    auto made = Environment::make(the_task(), settings_for(Mode::M1));
    if (!made) return made.error();
    own_.emplace(std::move(*made));
    return Done{};
  }
  Result<SimulatorAnswer> act(const Action& action, const Scene& now, const Delta& ours) override {
    EXPECT_EQ(now.edges, edges_);
    if (action.type == at_ && whim_ == Whim::Breaks) return Error{Error::Kind::Io, "twin", {}, "is gone"};
    if (action.type == at_ && whim_ == Whim::Refuses) return SimulatorAnswer{false, "it is glued", {}};
    Command command{std::string(info(action.type).name), {}};
    for (const std::string& id : action.args) command.args.push_back({id, std::nullopt});
    const StepResult result = own_->step(command);
    EXPECT_EQ(ours, result.executed.front().changes) << "what the action did in our physics is told";
    SimulatorAnswer answer{true, "", result.executed.front().changes, result.executed.front().moments};
    if (action.type == at_ && whim_ == Whim::Forgets) answer.changes = {}, answer.moments.clear();
    if (action.type == at_ && whim_ == Whim::Contradicts) answer.moments = {Delta{}, Delta{}};
    edges_ = apply(now, answer.changes).edges;
    return answer;
  }

 private:
  Whim whim_;
  ActionType at_;
  std::optional<Environment> own_;
  EdgeSet edges_ = the_task()->start.edges;
};

Environment in_twin(Twin::Whim whim = Twin::Whim::None, ActionType at = ActionType::Stop) {
  auto made = Environment::make(the_task(), settings_for(Mode::M1), std::make_shared<Twin>(whim, at));
  if (!made) throw std::runtime_error(format(made.error()));
  return std::move(*made);
}

/// The expert's.
const std::vector<Command>& plan() {
  static const std::vector<Command> kPlan = [] {
    const EnvironmentTask& task = *the_task();
    const auto shown = demonstrate(task.goal, task.start, *task.data.knowledge, *task.data.profile, {});
    std::vector<Command> commands;
    for (const DemonstrationStep& step : std::get<Demonstration>(shown).steps) commands.push_back(step.command);
    return commands;
  }();
  return kPlan;
}

TEST(AnActingSimulator, ThatDoesTheSameGivesTheSameEpisode) {
  Environment ours = std::move(*Environment::make(the_task(), settings_for(Mode::M1)));
  Environment theirs = in_twin();
  for (const Command& command : plan()) {
    const StepResult a = ours.step(command), b = theirs.step(command);
    EXPECT_EQ(a.executed.front().changes, b.executed.front().changes);
    EXPECT_EQ(b.executed.front().simulator.has_value(), command.action != "stop");
    EXPECT_EQ(ours.scene(), theirs.scene());
    EXPECT_EQ(ours.progress(), theirs.progress());
  }
  EXPECT_TRUE(theirs.over() && theirs.privileged().success);
}

TEST(AnActingSimulator, IsWhatTheGoalIsJudgedOn) {
  Environment environment = in_twin(Twin::Whim::Forgets, ActionType::PlaceOn);
  for (const Command& command : plan()) EXPECT_TRUE(environment.step(command).executed.front().outcome.success);
  EXPECT_TRUE(environment.over());
  EXPECT_FALSE(environment.privileged().success) << "there the mug was never put down";
}

TEST(AnActingSimulator, MayRefuseWhatOurPhysicsAllow) {
  Environment environment = in_twin(Twin::Whim::Refuses, ActionType::PickUp);
  for (const Command& command : plan()) {
    const auto held = environment.observe().held;
    const StepResult result = environment.step(command);
    const Outcome& outcome = result.executed.front().outcome;
    if (command.action != "pick_up") continue;
    EXPECT_FALSE(outcome.success);
    EXPECT_EQ(outcome.failure, Failure::NotOffered);
    EXPECT_EQ(outcome.feedback, "The simulator refuses: it is glued");
    EXPECT_EQ(environment.observe().held, held) << "our physics go back, too";
    EXPECT_EQ(environment.privileged().failures, 1);
    break;
  }
}

TEST(AnActingSimulator, WhoseMomentsLeadElsewhereThanItsChangesIsNotBelieved) {
  Environment environment = in_twin(Twin::Whim::Contradicts, ActionType::PickUp);
  for (const Command& command : plan()) {
    const StepResult result = environment.step(command);
    if (command.action == "pick_up") {
      EXPECT_TRUE(result.executed.empty());
      break;
    }
    EXPECT_EQ(environment.broken(), "");
  }
  EXPECT_THAT(environment.broken(), HasSubstr("moments that do not lead to what changed"));
}

TEST(AnActingSimulator, ThatBreaksEndsTheEpisodeWithoutAStep) {
  Environment environment = in_twin(Twin::Whim::Breaks, ActionType::PickUp);
  std::size_t executed = 1;
  for (const Command& command : plan()) {
    executed = environment.step(command).executed.size();
    if (command.action == "pick_up") break;
  }
  EXPECT_EQ(executed, 0U);
  EXPECT_THAT(environment.broken(), HasSubstr("is gone"));
  EXPECT_TRUE(environment.step(plan().front()).executed.empty());
}

}  // namespace
}  // namespace unietp
