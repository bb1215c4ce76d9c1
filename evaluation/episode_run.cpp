#include "evaluation/episode_run.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/in_quotes.h"
#include "core/limits.h"
#include "environment/answer.h"

namespace unietp {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

EpisodeAction action_of(const ExecutedAction& executed) {
  return {executed.command,          executed.outcome.success, std::string(name_of(executed.outcome.failure)),
          executed.outcome.feedback, executed.counted,         executed.simulator};
}

/// One line that may be shown, never empty.
std::string error_text(const std::string& message) {
  std::string text = printable(message, 400);
  return text.empty() ? "no reason was given" : text;
}

/// Fills the records of one episode, step by step.
class EpisodeWriter {
 public:
  EpisodeWriter(const PlannedEpisode& planned, const Environment& environment)
      : reply_bytes_(reply_bytes(environment.settings())) {
    const TaskText& text = environment.task()->text;
    EpisodeRecord& record = played_.record;
    record.key = planned.key;
    record.simulator = name_of(environment.task()->simulator);
    record.split = text.split;
    record.template_name = text.template_name;
    record.layout = text.layout;
    played_.timing.key = planned.key;
  }

  /// Says it to the environment and takes down what came of it.
  StepResult step(PolicyReply reply, Environment& environment, EpisodeWatcher* watcher) {
    EpisodeStep step;
    step.prompt = std::move(reply.prompt);
    step.reply = kept_text(reply.text, reply_bytes_);
    step.thinking =
        kept_text(reply.thinking, limits::kThinkingBytes - std::min(limits::kThinkingBytes, thinking_bytes_));
    step.finish = std::move(reply.finish);
    step.prompt_tokens = reply.prompt_tokens;
    step.completion_tokens = reply.completion_tokens;
    step.cost = reply.cost;
    thinking_bytes_ += step.thinking.size();
    const auto begin = Clock::now();
    const Observation& seen = environment.observe();
    const auto answer =
        parse_answer(step.reply, {environment.settings().box_form, seen.image_width, seen.image_height});
    if (!answer) step.unreadable = answer.error().message;
    const auto read = Clock::now();
    if (watcher != nullptr) watcher->before_reply(answer ? &*answer : nullptr, environment);
    const auto looked = Clock::now() - read;
    StepResult result = answer ? environment.step(*answer) : environment.step(step.reply);
    step.progress = environment.progress();
    played_.timing.environment_s += since(begin + looked);
    for (const ExecutedAction& executed : result.executed) step.actions.push_back(action_of(executed));
    played_.timing.reply_s.push_back(reply.seconds);
    played_.timing.attempts.push_back(reply.attempts);
    auto& models = played_.record.models;
    const auto place = std::lower_bound(models.begin(), models.end(), reply.model);
    if (!reply.model.empty() && (place == models.end() || *place != reply.model))
      models.insert(place, std::move(reply.model));
    played_.record.steps.push_back(std::move(step));
    return result;
  }
  const std::string& unreadable() const { return played_.record.steps.back().unreadable; }

  PlayedEpisode finish(const Environment& environment) && {
    const PrivilegedState state = environment.privileged();
    EpisodeRecord& record = played_.record;
    record.end = outcome_named(state.ended_by).value_or(EpisodeOutcome::Errored);
    record.success = state.success;
    count(state);
    return std::move(played_);
  }
  PlayedEpisode finish(const Environment& environment, const NoReply& none) && {
    EpisodeRecord& record = played_.record;
    record.end = EpisodeOutcome::Errored;
    record.error = EpisodeError{none.kind, error_text(none.message)};
    played_.timing.error_attempts = none.attempts;
    count(environment.privileged());
    return std::move(played_);
  }

 private:
  void count(const PrivilegedState& state) {
    played_.record.progress = state.progress;
    played_.record.counted = state.steps;
    played_.record.failures = state.failures;
  }

  PlayedEpisode played_;
  std::size_t reply_bytes_, thinking_bytes_ = 0;
};

}  // namespace

std::variant<PlayedEpisode, NoReply> play_episode(const PlannedEpisode& planned, Environment& environment,
                                                  Policy& policy, EpisodeWatcher* watcher) {
  EpisodeWriter writer(planned, environment);
  if (watcher != nullptr) watcher->begin(environment);
  auto none = policy.begin(planned, environment);
  while (!none && environment.broken().empty() && !environment.over()) {
    auto answer = policy.next(environment);
    auto* reply = std::get_if<PolicyReply>(&answer);
    if (reply == nullptr) {
      none = std::get<NoReply>(std::move(answer));
      break;
    }
    const StepResult result = writer.step(std::move(*reply), environment, watcher);
    if (!environment.broken().empty()) break;
    if (watcher != nullptr) watcher->after_reply(writer.unreadable(), result, environment);
  }
  if (!environment.broken().empty()) {
    none = NoReply{EpisodeErrorKind::Simulator, environment.broken()};
    none->again = true;
  }
  if (!none) return std::move(writer).finish(environment);
  if (none->stopped || none->again || none->hopeless) return std::move(*none);
  return std::move(writer).finish(environment, *none);
}

PlayedEpisode unplayed(const PlannedEpisode& planned, const Environment& environment, const NoReply& none) {
  return EpisodeWriter(planned, environment).finish(environment, none);
}

std::size_t reply_bytes(const Settings& settings) {
  const auto steps = static_cast<std::size_t>(std::max(1, settings.rules.limits.steps));
  return std::clamp<std::size_t>(limits::kRepliesBytes / steps, 256, limits::kReplyBytes);
}

std::string kept_text(const std::string& text, std::size_t most) {
  using Json = nlohmann::json;
  const bool is_ascii =
      std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
  if (is_ascii) return text.substr(0, most);
  const auto json = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string sound = Json::parse(json).get<std::string>();
  if (sound.size() <= most) return sound;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(sound[end]) & 0xC0) == 0x80) --end;
  return sound.substr(0, end);
}

}  // namespace unietp
