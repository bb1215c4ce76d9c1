#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace unietp {

/// Lines of a task and of its demonstration that read, without line ends; `padding`: more bytes of the task's line.
std::string task_line(const std::string& id, std::size_t padding = 0);
std::string shown_line(const std::string& id);

/// A folder with these lines in tasks.jsonl and demonstrations/M1.jsonl, each with a line feed; gone with the value.
class SmallSet {
 public:
  SmallSet();
  ~SmallSet() { std::filesystem::remove_all(folder_); }
  SmallSet(const SmallSet&) = delete;
  SmallSet& operator=(const SmallSet&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  void write(const std::vector<std::string>& tasks, const std::vector<std::string>& shown) const;
  /// A file as it is, without line feeds being added.
  void write_bytes(const std::string& file, const std::string& bytes) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace unietp
