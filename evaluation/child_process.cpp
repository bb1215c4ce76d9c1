#include "evaluation/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/pause.h"
#include "core/text.h"

extern char** environ;

namespace unietp {
namespace {

constexpr int kPoll_ms = 50;  // longest delay until a stop is noticed

Error process_error(const std::string& message) { return {Error::Kind::Io, "policy", {}, message}; }

struct Pipe {
  Descriptor read, write;
};
Result<Pipe> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return process_error(std::string("no pipe: ") + std::strerror(errno));
  return Pipe{Descriptor(ends[0]), Descriptor(ends[1])};
}

}  // namespace

Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& arguments) {
  auto to = make_pipe();
  auto from = make_pipe();
  if (!to) return to.error();
  if (!from) return from.error();
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_adddup2(&actions, to->read.get(), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, from->write.get(), STDOUT_FILENO);
  // A group of its own: Ctrl-C is for this program, which ends it and what it started.
  sigset_t pipe_signal;
  ::sigemptyset(&pipe_signal);
  ::sigaddset(&pipe_signal, SIGPIPE);
  ::posix_spawnattr_setsigdefault(&attributes, &pipe_signal);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  pid_t id = -1;
  const int failed = ::posix_spawnp(&id, words[0], &actions, &attributes, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  if (failed != 0) return process_error("cannot start " + arguments[0] + ": " + std::strerror(failed));
  (void)::fcntl(to->write.get(), F_SETFL, O_NONBLOCK);
  (void)::fcntl(from->read.get(), F_SETFL, O_NONBLOCK);
  return ChildProcess(id, std::move(to->write), std::move(from->read));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : id_(std::exchange(other.id_, -1)),
      input_(std::move(other.input_)),
      output_(std::move(other.output_)),
      received_(std::move(other.received_)) {}

ChildProcess::~ChildProcess() {
  if (id_ < 0) return;
  (void)::kill(-id_, SIGKILL);
  (void)::waitpid(id_, nullptr, 0);
}

Error ChildProcess::ended() {
  using Clock = std::chrono::steady_clock;
  // Its output is closed, so it is of no more use, but its own exit code tells more than being killed.
  const auto end = Clock::now() + std::chrono::seconds(1);
  int status = 0;
  pid_t done = 0;
  while ((done = ::waitpid(id_, &status, WNOHANG)) == 0 && Clock::now() < end)
    (void)pause_until(Clock::now() + std::chrono::milliseconds(5), nullptr);
  (void)::kill(-id_, SIGKILL);
  if (done == 0) done = ::waitpid(id_, &status, 0);
  id_ = -1;
  if (done > 0 && WIFEXITED(status))
    return process_error("the policy's program ended with exit code " + std::to_string(WEXITSTATUS(status)));
  if (done > 0 && WIFSIGNALED(status))
    return process_error("the policy's program was ended by signal " + std::to_string(WTERMSIG(status)));
  return process_error("the policy's program ended");
}

std::optional<std::string> ChildProcess::take_line() {
  const auto end = received_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = received_.substr(0, end);
  received_.erase(0, end + 1);
  return line;
}

Result<std::string> ChildProcess::exchange(const std::string& line, double seconds, std::size_t most_bytes,
                                           const std::atomic<bool>* stop) {
  using Clock = std::chrono::steady_clock;
  if (id_ < 0) return process_error("the policy's program ended");
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  const std::string sent_line = line + "\n";
  std::size_t sent = 0;
  for (;;) {
    if (auto answer = take_line()) return std::move(*answer);
    if (received_.size() > most_bytes)
      return process_error("the policy wrote a line of more than " + std::to_string(most_bytes) + " bytes");
    if (stop != nullptr && *stop) return process_error("stopped");
    if (Clock::now() >= end) return process_error("the policy did not answer in time");
    std::array<pollfd, 2> waited{pollfd{output_.get(), POLLIN, 0}, pollfd{input_.get(), POLLOUT, 0}};
    (void)::poll(waited.data(), sent < sent_line.size() ? 2 : 1, kPoll_ms);
    if (sent < sent_line.size()) {
      const ssize_t now = ::write(input_.get(), sent_line.data() + sent, sent_line.size() - sent);
      if (now > 0) sent += static_cast<std::size_t>(now);
      if (now < 0 && errno != EAGAIN && errno != EINTR) return ended();
    }
    std::array<char, 1 << 16> buffer;
    const ssize_t got = ::read(output_.get(), buffer.data(), buffer.size());
    if (got > 0) received_.append(buffer.data(), static_cast<std::size_t>(got));
    if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR)) return ended();
  }
}

std::optional<std::filesystem::path> program_named(const std::string& name) {
  const auto may_run = [](const std::string& path) {
    std::error_code failed;
    return std::filesystem::is_regular_file(path, failed) && ::access(path.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos)
    return may_run(name) ? std::optional<std::filesystem::path>(name) : std::nullopt;
  const char* path = std::getenv("PATH");
  const auto folders = split(path == nullptr ? "/usr/bin:/bin" : path, ':');
  for (const std::string& folder : folders) {
    const std::string file = (folder.empty() ? "." : folder) + "/" + name;
    if (may_run(file)) return file;
  }
  return std::nullopt;
}

Result<std::vector<std::string>> words_of_command(const std::string& command) {
  std::vector<std::string> words;
  bool in_word = false;
  char quote = 0;
  for (const char c : command) {
    if (quote != 0 ? c == quote : (c == '"' || c == '\'')) {
      quote = quote != 0 ? 0 : c;
      if (!in_word) words.emplace_back();
      in_word = true;
    } else if (quote == 0 && (c == ' ' || c == '\t' || c == '\n')) {
      in_word = false;
    } else {
      if (!in_word) words.emplace_back();
      in_word = true;
      words.back() += c;
    }
  }
  if (quote != 0) return Error{Error::Kind::Usage, "--policy", {}, std::string("expected a closing ") + quote};
  if (words.empty() || words[0].empty()) return Error{Error::Kind::Usage, "--policy", {}, "expected a command"};
  return words;
}

}  // namespace unietp
