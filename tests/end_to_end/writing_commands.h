#pragma once

#include <map>
#include <string>
#include <vector>

#include "program.h"

namespace unietp {

/// A command that writes, as it is run in a workbench.
struct WritingCommand {
  std::string name, arguments;
  std::string makes;      // the folder or file that it makes or changes
  bool in_parts = false;  // its folder gets files one by one, each whole
};

/// Every command that writes files, but those whose files tell how long things took: `evaluate` (evaluate_test.cpp
/// kills it) and the ledger of a run (kept_test.cpp does); `shape gallery`, which takes seconds (likewise); `knowledge
/// complete`, which needs tables of its own (complete_test.cpp kills it); and `knowledge import`, which makes this
/// program's own tables. `scene fit` and `knowledge fit-sense` are among them where the simulators' files are. One asks
/// a model on loopback.
std::vector<WritingCommand> writing_commands();

/// `generate` of two tasks in small homes, without `--out`.
std::string small_run(const std::string& seed);

/// A folder with a data set, two shards, configurations, a review and two evaluations, in which commands are run.
class Workbench {
 public:
  Workbench();
  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path operator/(const std::string& name) const { return path() / name; }

  Ended run(const WritingCommand& command) const { return run(command.arguments); }
  Ended run(const std::string& arguments) const;
  /// The arguments for RunningProgram, which is then the program itself and no shell.
  std::vector<std::string> words(const WritingCommand& command) const;

  /// Every file below a name, or the file itself; empty when there is none.
  std::map<std::string, std::string> files(const std::string& name) const;
  /// All but what the command makes.
  std::map<std::string, std::string> others(const WritingCommand& command) const;

 private:
  ScratchFolder folder_;
};

/// What a command makes when nothing disturbs it, and how often it touches files.
struct Undisturbed {
  std::map<std::string, std::string> before, after;
  int changes = 0;
};
Undisturbed undisturbed(const WritingCommand& command);

}  // namespace unietp
