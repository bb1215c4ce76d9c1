#include "exports/sft_mistakes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/rng.h"
#include "environment/environment.h"
#include "exports/sft_reasoning.h"

namespace unietp {
namespace {

constexpr std::size_t kAhead = 3;  // how many of the next manipulations may be tried too early

/// What a mistake can be told by. Others, such as a thing that was not seen yet, are no mistake that a demonstration
/// would make.
constexpr std::array kTelling{Failure::TooFar,           Failure::NotVisible, Failure::InsideClosed,
                              Failure::ReceptacleClosed, Failure::HandsFull,  Failure::NotHolding,
                              Failure::MustBeClosed,     Failure::Blocked,    Failure::VesselEmpty};

bool is_manipulation(const StepRecord& step) {
  const auto type = action_named(step.command.action);
  return type && info(*type).group != ActionClass::Movement && info(*type).group != ActionClass::Control;
}

class MistakeMaker {
 public:
  MistakeMaker(Environment environment, const DemonstrationRecord& right, Mode mode, double rate, Rng rng)
      : environment_(std::move(environment)), right_(right), boxes_(mode == Mode::M3), rate_(rate), rng_(rng) {}

  /// nullopt when the rest no longer works after something was put back.
  std::optional<MistakenDemonstration> make() {
    made_.shown.task = right_.task;
    made_.shown.mode = right_.mode;
    made_.shown.shortest = right_.shortest;
    made_.shown.tempting = right_.tempting;
    double reward = 0;
    for (std::size_t i = 0; i < right_.steps.size(); ++i) {
      if (rng_.chance(rate_)) err(i);
      const StepResult result = act(right_.steps[i].command, false, right_.steps[i]);
      if (!result.executed.front().outcome.success) return std::nullopt;
      reward = result.reward;
    }
    return reward == 1 ? std::optional(std::move(made_)) : std::nullopt;
  }

 private:
  /// Room is left for two more steps and a failure.
  bool may_err(std::size_t i) const {
    const Observation& now = environment_.observe();
    const auto rest = static_cast<int>(right_.steps.size() - i);
    return now.steps_left >= rest + 2 && now.failures_left.value_or(0) > 1;
  }

  void err(std::size_t i) {
    if (!may_err(i)) return;
    const bool picks = right_.steps[i].command.action == info(ActionType::PickUp).name;
    if (!boxes_ && picks && rng_.chance(0.5) && take_another(object_of(right_.steps[i]))) return;
    std::vector<std::size_t> later;
    for (std::size_t k = i + 1; k < right_.steps.size() && later.size() < kAhead; ++k) {
      if (is_manipulation(right_.steps[k])) later.push_back(k);
    }
    rng_.shuffle(later);
    for (const bool any : {false, true}) {  // else nearly all would be too far away, or with empty hands
      for (const std::size_t k : later) {
        if (try_early(right_.steps[k], any)) return;
      }
    }
  }

  /// `any`: also from too far away or with empty hands.
  bool try_early(const StepRecord& later, bool any) {
    std::optional<Command> command = later.command;
    if (boxes_ && !command->args.empty()) {
      const std::string id = object_of(later);
      const auto& view = environment_.pictured();
      const auto seen = std::find_if(view.begin(), view.end(), [&](const VisibleObject& one) { return one.id == id; });
      if (seen == view.end()) return false;
      command->args.front().box = seen->box;
    }
    const auto before = environment_.snapshot();
    const MistakenDemonstration made = made_;
    const Outcome outcome = act(*command, true).executed.front().outcome;
    const bool common = outcome.failure == Failure::TooFar || outcome.failure == Failure::NotHolding;
    const bool tells = std::find(kTelling.begin(), kTelling.end(), outcome.failure) != kTelling.end();
    if (!outcome.success && tells && (any || !common)) return true;
    environment_.restore(before);
    made_ = made;
    return false;
  }

