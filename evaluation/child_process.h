#pragma once

#include <sys/types.h>

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/file_place.h"
#include "core/result.h"

namespace unietp {

/// A program that is given lines on its standard input and answers with lines on its standard output; what it writes to
/// standard error goes where this program's goes. It and what it started are ended with this value.
class ChildProcess {
 public:
  /// Errors: Io, when it cannot be started: no such program, say.
  static Result<ChildProcess> start(const std::vector<std::string>& arguments);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ~ChildProcess();

  /// Sends a line and waits for the next one, at most so long and while `stop` is not true. Errors: Io, with what went
  /// wrong: it ended (with its exit code or signal), took too long, wrote a line of more than `most_bytes`, or the run
  /// was stopped.
  Result<std::string> exchange(const std::string& line, double seconds, std::size_t most_bytes,
                               const std::atomic<bool>* stop);

 private:
  ChildProcess(pid_t id, Descriptor input, Descriptor output)
      : id_(id), input_(std::move(input)), output_(std::move(output)) {}
  Error ended();
  std::optional<std::string> take_line();

  pid_t id_ = -1;
  Descriptor input_, output_;  // our ends
  std::string received_;
};

/// The words of a command line, split at blanks; "…" and '…' keep blanks together. Nothing else has a meaning, since no
/// shell is asked. Errors: Usage, for a quote that is not closed and for no word.
Result<std::vector<std::string>> words_of_command(const std::string& command);
/// The file of a program: `name` is a path to one that may be executed, or a name in one of the folders of PATH.
std::optional<std::filesystem::path> program_named(const std::string& name);

}  // namespace unietp
