#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "program.h"
#include "scene/scene.h"

namespace unietp {

/// A small data set of all simulators and splits, made once by the real program for all tests of this process.
const std::filesystem::path& small_data_set();
/// The options that make it, but for the threads.
std::vector<std::string> small_options(const std::string& out);
inline constexpr int kSmallCount = 40;

/// A smaller one of atomic and compositional tasks, each shown in M1, M2 and M3.
const std::filesystem::path& data_set_in_all_modes();
inline constexpr int kCountInAllModes = 8;

/// What `unietp validate --json` says.
struct Verdict {
  int code = -1;
  int tasks = 0, proven = 0;
  struct Problem {
    std::string kind, task, where, message;
  };
  std::vector<Problem> problems;
};
Verdict validate(const std::filesystem::path& folder, const std::vector<std::string>& more = {});

std::vector<nlohmann::ordered_json> json_lines(const std::filesystem::path& file);
/// The start of a task of a folder: the home's file with the changes of the task's line.
Scene start_of(const std::filesystem::path& folder, const nlohmann::ordered_json& task);
nlohmann::ordered_json start_json(const std::filesystem::path& folder, const nlohmann::ordered_json& task);

/// A copy of the small data set in which things can be damaged. `vouch` makes the manifest's checksums true again, so
/// that only what the files mean is left to find.
class DamagedCopy {
 public:
  DamagedCopy();  // of small_data_set()
  explicit DamagedCopy(const std::filesystem::path& original);
  const std::filesystem::path& folder() const { return folder_; }
  std::string read(const std::string& file) const;
  void write(const std::string& file, const std::string& bytes) const;
  void vouch() const;

 private:
  ScratchFolder scratch_;
  std::filesystem::path folder_;
};

}  // namespace unietp
