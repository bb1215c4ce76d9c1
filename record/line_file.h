#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "core/result.h"

namespace unietp {

/// The most bytes of one line of a data set: one task or one demonstration.
inline constexpr std::size_t kLineBytes = std::size_t{64} << 20;

/// How errors name the files of a data set: by their path in its folder, or with that folder in front.
enum class FileNames { InFolder, WithFolder };

/// A line of a file of JSON lines.
struct FileLine {
  int number = 0;     // 1-based
  std::string text;   // without its line feed
  std::string fault;  // what is wrong with it whatever it says, such as "is empty"; "" for a sound line
};

/// Reads a file of JSON lines from its start to its end, one line in memory at a time. A line is sound when it is not
/// empty, ends in a line feed without a carriage return, and has at most kLineBytes.
class LineFile {
 public:
  /// `name`: the path in `folder`. Errors: Io, for a file that is missing or cannot be opened.
  static Result<LineFile> open(const std::filesystem::path& folder, const std::string& name, FileNames names);

  /// The next line; nullopt after the last. A line that is too long or cannot be read is the last one.
  std::optional<FileLine> next();
  /// The file as errors name it: "tasks.jsonl".
  const std::string& name() const { return name_; }
  /// A line of it as errors name it: "tasks.jsonl:3".
  std::string at(int line) const { return name_ + ":" + std::to_string(line); }

 private:
  LineFile(std::string name, std::ifstream stream) : name_(std::move(name)), stream_(std::move(stream)) {}

  bool fill();

  std::string name_;
  std::ifstream stream_;
  std::string buffer_;    // bytes that were read from the file
  std::size_t used_ = 0;  // of the buffer, by lines that were given out
  int lines_ = 0;
  bool ended_ = false;
};

}  // namespace unietp
