#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/file_place.h"
#include "core/result.h"
#include "evaluation/policy.h"

namespace unietp {

inline constexpr const char* kEpisodeLog = "log.jsonl";  // in the folder of an evaluation

/// What is known of an ended episode without reading its lines.
struct EndedEpisode {
  bool errored = false, success = false;
  std::vector<std::string> models;
  std::int64_t prompt_tokens = 0, completion_tokens = 0;
  double cost = 0;
  std::uint64_t at = 0;                             // byte of its lines in the log
  std::size_t timing_bytes = 0, episode_bytes = 0;  // of each with its line feed
};

/// A reply of a model as soon as it is there: what a kill must not lose.
struct LoggedReply {
  EpisodeKey key;
  int step = 0;  // of the episode, from 0
  PolicyReply reply;
  bool operator==(const LoggedReply&) const = default;
};
std::string reply_line(const LoggedReply& reply);
/// Errors: Parse with line and column; Schema with a JSON pointer.
Result<LoggedReply> read_logged_reply(std::string_view where, int line, std::string_view text);

/// The log of a run: lines are only ever added, each by one write, so that a process that is killed loses at most the
/// line that it was writing. It has replies of models in the order of their arrival and, of each ended episode, its
/// lines of timing.jsonl and episodes.jsonl; where an episode has several, since it errored before, the last counts.
/// Thread-safe.
class EpisodeLog {
 public:
  /// Opens or makes `<folder>/log.jsonl` and reads what is there. A last line that was cut by a kill is taken away.
  /// Errors: Io; Parse and Schema for a line that no run has written.
  static Result<EpisodeLog> open(const std::filesystem::path& folder);

  /// Errors: Io; the log then is as before, or has a part of a line at its end.
  Result<Done> add(const LoggedReply& reply);
  Result<Done> add(const EpisodeRecord& episode, const TimingRecord& timing);

  /// nullopt when it has not ended.
  std::optional<EndedEpisode> ended(const EpisodeKey& key) const;
  /// The reply to a prompt at a step of an episode that has not ended or has errored.
  std::optional<PolicyReply> reply_to(const EpisodeKey& key, int step, const std::string& prompt) const;
  /// Cost of all replies in the log.
  double cost() const;

  /// The two lines of an ended episode, with their line feeds: of timing.jsonl and of episodes.jsonl. Errors: Io.
  Result<std::pair<std::string, std::string>> lines_of(const EndedEpisode& episode) const;

 private:
  struct State {
    std::mutex mutex;
    std::map<EpisodeKey, EndedEpisode> ended;
    std::map<EpisodeKey, std::map<std::pair<int, std::string>, PolicyReply>> replies;  // of what has not ended well
    double cost = 0;
    std::uint64_t bytes = 0;
  };
  EpisodeLog(std::filesystem::path path, Descriptor file)
      : path_(std::move(path)), file_(std::move(file)), state_(std::make_unique<State>()) {}
  Result<Done> read();
  Result<Done> write(const std::string& lines);
  void take(const LoggedReply& reply);
  void take(const EpisodeRecord& episode, std::uint64_t at, std::size_t timing_bytes, std::size_t episode_bytes);

  std::filesystem::path path_;
  Descriptor file_;
  std::unique_ptr<State> state_;  // the log moves, a mutex does not
};

}  // namespace unietp
