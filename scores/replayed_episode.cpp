#include "scores/replayed_episode.h"

#include <algorithm>
#include <utility>

#include "core/text.h"
#include "environment/answer.h"
#include "scene/comparisons.h"
#include "scene/pixel_box.h"
#include "scene/trace.h"
#include "simulation/mode_rules.h"

namespace unietp {
namespace {

/// The parts of a goal, each read after every action.
class PartMonitors {
 public:
  explicit PartMonitors(const SharedTask& task)
      : task_(*task), reader_(task->reader), facts_(task->facts), parts_(scored_parts(task->goal)) {
    for (const ScoredPart& part : parts_) {
      monitors_.emplace_back(part.formula);
      relaxed_.emplace_back(part.relaxed);
    }
    observe();
  }

  void read(const Delta& changes, const Scene& scene) {
    if (changes.empty()) return;
    facts_ = task_.compares_later ? with_comparisons(reader_.read(scene), scene, reader_, task_.compared)
                                  : reader_.read(std::move(facts_), changes);
    observe();
  }
  std::vector<bool> met() const {
    std::vector<bool> answers;
    for (const Monitor& one : monitors_) answers.push_back(one.satisfied());
    return answers;
  }
  std::vector<bool> lost() const {
    std::vector<bool> answers;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      answers.push_back(is_lost(parts_[i], monitors_[i].satisfied(), relaxed_[i].satisfied()));
    return answers;
  }
  const std::vector<ScoredPart>& parts() const { return parts_; }

 private:
  void observe() {
    for (Monitor& one : monitors_) one.observe(reader_.entities(), facts_);
    for (Monitor& one : relaxed_) one.observe(reader_.entities(), facts_);
  }
  const EnvironmentTask& task_;
  FactReader reader_;
  Facts facts_;
  std::vector<ScoredPart> parts_;
  std::vector<Monitor> monitors_, relaxed_;
};

/// With categories; of what the agent may name where it is told boxes, otherwise of all in the picture.
std::vector<SeenObject> pictured(const Environment& environment) {
  if (environment.observe().boxes) return *environment.observe().boxes;
  std::vector<SeenObject> seen;
  for (const VisibleObject& object : environment.pictured()) {
    const auto& nodes = environment.scene().nodes;
    const auto node = std::find_if(nodes.begin(), nodes.end(), [&](const Node& one) { return one.id == object.id; });
    seen.push_back({object.id, node == nodes.end() ? "" : node->category, object.box});
  }
  return seen;
}

/// What the argument of a command named in the view before it.
void name_object(ReplayedAction& action, const std::vector<SeenObject>& seen, const Scene& scene) {
  if (action.record.command.args.empty()) return;
  const Argument& argument = action.record.command.args.front();
  if (!argument.box) {
    const bool known =
        std::any_of(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) { return node.id == argument.id; });
    if (known) action.object = argument.id;
    return;
  }
  action.overlap = 0;
  for (const SeenObject& object : seen) {
    const double overlap = overlap_of(*argument.box, object.box);
    if (overlap <= *action.overlap) continue;
    action.overlap = overlap;
    if (overlap > kLeastOverlap) action.object = object.id;
  }
}

class Replay {
 public:
  Replay(Environment& environment, const SharedTask& task) : environment_(environment), monitors_(task) {}

  ReplayedStep step(const EpisodeStep& recorded) {
    ReplayedStep done;
    done.pictured = pictured(environment_);
    const Observation& now = environment_.observe();
    const auto answer =
        parse_answer(recorded.reply, {environment_.settings().box_form, now.image_width, now.image_height});
    if (!answer) {
      done.unreadable = answer.error().message;
      take(done, environment_.step(recorded.reply), done.pictured);
    } else {
      std::vector<SeenObject> seen = done.pictured;
      for (const SaidAction& said : answer->actions) {
        const auto result = environment_.step(Answer{{said}, ""});
        if (result.executed.empty()) break;
        take(done, result, seen);
        const bool failed = !result.executed.back().outcome.success;
        if (environment_.over() || (failed && environment_.settings().on_fail == OnFail::Stop)) break;
        seen = pictured(environment_);
      }
    }
    done.told = environment_.text();
    return done;
  }
  const PartMonitors& monitors() const { return monitors_; }

 private:
  void take(ReplayedStep& done, const StepResult& result, const std::vector<SeenObject>& seen) {
    for (const ExecutedAction& executed : result.executed) {
      ReplayedAction action;
      action.record = {executed.command, executed.outcome.success, std::string(name_of(executed.outcome.failure)),
                       executed.outcome.feedback, executed.counted};
      name_object(action, seen, environment_.scene());
      monitors_.read(executed.changes, environment_.scene());
      const PrivilegedState state = environment_.privileged();
      action.progress = state.progress;
      action.reached = state.success;
      action.parts = monitors_.met();
      done.actions.push_back(std::move(action));
    }
  }

  Environment& environment_;
  PartMonitors monitors_;
};

}  // namespace

Result<ReplayedEpisode> replay_episode(const EpisodeRecord& record, const SharedTask& task, const Settings& settings,
                                       const WatchEpisode& watch) {
  auto environment = Environment::make(task, settings);
  if (!environment) return environment.error();
  Replay replay(*environment, task);
  ReplayedEpisode episode;
  episode.parts = replay.monitors().parts();
  episode.parts_at_start = replay.monitors().met();
  episode.start_progress = environment->privileged().progress;
  episode.first_told = environment->text();
  const auto show = [&] {
    for (const VisibleObject& object : environment->pictured()) episode.shown.insert(object.id);
  };
  for (std::size_t i = 0; i < record.steps.size() && !environment->over(); ++i) {
    show();
    if (watch) watch(i, *environment);
    episode.steps.push_back(replay.step(record.steps[i]));
  }
  show();
  if (watch) watch(episode.steps.size(), *environment);
  const PrivilegedState last = environment->privileged();
  if (const auto end = outcome_named(last.ended_by)) episode.end = *end;
  episode.success = environment->over() && last.success;
  episode.progress = last.progress;
  episode.counted = last.steps;
  episode.failures = last.failures;
  episode.parts_lost = replay.monitors().lost();
  return episode;
}

}  // namespace unietp
