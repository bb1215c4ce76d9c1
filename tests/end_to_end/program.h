#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace unietp {

/// How a run of the real program ended.
struct Ended {
  int code = -1;   // exit code, or -1 when a signal ended it
  int signal = 0;  // that signal
  std::string out, err;
  std::size_t peak_bytes = 0;  // of its memory
  double processor_s = 0;      // of all its threads
};

/// The program under way in a process of its own.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& arguments);
  /// Another program, in a folder, with the folder of the real one first on its path.
  RunningProgram(const std::string& program, const std::vector<std::string>& arguments,
                 const std::filesystem::path& folder);
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();
  bool running();
  /// What it has used of the processor so far, to 0.01 s.
  double processor_s() const;
  void send(int signal) const;
  Ended wait();

 private:
  bool reap(int options);

  pid_t process_ = -1;
  int status_ = 0;
  std::size_t peak_bytes_ = 0;
  double processor_s_ = 0;
  bool ended_ = false;
  std::filesystem::path out_, err_;
};

Ended run_program(const std::vector<std::string>& arguments);
/// A shell script that ends at its first failing command, run in a folder; `unietp` in it is the real program.
Ended run_script(const std::string& script, const std::filesystem::path& folder);

/// Every file below a folder with its bytes.
std::map<std::string, std::string> bytes_below(const std::filesystem::path& folder);

}  // namespace unietp
