#include "program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "core/files.h"

namespace unietp {
namespace {

std::filesystem::path scratch_file() {
  std::string pattern = (std::filesystem::temp_directory_path() / "unietp-test-XXXXXX").string();
  const int file = ::mkstemp(pattern.data());
  if (file < 0) throw std::runtime_error("no temporary file");
  ::close(file);
  return pattern;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}

std::string taken(const std::filesystem::path& path) {
  const auto text = read_file(path);
  std::filesystem::remove(path);
  return text ? *text : std::string();
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& arguments)
    : RunningProgram(UNIETP_PROGRAM, arguments, ".") {}

RunningProgram::RunningProgram(const std::string& program, const std::vector<std::string>& arguments,
                               const std::filesystem::path& folder)
    : out_(scratch_file()), err_(scratch_file()) {
  std::vector<char*> argv;
  std::string name = program;
  const char* path = std::getenv("PATH");
  const auto found_first =
      std::filesystem::path(UNIETP_PROGRAM).parent_path().string() + ":" + (path == nullptr ? "" : path);
  argv.push_back(name.data());
  auto copies = arguments;
  for (auto& argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    ::dup2(::open(out_.c_str(), O_WRONLY | O_TRUNC), STDOUT_FILENO);
    ::dup2(::open(err_.c_str(), O_WRONLY | O_TRUNC), STDERR_FILENO);
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    (void)::setenv("PATH", found_first.c_str(), 1);
    ::execv(name.c_str(), argv.data());
    ::_exit(127);
  }
}

RunningProgram::~RunningProgram() {
  if (!ended_) {
    send(SIGKILL);
    (void)wait();
  }
}

bool RunningProgram::running() { return !reap(WNOHANG); }

bool RunningProgram::reap(int options) {
  rusage used{};
  if (!ended_ && ::wait4(process_, &status_, options, &used) == process_) {
    ended_ = true;
    peak_bytes_ = static_cast<std::size_t>(used.ru_maxrss) * 1024;
    processor_s_ = seconds(used.ru_utime) + seconds(used.ru_stime);
  }
  return ended_;
}

double RunningProgram::processor_s() const {
  const auto now = read_file("/proc/" + std::to_string(process_) + "/stat");  // proc(5)
  if (!now) return processor_s_;
  std::istringstream fields(now->substr(now->rfind(')') + 1));
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

void RunningProgram::send(int signal) const { ::kill(process_, signal); }

Ended RunningProgram::wait() {
  (void)reap(0);
  Ended ended;
  ended.peak_bytes = peak_bytes_;
  ended.processor_s = processor_s_;
  if (WIFEXITED(status_)) ended.code = WEXITSTATUS(status_);
  if (WIFSIGNALED(status_)) ended.signal = WTERMSIG(status_);
  ended.out = taken(out_);
  ended.err = taken(err_);
  return ended;
}

Ended run_program(const std::vector<std::string>& arguments) { return RunningProgram(arguments).wait(); }

Ended run_script(const std::string& script, const std::filesystem::path& folder) {
  return RunningProgram("/bin/sh", {"-e", "-c", script}, folder).wait();
}

std::map<std::string, std::string> bytes_below(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (std::error_code code; !entry.is_regular_file(code)) continue;  // nor a link that leads nowhere
    const auto bytes = read_file(entry.path());
    files[std::filesystem::relative(entry.path(), folder).generic_string()] = bytes ? *bytes : "unreadable";
  }
  return files;
}

}  // namespace unietp
