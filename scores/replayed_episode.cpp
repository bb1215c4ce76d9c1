#include "scores/replayed_episode.h"

#include <algorithm>
#include <utility>

#include "core/text.h"
#include "environment/answer.h"
#include "scene/comparisons.h"
#include "scene/pixel_box.h"
#include "scene/trace.h"
#include "scores/goal_objects.h"
#include "simulation/mode_rules.h"

namespace unietp {
namespace {

/// The parts of a goal, each read after every action.
class PartMonitors {
 public:
  explicit PartMonitors(const SharedTask& task)
      : task_(*task),
        scene_(task->start),
        reader_(task->reader),
        facts_(task->facts),
        parts_(scored_parts(task->goal)) {
    for (const ScoredPart& part : parts_) {
      monitors_.emplace_back(part.formula);
      if (can_be_lost(part.kind)) relaxed_.emplace_back(part.relaxed);
    }
    observe();
  }

  void read(const ExecutedAction& action) {
    if (action.moments.empty()) read(action.changes);
    for (const Delta& moment : action.moments) read(moment);
  }
  std::vector<bool> met() const {
    std::vector<bool> answers;
    for (const Monitor& one : monitors_) answers.push_back(one.satisfied());
    return answers;
  }
  std::vector<bool> lost() const {
    std::vector<bool> answers;
    auto relaxed = relaxed_.begin();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const bool relaxed_met = can_be_lost(parts_[i].kind) && (relaxed++)->satisfied();
      answers.push_back(is_lost(parts_[i], monitors_[i].satisfied(), relaxed_met));
    }
    return answers;
  }
  const std::vector<ScoredPart>& parts() const { return parts_; }

 private:
  void read(const Delta& changes) {
    if (changes.empty()) return;
    if (task_.compares_later) {
      scene_ = apply(std::move(scene_), changes);
      facts_ = with_comparisons(reader_.read(scene_), scene_, reader_, task_.compared);
    } else {
      facts_ = reader_.read(std::move(facts_), changes);
    }
    observe();
  }
  void observe() {
    for (Monitor& one : monitors_) one.observe(reader_.entities(), facts_);
    for (Monitor& one : relaxed_) one.observe(reader_.entities(), facts_);
  }
  const EnvironmentTask& task_;
  Scene scene_;  // kept up only where things are compared later on
  FactReader reader_;
  Facts facts_;
  std::vector<ScoredPart> parts_;
  std::vector<Monitor> monitors_, relaxed_;  // relaxed: of the parts that can be lost
};

/// Of what the agent may name where it is told boxes, otherwise of all in the picture.
std::vector<VisibleObject> pictured(const Environment& environment) {
  const auto& boxes = environment.observe().boxes;
  if (!boxes) return environment.pictured();
  std::vector<VisibleObject> seen;
  seen.reserve(boxes->size());
  for (const ObservedObject& object : *boxes) seen.push_back({object.id, object.box});
  return seen;
}

/// What the argument of a command named in the view before it.
void name_object(ReplayedAction& action, const std::vector<VisibleObject>& seen, const Environment& now) {
  if (action.record.command.args.empty()) return;
  const Argument& argument = action.record.command.args.front();
  if (!argument.box) {
    if (now.has_object(argument.id)) action.object = argument.id;
    return;
  }
  action.overlap = 0;
  for (const VisibleObject& object : seen) {
    const double overlap = overlap_of(*argument.box, object.box);
    if (overlap <= *action.overlap) continue;
    action.overlap = overlap;
    if (overlap > kLeastOverlap) action.object = object.id;
  }
}

}  // namespace

struct EpisodeFollower::State {
  State(const SharedTask& task, bool keeps) : monitors(task), unseen(goal_objects(*task)), keeps_views(keeps) {}

  /// Strikes out what is in the picture now. What the agent is told is looked at first, since it is there already.
  void show(const Environment& now) {
    const auto& boxes = now.observe().boxes;
    const auto has_box = [&](const std::string& id) {
      if (!boxes) return false;
      const auto place =
          std::lower_bound(boxes->begin(), boxes->end(), id,
                           [](const ObservedObject& object, const auto& name) { return object.id < name; });
      return place != boxes->end() && place->id == id;
    };
    std::erase_if(unseen, [&](const GoalObjects& wanted) {
      return std::any_of(wanted.referents.begin(), wanted.referents.end(), has_box) ||
             std::any_of(wanted.referents.begin(), wanted.referents.end(),
                         [&](const auto& id) { return now.pictures(id); });
    });
  }

  PartMonitors monitors;
  std::vector<GoalObjects> unseen;  // those of which nothing was in a picture so far
  ReplayedEpisode episode;
  std::vector<VisibleObject> seen;  // before an action that names a place in the picture
  bool keeps_views;
};

EpisodeFollower::EpisodeFollower(EpisodeFollower&&) noexcept = default;
EpisodeFollower& EpisodeFollower::operator=(EpisodeFollower&&) noexcept = default;
EpisodeFollower::~EpisodeFollower() = default;

