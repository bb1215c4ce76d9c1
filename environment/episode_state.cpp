#include "environment/episode_state.h"

#include <array>
#include <utility>

#include "environment/agent_information.h"

namespace unietp {
namespace {

constexpr std::size_t kActionsKept = 1000;  // that an expert would retrace

std::shared_ptr<const Profile> profile_of(const EnvironmentTask& task, const Settings& settings) {
  if (settings.image_width == 0 && settings.image_height == 0) return task.data.profile;
  auto profile = std::make_shared<Profile>(*task.data.profile);
  if (settings.image_width != 0) profile->image_width = settings.image_width;
  if (settings.image_height != 0) profile->image_height = settings.image_height;
  return profile;
}

/// Whether the moments of an answer end in the state that its changes say.
bool leads_to_its_changes(const Scene& before, const SimulatorAnswer& answer) {
  if (answer.moments.empty()) return true;
  Scene then = before;
  for (const Delta& moment : answer.moments) then = apply(std::move(then), moment);
  return difference(then, apply(before, answer.changes)).empty();
}

}  // namespace

std::string_view name_of(EpisodeEnd end) {
  static constexpr std::array<std::string_view, 5> kNames{"", "stop", "failures", "steps", "answers"};
  return kNames[static_cast<std::size_t>(end)];
}

Result<std::unique_ptr<EpisodeState>> EpisodeState::begin(const SharedTask& task, const Settings& settings,
                                                          SharedSimulator simulator) {
  auto profile = profile_of(*task, settings);
  auto world = World::create(task->start, *task->data.knowledge, *profile, task->known);
  if (!world) return world.error();
  Observation first;
  first.instruction = task->text.instruction;
  first.home = home_information(*world, settings);
  auto state = std::make_unique<EpisodeState>(
      EpisodeState{task, settings, std::move(profile), ModeEpisode(std::move(*world), settings.rules), task->reader,
                   task->facts, task->monitor, std::vector<Action>(), 0, std::move(first), Rays()});
  state->episode.forget();  // the scene that the lists were made from
  state->observe({});
  if (simulator) {
    state->theirs = task->start;
    if (auto begun = simulator->begin(*task); !begun) state->broken = format(begun.error());
    state->simulator = std::move(simulator);
  }
  return state;
}

std::unique_ptr<EpisodeState> EpisodeState::apart() const {
  return std::make_unique<EpisodeState>(EpisodeState{task, settings, profile, episode.apart(), reader, facts, monitor,
                                                     done, answered, observation, Rays(), simulator, theirs, broken});
}

EpisodeEnd EpisodeState::end() const {
  const StepLimits& limits = settings.rules.limits;
  if (episode.world().stopped()) return EpisodeEnd::Stop;
  if (episode.failures() >= limits.failures) return EpisodeEnd::Failures;
  if (episode.steps() >= limits.steps) return EpisodeEnd::Steps;
  // Invalid actions that are free must not go on for ever: the released runner ends after twice the steps.
  if (settings.rules.invalid_is_free && answered / 2 >= limits.steps) return EpisodeEnd::Answers;
  return EpisodeEnd::None;
}

std::optional<SimulatorAnswer> EpisodeState::ask(const Action& action, const Delta& ours) {
  auto answer = simulator->act(action, theirs, ours);
  if (!answer) {
    broken = format(answer.error());
    return std::nullopt;
  }
  if (answer->success && !leads_to_its_changes(theirs, *answer)) {
    broken = "the simulator tells moments that do not lead to what changed as a whole";
    return std::nullopt;
  }
  if (answer->success) read_theirs(*answer);
  return std::move(*answer);
}

void EpisodeState::read(const Delta& changes, const Scene* scene) {
  facts = scene != nullptr ? with_comparisons(reader.read(*scene), *scene, reader, task->compared)
                           : reader.read(std::move(facts), changes);
  monitor.observe(reader.entities(), facts);
}

void EpisodeState::read_own() {
  const World& world = episode.world();
  for (const PassedMoment& passed : world.passed()) {
    const World then = world.at(passed.moment);
    read(passed.changes, task->compares_later ? &then.scene() : nullptr);
  }
  if (world.passed().empty() && !world.changes().empty())
    read(world.changes(), task->compares_later ? &world.scene() : nullptr);
}

void EpisodeState::read_theirs(const SimulatorAnswer& answer) {
  const auto next = [this](const Delta& changes) {
    if (changes.empty()) return;
    theirs = apply(std::move(theirs), changes);
    read(changes, task->compares_later ? &theirs : nullptr);
  };
  if (answer.moments.empty()) next(answer.changes);
  for (const Delta& moment : answer.moments) next(moment);
}

void EpisodeState::observe(std::vector<ActionReport> results) {
  const StepLimits& limits = settings.rules.limits;
  Observation& o = observation;
  if (settings.rules.boxes) o.boxes = visible_objects(episode);
  // Without feedback it would tell which steps succeeded.
  if (settings.floor_plan && settings.feedback != Feedback::None) o.pose = own_pose(episode.world().agent());
  if (!results.empty()) o.last = results.back();
  o.results = std::move(results);
  o.step = episode.steps();
  o.steps_left = limits.steps - episode.steps();
  if (settings.feedback != Feedback::None) {
    o.held = held_objects(episode.world(), settings.rules);
    o.failures_left = limits.failures - episode.failures();
  }
  o.has_picture = settings.rules.picture;
  o.image_width = profile->image_width;
  o.image_height = profile->image_height;
  o.over = end() != EpisodeEnd::None;
}

StepInProgress::StepInProgress(EpisodeState& state) : state_(state), was_over_(state.observation.over) {
  if (state.settings.reward == Reward::Progress) progress_before_ = state.monitor.progress();
}

bool StepInProgress::goes_on() const {
  return state_.broken.empty() && state_.end() == EpisodeEnd::None &&
         !(failed_ && state_.settings.on_fail == OnFail::Stop);
}

/// With the object that the picture shows at a point named as the rules want it.
Command StepInProgress::command_of(const AnsweredAction& action) {
  Command command = action.command;
  if (!action.point) return command;
  const World& world = state_.episode.world();
  Argument argument{"", PixelBox{1, 1, 0, 0}};  // which holds no pixel
  if (const Node* node = world.pictured_at(action.point->x, action.point->y, state_.rays)) {
    for (const VisibleObject& object : world.pictured()) {
      if (object.id == node->id) argument.box = object.box;
    }
  }
  command.args.push_back(std::move(argument));
  return command;
}

void StepInProgress::act(const AnsweredAction& action) {
  Command command = command_of(action);
  ModeEpisode& episode = state_.episode;
  const int steps_before = episode.steps();
  std::optional<ModeEpisode> kept;  // to go back to when the simulator refuses
  if (state_.simulator) kept = episode.apart();
  Outcome outcome = episode.step(command);
  Delta changes;
  std::vector<Delta> moments;
  std::optional<SimulatorAnswer> theirs;
  if (!state_.simulator && outcome.success) {
    changes = episode.world().changes();
    if (!episode.world().passed().empty()) moments = episode.world().changes_by_moment();
    state_.read_own();
  } else if (state_.simulator && outcome.success && !episode.world().stopped()) {
    theirs = state_.ask(episode.last_action(), episode.world().changes());
    if (!theirs) return;
    if (theirs->success) {
      changes = theirs->changes;
      moments = theirs->moments;
    } else {
      episode = std::move(*kept);
      outcome = episode.refuse("");
      outcome.failure = Failure::NotOffered;
      outcome.feedback = "The simulator refuses: " + theirs->message;
    }
  }
  if (outcome.success && state_.done) {
    // As the world took it: where it was named by a box, that box says nothing of later pictures.
    state_.done->push_back(episode.last_action());
    if (state_.done->size() > kActionsKept) state_.done.reset();
  }
  note(std::move(command), std::move(outcome), std::move(changes), steps_before);
  result_.executed.back().moments = std::move(moments);
  result_.executed.back().simulator = std::move(theirs);
}

void StepInProgress::refuse(std::string_view expected) {
  const int steps_before = state_.episode.steps();
  note({}, state_.episode.refuse(expected), {}, steps_before);
}

void StepInProgress::note(Command command, Outcome outcome, Delta changes, int steps_before) {
  ++state_.answered;
  failed_ = !outcome.success;
  reports_.push_back(report_of(command, outcome, state_.episode.world(), state_.settings, state_.frame()));
  result_.executed.push_back(
      {std::move(command), std::move(outcome), std::move(changes), state_.episode.steps() > steps_before});
  state_.episode.forget();
}

StepResult StepInProgress::finish() && {
  if (!reports_.empty()) state_.observe(std::move(reports_));
  result_.observation = state_.observation;
  const EpisodeEnd end = state_.end();
  result_.terminated = end == EpisodeEnd::Stop || end == EpisodeEnd::Failures;
  result_.truncated = end == EpisodeEnd::Steps || end == EpisodeEnd::Answers;
  if (was_over_) return std::move(result_);
  if (state_.settings.reward == Reward::Progress) {
    result_.reward = state_.monitor.progress() - progress_before_;
  } else if (end != EpisodeEnd::None) {
    result_.reward = state_.monitor.satisfied() ? 1 : 0;
  }
  return std::move(result_);
}

}  // namespace unietp
