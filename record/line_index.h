#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/file_place.h"
#include "core/result.h"
#include "record/line_file.h"

namespace unietp {

/// The lines of a file of JSON lines by their position, read from the file when they are asked for. Memory: 8 bytes a
/// line. Several threads may read at once.
class LineIndex {
 public:
  /// Reads the file once. `each` is called for every line in order; an error of its ends the reading. Errors: Io;
  /// Schema for a line with a fault (line_file.h); those of `each`.
  static Result<LineIndex> open(const std::filesystem::path& folder, const std::string& name, FileNames names,
                                const std::function<Result<Done>(const FileLine&)>& each = {});

  std::size_t size() const { return begins_.size() - 1; }
  /// The line at a position below `size()`. Errors: Io, also when the file has become shorter.
  Result<FileLine> line(std::size_t position) const;
  /// The file for error messages.
  const std::string& name() const { return name_; }

 private:
  LineIndex(std::string name, Descriptor file) : name_(std::move(name)), file_(std::move(file)) {}

  std::string name_;
  Descriptor file_;
  std::vector<std::uint64_t> begins_{0};  // byte of each line's begin, and of the end of the file
};

}  // namespace unietp
