#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "core/file_place.h"
#include "core/result.h"

namespace unietp {

/// A file that is written from its beginning: the one way in which this program writes files, but for SQLite's. The
/// bytes are known to be written only when `finish` says so, since a full disk or a network may refuse them as late as
/// when the file is closed. A second writer of the same file waits until the first is done. No symbolic link is
/// followed, and no other name of the file loses its bytes.
class FileWriter {
 public:
  /// Makes the file, or empties an older one, which grows under its own name. Errors, here and below: Io, with the file
  /// and the system's reason.
  static Result<FileWriter> begin(const std::filesystem::path& path);
  /// The file grows as `<name>.tmp`, which a killed process may have left, and `finish` gives it its name.
  static Result<FileWriter> replace(FilePlace place);
  FileWriter(FileWriter&&) = default;
  FileWriter& operator=(FileWriter&&) = delete;
  ~FileWriter();  // of a file that was to be replaced and is not finished, nothing stays

  Result<Done> add(std::string_view bytes);  // appends. Errors: Io
  /// Writes what is still in memory, and closes.
  Result<Done> finish();

 private:
  FileWriter(FilePlace place, std::string written, Descriptor file)
      : place_(std::move(place)), written_(std::move(written)), file_(std::move(file)) {}
  static Result<FileWriter> open(FilePlace place, std::string written);
  bool is_replacing() const { return written_ != place_.name; }
  Error failed(const std::string& what) const;
  Result<Done> flush();

  FilePlace place_;
  std::string written_;  // the name under which it grows
  Descriptor file_;
  std::string waiting_;
};

/// The place of a file that the user named, whose folder is there. Errors: Io.
Result<FilePlace> place_of(const std::filesystem::path& path);

/// Whether write_file (files.h) could write `path` now, for commands that work long before they write. Leaves nothing
/// behind. Errors: Io.
Result<Done> check_writable(const std::filesystem::path& path);

/// What another library has written to a file: that it reached the disk. Errors: Io.
Result<Done> confirm_written(const std::filesystem::path& path);

}  // namespace unietp
