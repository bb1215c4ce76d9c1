#include <charconv>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/rng.h"
#include "environment/agent_text.h"
#include "evaluation/policy.h"
#include "evaluation/random_policy.h"
#include "expert/expert.h"
#include "expert/mode_expert.h"

namespace unietp {
namespace {

constexpr const char* kStopReply = R"({"action": "stop", "args": []})";

/// A command as an agent says it under the settings.
std::string said(const Command& command, const Environment& environment) {
  const Observation& seen = environment.observe();
  auto args = nlohmann::ordered_json::array();
  for (const Argument& argument : command.args) {
    if (argument.box) {
      args.push_back(
          {{"bbox", box_in_form(*argument.box, environment.settings().box_form, seen.image_width, seen.image_height)}});
    } else {
      args.push_back(argument.id);
    }
  }
  return nlohmann::ordered_json{{"action", command.action}, {"args", std::move(args)}}.dump();
}

/// The expert's demonstration in the mode, made anew as those of data sets are, or why there is none.
std::variant<Demonstration, Rejection> demonstrated_anew(const EnvironmentTask& task, Mode mode) {
  auto executions = ExecutionTree::of(task.goal, task.start, *task.data.knowledge, *task.data.profile, task.known);
  if (!executions) return Rejection{RejectionReason::NoPlan, format(executions.error())};
  auto shown = demonstrate(*executions, ExpertOptions());
  const auto* in_m1 = std::get_if<Demonstration>(&shown);
  if (mode == Mode::M1 || in_m1 == nullptr) return shown;
  return demonstrate_in(mode, *executions, *in_m1, task.data.household.get());
}

/// Does a list of commands, then says stop.
class ScriptPolicy : public Policy {
 public:
  ScriptPolicy(const BuiltInPolicy& policy, TaskSource tasks, std::uint64_t seed)
      : policy_(policy), tasks_(std::move(tasks)), seed_(seed) {}

  std::optional<NoReply> begin(const PlannedEpisode& episode, const Environment& start) override {
    commands_.clear();
    next_ = 0;
    if (policy_.kind == BuiltInPolicy::Kind::Stop) return std::nullopt;
    if (policy_.kind == BuiltInPolicy::Kind::Expert) return plan_anew(*start.task(), episode.key.mode);
    const auto shown = tasks_.demonstrated_plan(episode.position, episode.key.mode);
    if (!shown) return NoReply{EpisodeErrorKind::Policy, format(shown.error())};
    Rng rng = episode_rng(seed_, episode.key);
    for (const Command& command : *shown) {
      if (policy_.kind != BuiltInPolicy::Kind::Noisy || !rng.chance(policy_.noise)) commands_.push_back(command);
    }
    return std::nullopt;
  }

  PolicyAnswer next(const Environment& environment) override {
    PolicyReply reply;
    reply.text = next_ < commands_.size() ? said(commands_[next_++], environment) : kStopReply;
    return reply;
  }

 private:
  std::optional<NoReply> plan_anew(const EnvironmentTask& task, Mode mode) {
    const auto shown = demonstrated_anew(task, mode);
    if (const auto* why = std::get_if<Rejection>(&shown))
      return NoReply{EpisodeErrorKind::Policy,
                     "the expert has no plan: " + std::string(name_of(why->reason)) + ": " + why->detail};
    for (const DemonstrationStep& step : std::get<Demonstration>(shown).steps) commands_.push_back(step.command);
    return std::nullopt;
  }

  BuiltInPolicy policy_;
  TaskSource tasks_;
  std::uint64_t seed_;
  std::vector<Command> commands_;
  std::size_t next_ = 0;
};

}  // namespace

Rng episode_rng(std::uint64_t seed, const EpisodeKey& key) {
  return Rng(seed).fork(key.task + " " + std::string(name_of(key.mode)), static_cast<std::uint64_t>(key.repeat));
}

Result<std::optional<BuiltInPolicy>> built_in_policy(const std::string& text) {
  if (text == "expert") return std::optional(BuiltInPolicy{BuiltInPolicy::Kind::Expert, 0});
  if (text == "replay") return std::optional(BuiltInPolicy{BuiltInPolicy::Kind::Replay, 0});
  if (text == "random") return std::optional(BuiltInPolicy{BuiltInPolicy::Kind::Random, 0});
  if (text == "stop") return std::optional(BuiltInPolicy{BuiltInPolicy::Kind::Stop, 0});
  constexpr std::string_view kNoisy = "noisy:";
  if (!text.starts_with(kNoisy)) return std::optional<BuiltInPolicy>();
  double noise = -1;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + kNoisy.size(), end, noise);
  if (read.ec != std::errc() || read.ptr != end || !(noise >= 0 && noise <= 1))
    return Error{Error::Kind::Usage, "--policy", {}, "expected noisy:P with a number from 0 to 1, as in noisy:0.1"};
  return std::optional(BuiltInPolicy{BuiltInPolicy::Kind::Noisy, noise});
}

PolicyMaker built_in_policies(const BuiltInPolicy& policy, TaskSource tasks, std::uint64_t seed) {
  if (policy.kind == BuiltInPolicy::Kind::Random) return [seed] { return std::make_unique<RandomPolicy>(seed); };
  return [policy, tasks = std::move(tasks), seed] { return std::make_unique<ScriptPolicy>(policy, tasks, seed); };
}

}  // namespace unietp
