#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "record/line_file.h"

namespace unietp {

/// Reads a file of JSON lines that are records of one kind.
template <class Record>
class RecordFile {
 public:
  /// A function that reads one line: read_rejection, for example.
  using Read = Result<Record> (*)(std::string_view where, int line, std::string_view text);

  /// `name`: the path in `folder`. Errors: Io.
  static Result<RecordFile> open(const std::filesystem::path& folder, const std::string& name, FileNames names,
                                 Read read) {
    auto file = LineFile::open(folder, name, names);
    if (!file) return file.error();
    return RecordFile(std::move(*file), read);
  }

  /// The next line's record, or what is wrong with that line; nullopt after the last.
  std::optional<Result<Record>> next() {
    const auto line = file_.next();
    if (!line) return std::nullopt;
    line_ = line->number;
    if (!line->fault.empty()) return Error{Error::Kind::Schema, at(), {}, line->fault};
    return read_(file_.name(), line_, line->text);
  }
  /// The number of lines read so far.
  int lines() const { return line_; }
  /// The last line for error messages: "rejections.jsonl:3".
  std::string at() const { return file_.at(line_); }

 private:
  RecordFile(LineFile file, Read read) : file_(std::move(file)), read_(read) {}
  LineFile file_;
  Read read_;
  int line_ = 0;
};

}  // namespace unietp