  /// Picks up another thing in view, of the same kind where there is one, and puts it back.
  bool take_another(const std::string& wanted) {
    const Scene scene = environment_.scene();  // a step ends a reference
    const Node* right = find_node(scene, wanted);
    std::vector<std::pair<bool, std::string>> others;
    for (const ObservedObject& seen : environment_.observe().boxes.value_or(std::vector<ObservedObject>())) {
      const Node* node = find_node(scene, seen.id);
      if (node == nullptr || !node->movable || seen.id == wanted) continue;
      others.emplace_back(right == nullptr || node->category != right->category, seen.id);
    }
    std::sort(others.begin(), others.end());
    const auto before = environment_.snapshot();
    const MistakenDemonstration made = made_;
    for (const auto& [unlike, id] : others) {
      const auto place = place_of(scene, id);
      if (!place ||
          !act({std::string(info(ActionType::PickUp).name), {{id, {}}}}, true).executed.front().outcome.success ||
          !act(*place, false).executed.front().outcome.success) {
        environment_.restore(before);
        made_ = made;
        continue;
      }
      return true;
    }
    return false;
  }

  /// The action that puts a thing back where it is.
  static std::optional<Command> place_of(const Scene& scene, const std::string& id) {
    for (const Edge& edge : scene.edges) {
      if (edge.from != id || (edge.relation != Predicate::On && edge.relation != Predicate::Inside)) continue;
      const ActionType put = edge.relation == Predicate::On ? ActionType::PlaceOn : ActionType::PlaceIn;
      return Command{std::string(info(put).name), {{edge.to, {}}}};
    }
    return std::nullopt;
  }

  /// `marks`: a step with the marks that it gets.
  StepResult act(const Command& command, bool mistake, const StepRecord& marks = {}) {
    StepRecord step;
    step.command = command;
    step.search = marks.search;
    step.tidying = marks.tidying;
    if (boxes_) {
      step.visible = environment_.pictured();
    } else {
      for (const ObservedObject& seen : environment_.observe().boxes.value_or(std::vector<ObservedObject>()))
        step.visible.push_back({seen.id, seen.box});
    }
    StepResult result = environment_.step(command);
    if (result.executed.empty()) result.executed.emplace_back();  // the episode is over
    const ExecutedAction& executed = result.executed.front();
    step.success = executed.outcome.success;
    step.failure = executed.outcome.success ? "" : name_of(executed.outcome.failure);
    step.feedback = executed.outcome.feedback;
    step.changes = executed.changes;
    step.moments = executed.moments;
    made_.shown.steps.push_back(std::move(step));
    made_.mistakes.push_back(mistake);
    return result;
  }

  Environment environment_;
  const DemonstrationRecord& right_;
  const bool boxes_;
  const double rate_;
  Rng rng_;
  MistakenDemonstration made_;
};

/// Shares what somebody else keeps alive.
template <class T>
std::shared_ptr<const T> borrowed(const T* value) {
  return {std::shared_ptr<const void>(), value};
}

}  // namespace

Result<MistakenDemonstration> with_mistakes(const FinishedTask& task, Mode mode, const ValidationBackend& backend,
                                            double rate) {
  const DemonstrationRecord& right = task.shown.at(mode);
  TaskText text{task.record.id,     task.record.instruction, task.record.split, task.record.template_name,
                task.record.layout, task.record.goal_text,   task.record.expert};
  auto prepared = prepare_task(std::move(text), task.start, {borrowed(backend.knowledge), borrowed(backend.profile)});
  if (!prepared) return prepared.error();
  auto environment = Environment::make(*prepared, settings_for(mode));
  if (!environment) return environment.error();
  const Rng rng = Rng(task.record.run).fork(task.record.id, static_cast<std::uint64_t>(mode));
  auto made = MistakeMaker(std::move(*environment), right, mode, rate, rng).make();
  if (made) return std::move(*made);
  return MistakenDemonstration{right, std::vector<bool>(right.steps.size(), false)};
}

}  // namespace unietp
