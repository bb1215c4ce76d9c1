#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "environment/environment.h"
#include "environment/task_source.h"
#include "evaluation/episode_record.h"

namespace unietp {

/// What an agent answered.
struct PolicyReply {
  std::string text, thinking, finish;  // as in EpisodeStep
  std::string prompt;                  // SHA-256 of what it was sent; ""
  std::string model;                   // that answered, as the server says; ""
  std::int64_t prompt_tokens = 0, completion_tokens = 0;
  double cost = 0;
  int attempts = 0;    // requests sent for it
  double seconds = 0;  // from the request to the reply
  bool operator==(const PolicyReply&) const = default;
};

/// Why there is no reply.
struct NoReply {
  EpisodeErrorKind kind = EpisodeErrorKind::Policy;
  std::string message;
  int attempts = 0;
  bool stopped = false;   // the run was stopped: the episode is left as if it had not begun
  bool again = false;     // the episode may be begun again at once
  bool hopeless = false;  // no other episode will do better: a wrong key, a program that is not there
};
using PolicyAnswer = std::variant<PolicyReply, NoReply>;

/// One episode of a run.
struct PlannedEpisode {
  EpisodeKey key;
  std::size_t position = 0;  // of the task in the source
};

/// An agent that acts in one episode after the other. Each thread has one of its own.
class Policy {
 public:
  virtual ~Policy() = default;
  /// Forgets the episode before. `start` is the environment at its beginning.
  virtual std::optional<NoReply> begin(const PlannedEpisode& episode, const Environment& start) = 0;
  /// What it says to the present observation.
  virtual PolicyAnswer next(const Environment& environment) = 0;
};
/// Makes one for a thread; called from that thread.
using PolicyMaker = std::function<std::unique_ptr<Policy>()>;

/// Which policy of the program is meant.
struct BuiltInPolicy {
  enum class Kind { Expert, Replay, Random, Stop, Noisy };
  Kind kind = Kind::Stop;
  double noise = 0;  // of Noisy, from 0 to 1
};
/// "expert", "replay", "random", "stop", "noisy:0.1"; nullopt for anything else. Errors: Usage, for a noise that is no
/// number from 0 to 1.
Result<std::optional<BuiltInPolicy>> built_in_policy(const std::string& text);

/// The policies of the program. They say what an agent could say, and need no time to think:
///  - expert: plans from the goal and the start, as the demonstrations were made, and does so; without a plan the
///    episode is errored;
///  - replay: the stored demonstration of the mode;
///  - noisy:P: the same, but each of its actions is left out with probability P, by a draw of its own;
///  - random: actions that the mode offers, on things that it has been told of, and now and then `stop`;
///  - stop: `stop` at once.
/// Deterministic: draws depend on the seed, the task, the mode and the repeat alone.
PolicyMaker built_in_policies(const BuiltInPolicy& policy, TaskSource tasks, std::uint64_t seed);

}  // namespace unietp