EpisodeFollower::EpisodeFollower(const Environment& start, bool keeps_views)
    : state_(std::make_unique<State>(start.task(), keeps_views)) {
  ReplayedEpisode& episode = state_->episode;
  episode.parts = state_->monitors.parts();
  episode.parts_at_start = state_->monitors.met();
  episode.start_progress = start.progress();
  episode.first_observation = start.text();
}

void EpisodeFollower::begin_reply(const Environment& now) {
  state_->show(now);
  state_->episode.steps.emplace_back();
  if (state_->keeps_views) state_->episode.steps.back().pictured = pictured(now);
}

void EpisodeFollower::look(const AnsweredAction& next, const Environment& now) {
  const auto& args = next.command.args;
  const bool names_place = next.point.has_value() || std::any_of(args.begin(), args.end(), [](const Argument& one) {
                             return one.box.has_value();
                           });
  if (names_place) state_->seen = pictured(now);
}

void EpisodeFollower::acted(const StepResult& result, const Environment& now) {
  for (const ExecutedAction& executed : result.executed) {
    ReplayedAction action;
    action.record = {
        executed.command,          executed.outcome.success, std::string(name_of(executed.outcome.failure)),
        executed.outcome.feedback, executed.counted,         executed.simulator};
    name_object(action, state_->seen, now);
    state_->monitors.read(executed);
    action.progress = now.progress();
    action.reached = action.progress >= 1;
    action.parts = state_->monitors.met();
    state_->episode.steps.back().actions.push_back(std::move(action));
  }
}

void EpisodeFollower::end_reply(const std::string& unreadable, const Environment& now) {
  ReplayedStep& step = state_->episode.steps.back();
  step.unreadable = unreadable;
  step.observation = now.text();
}

ReplayedEpisode EpisodeFollower::finish(const Environment& last) && {
  state_->show(last);
  ReplayedEpisode episode = std::move(state_->episode);
  episode.targets_shown = state_->unseen.empty();
  const PrivilegedState state = last.privileged();
  if (const auto end = outcome_named(state.ended_by)) episode.end = *end;
  episode.success = last.over() && state.success;
  episode.progress = state.progress;
  episode.counted = state.steps;
  episode.failures = state.failures;
  episode.parts_lost = state_->monitors.lost();
  return episode;
}

namespace {

/// Says again what a simulator said in an episode.
class RecordedSimulator : public ActingSimulator {
 public:
  explicit RecordedSimulator(const EpisodeRecord& record) {
    for (const EpisodeStep& step : record.steps) {
      for (const EpisodeAction& action : step.actions) {
        if (action.simulator) answers_.push_back(*action.simulator);
      }
    }
  }
  bool empty() const { return answers_.empty(); }
  Result<Done> begin(const EnvironmentTask&) override {
    next_ = 0;
    return Done{};
  }
  Result<SimulatorAnswer> act(const Action& action, const Scene&, const Delta&) override {
    if (next_ < answers_.size()) return answers_[next_++];
    return Error{Error::Kind::Schema, "", {}, "the record does not have what the simulator said of " + to_text(action)};
  }

 private:
  std::vector<SimulatorAnswer> answers_;
  std::size_t next_ = 0;
};

/// One reply, each of its actions for itself.
void execute(const std::string& reply, Environment& environment, EpisodeFollower& follower) {
  follower.begin_reply(environment);
  const Observation& now = environment.observe();
  const auto answer = parse_answer(reply, {environment.settings().box_form, now.image_width, now.image_height});
  if (!answer) {
    follower.acted(environment.step(reply), environment);
    follower.end_reply(answer.error().message, environment);
    return;
  }
  for (const AnsweredAction& said : answer->actions) {
    follower.look(said, environment);
    const auto result = environment.step(Answer{{said}, ""});
    if (result.executed.empty()) break;
    follower.acted(result, environment);
    const bool failed = !result.executed.back().outcome.success;
    if (environment.over() || (failed && environment.settings().on_fail == OnFail::Stop)) break;
  }
  follower.end_reply("", environment);
}

}  // namespace

Result<ReplayedEpisode> replay_episode(const EpisodeRecord& record, const SharedTask& task, const Settings& settings,
                                       const WatchEpisode& watch) {
  auto recorded = std::make_shared<RecordedSimulator>(record);
  auto environment = Environment::make(task, settings, recorded->empty() ? nullptr : SharedSimulator(recorded));
  if (!environment) return environment.error();
  EpisodeFollower follower(*environment, static_cast<bool>(watch));
  std::size_t done = 0;
  for (; done < record.steps.size() && !environment->over(); ++done) {
    if (watch) watch(done, *environment);
    execute(record.steps[done].reply, *environment, follower);
  }
  if (watch) watch(done, *environment);
  return std::move(follower).finish(*environment);
}

}  // namespace unietp
