#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/file_place.h"
#include "core/result.h"

namespace unietp {

/// How errors name the files of a data set: relative to its folder, or with the path of the folder.
enum class FileNames { InFolder, WithFolder };

/// A line of a file of JSON lines.
struct FileLine {
  int number = 0;     // 1-based
  std::string text;   // without its line feed
  std::string fault;  // a problem of the line apart from its JSON, such as "is empty"; "" for none
};

/// Reads a file of JSON lines, one line in memory at a time. A line has a fault if it is empty, has no line feed at its
/// end, ends in a carriage return, or has more than limits::kLineBytes.
class LineFile {
 public:
  /// `name`: the path in `folder`. Errors: Io, for a file that is missing or cannot be opened.
  static Result<LineFile> open(const std::filesystem::path& folder, const std::string& name, FileNames names);

  /// The next line; nullopt after the last. A line that is too long or cannot be read is the last one.
  std::optional<FileLine> next();
  /// The file for error messages: "tasks.jsonl".
  const std::string& name() const { return name_; }
  /// A line of it for error messages: "tasks.jsonl:3".
  std::string at(int line) const { return name_ + ":" + std::to_string(line); }

 private:
  LineFile(std::string name, Descriptor file) : name_(std::move(name)), file_(std::move(file)) {}

  bool fill();

  std::string name_;
  Descriptor file_;
  std::string buffer_;    // bytes read from the file
  std::size_t used_ = 0;  // bytes of the buffer that belong to lines already returned
  int lines_ = 0;
  bool ended_ = false, failed_ = false;
};

}  // namespace unietp
