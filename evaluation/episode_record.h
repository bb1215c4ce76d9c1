#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "environment/simulator_answer.h"
#include "evaluation/episode_key.h"
#include "scene/command.h"

namespace unietp {

/// Files of an evaluation's folder (docs/evaluation.md).
inline constexpr const char* kEpisodesFile = "episodes.jsonl";  // what happened: the same bytes for the same replies
inline constexpr const char* kTimingFile = "timing.jsonl";      // how long it took, and what was tried again

/// An action of a reply and what it came to, whatever the agent was told of it.
struct EpisodeAction {
  Command command;  // as the mode took it, boxes in pixels; an empty name: the reply could not be read
  bool success = false;
  std::string failure;                            // name of the kind: "none", "not_visible", …
  std::string feedback;                           // the sentence of the mode; "" on success
  bool counted = true;                            // as a step; an invalid action is not where those are free
  std::optional<SimulatorAnswer> simulator = {};  // of an evaluation in a simulator: what it said, where it was asked
  bool operator==(const EpisodeAction&) const = default;
};

/// A reply of the agent and what became of it.
struct EpisodeStep {
  std::string prompt;      // SHA-256 of what the agent was sent; "" for a policy of the program, which is sent nothing
  std::string reply;       // as given to the environment, which read it by parse_answer; UTF-8
  std::string thinking;    // what the model wrote apart from its reply; "" when nothing
  std::string finish;      // why the server says that the text ended: "stop", "length" (truncated); "" when unknown
  std::string unreadable;  // what parse_answer expected instead; "" when it could read the reply
  std::vector<EpisodeAction> actions;  // executed; of an unreadable reply one without a name
  double progress = 0;                 // share of the goal's parts that are met after them; 1 exactly with success
  std::int64_t prompt_tokens = 0, completion_tokens = 0;  // of this reply; 0 where nobody counts
  double cost = 0;                                        // by the prices of the manifest
  bool operator==(const EpisodeStep&) const = default;
};

/// How an episode ended. `Errored` is not the agent's doing: its reply could not be had.
enum class EpisodeOutcome : std::uint8_t { Stop, Steps, Failures, Answers, Errored };
std::string_view name_of(EpisodeOutcome end);  // "stop", "steps", "failures", "answers", "errored"
std::optional<EpisodeOutcome> outcome_named(std::string_view name);

/// Why there is no reply.
enum class EpisodeErrorKind : std::uint8_t {
  RateLimit,   // status 429
  Server,      // 5xx, or an answer that is no chat completion
  Connection,  // refused, reset or cut
  Timeout,     // no complete answer in time
  Rejected,    // another status: a request that the server refuses
  Policy,      // the policy's program ended, broke the protocol or took too long
  Simulator    // the same of the simulator's
};
std::string_view name_of(EpisodeErrorKind kind);  // "rate_limit", "server", …
std::optional<EpisodeErrorKind> error_kind_named(std::string_view name);

/// Why an episode has no result of the policy's.
struct EpisodeError {
  EpisodeErrorKind kind = EpisodeErrorKind::Server;
  std::string message;  // one line, without keys
  bool operator==(const EpisodeError&) const = default;
};

/// A line of episodes.jsonl. Whatever depends on the moment (times, attempts) is in the TimingRecord of the same key.
struct EpisodeRecord {
  EpisodeKey key;
  std::string simulator, split, template_name, layout;  // of the task; the layout names its home
  std::vector<EpisodeStep> steps;
  EpisodeOutcome end = EpisodeOutcome::Stop;
  bool success = false;  // the goal holds on the whole trace, whether or not the agent said `stop`; false when errored
  double progress = 0;   // as in the last step; of the start when there is none
  int counted = 0, failures = 0;      // steps and failed steps, as the limits count them
  std::vector<std::string> models;    // that the server says it answered with; sorted, each once
  std::optional<EpisodeError> error;  // exactly when errored
  bool operator==(const EpisodeRecord&) const = default;
};

/// A line of timing.jsonl, in the order of episodes.jsonl. Nothing that is compared between runs.
struct TimingRecord {
  EpisodeKey key;
  std::vector<double> reply_s;  // for each step, from its request to its reply, waits and failed attempts included
  std::vector<int> attempts;    // for each step, requests sent; 0 for a reply from the log or a cache
  double environment_s = 0;     // in the environment, all steps and the start
  int error_attempts = 0;       // for the reply that could not be had
  bool operator==(const TimingRecord&) const = default;
};

/// One line each, without its line feed. Equal records give equal bytes.
std::string episode_line(const EpisodeRecord& episode);
std::string timing_line(const TimingRecord& timing);

/// Read every field strictly. Errors: Parse with line and column; Schema with a JSON pointer for a missing, unknown or
/// mistyped field, and for fields that contradict each other. `where` is the file's name, `line` the number in it.
Result<EpisodeRecord> read_episode(std::string_view where, int line, std::string_view text);
Result<TimingRecord> read_timing(std::string_view where, int line, std::string_view text);

}  // namespace unietp
