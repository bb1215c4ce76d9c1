#include "environment/environment.h"

#include <utility>

#include "core/limits.h"
#include "environment/agent_information.h"
#include "environment/agent_text.h"
#include "environment/episode_state.h"
#include "expert/execution.h"

namespace unietp {

Environment::Environment(std::unique_ptr<EpisodeState> state) : state_(std::move(state)) {}
Environment::Environment(Environment&&) noexcept = default;
Environment& Environment::operator=(Environment&&) noexcept = default;
Environment::~Environment() = default;

Result<Environment> Environment::make(const SharedTask& task, const Settings& settings, SharedSimulator simulator) {
  if (auto fine = check(settings); !fine) return fine.error();
  auto state = EpisodeState::begin(task, settings, std::move(simulator));
  if (!state) return state.error();
  return Environment(std::move(*state));
}

const SharedTask& Environment::task() const { return state_->task; }
const Settings& Environment::settings() const { return state_->settings; }
const Observation& Environment::observe() const { return state_->observation; }
bool Environment::over() const { return state_->observation.over; }
const std::string& Environment::broken() const { return state_->broken; }

const Observation& Environment::reset() {
  // Its start was built before.
  state_ = std::move(*EpisodeState::begin(state_->task, state_->settings, state_->simulator));
  return state_->observation;
}

Result<Done> Environment::reset(const SharedTask& task) {
  auto state = EpisodeState::begin(task, state_->settings, state_->simulator);
  if (!state) return state.error();
  state_ = std::move(*state);
  return Done{};
}

StepResult Environment::step(std::string_view text) {
  const auto answer = parse_answer(text, state_->frame());
  if (answer) return step(*answer);
  StepInProgress step(*state_);
  if (!over()) step.refuse(answer.error().message);
  return std::move(step).finish();
}

StepResult Environment::step(const Answer& answer) {
  StepInProgress step(*state_);
  for (const AnsweredAction& action : answer.actions) {
    if (!step.goes_on()) break;
    step.act(action);
  }
  return std::move(step).finish();
}

StepResult Environment::step(const std::vector<Command>& commands) {
  Answer answer;
  for (const Command& command : commands) answer.actions.push_back({command, std::nullopt});
  return step(answer);
}

StepResult Environment::step(const Command& command) { return step(std::vector<Command>{command}); }

Picture Environment::picture() const { return state_->episode.world().picture(*state_->profile, state_->rays); }

namespace {

/// The profile with a picture of this size. Errors: Usage for a size out of range.
Result<Profile> lens_of(const Profile& profile, int width, int height) {
  for (const int side : {width, height}) {
    if (side < limits::kLeastImageSide || side > limits::kImageSide)
      return Error{Error::Kind::Usage,
                   "size",
                   {},
                   "expected " + std::to_string(limits::kLeastImageSide) + " to " + std::to_string(limits::kImageSide) +
                       " pixels a side"};
  }
  Profile lens = profile;
  lens.image_width = width;
  lens.image_height = height;
  return lens;
}

}  // namespace

Result<Picture> Environment::render(int width, int height, Viewpoint viewpoint) const {
  const auto lens = lens_of(*state_->profile, width, height);
  if (!lens) return lens.error();
  if (viewpoint == Viewpoint::Agent) return state_->episode.world().picture(*lens, state_->rays);
  return picture_from(scene(), *lens, viewpoint, state_->rays);
}

Result<Channels> Environment::channels(int width, int height, Viewpoint viewpoint) const {
  const auto lens = lens_of(*state_->profile, width, height);
  if (!lens) return lens.error();
  return channels_from(scene(), *lens, viewpoint, state_->rays);
}

std::string Environment::prompt(bool reasoning) const {
  return system_prompt(state_->task->start, state_->settings, *state_->profile, reasoning);
}
std::string Environment::text() const { return observation_text(state_->observation, state_->settings); }

Environment Environment::clone() const { return Environment(state_->apart()); }

Environment::Snapshot Environment::snapshot() const {
  Snapshot snapshot;
  snapshot.state_ = state_->apart();
  return snapshot;
}

void Environment::restore(const Snapshot& snapshot) { state_ = snapshot.state_->apart(); }

PrivilegedState Environment::privileged() const {
  const EpisodeState& state = *state_;
  PrivilegedState privileged;
  privileged.success = state.monitor.satisfied();
  privileged.hopeless = state.monitor.hopeless();
  privileged.progress = state.monitor.progress();
  privileged.missing = state.monitor.missing();
  privileged.goal = state.task->text.goal_text;
  privileged.steps = state.episode.steps();
  privileged.failures = state.episode.failures();
  privileged.ended_by = name_of(state.end());
  return privileged;
}

double Environment::progress() const { return state_->monitor.progress(); }

const Scene& Environment::scene() const { return state_->judged_scene(); }
bool Environment::has_object(std::string_view id) const { return state_->episode.world().find(id) != nullptr; }
const std::vector<VisibleObject>& Environment::pictured() const { return state_->episode.world().pictured(); }
bool Environment::pictures(std::string_view id) const {
  const World& world = state_->episode.world();
  return !world.holds(id) && world.pictured_from(world.agent(), id).has_value();
}

std::optional<int> Environment::expert_steps_left() const {
  const EnvironmentTask& task = *state_->task;
  if (!state_->done || over()) return std::nullopt;
  auto executions = ExecutionTree::of(task.goal, task.start, *task.data.knowledge, *task.data.profile, task.known);
  if (!executions) return std::nullopt;
  ExpertOptions options;
  options.max_steps += static_cast<int>(state_->done->size());
  const auto plan = find_cheapest_plan_from(*executions, {*state_->done, {}, false}, options);
  const auto* actions = std::get_if<std::vector<Action>>(&plan);
  return actions == nullptr ? std::nullopt : std::optional(static_cast<int>(actions->size()));
}

}  // namespace unietp
