#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"

namespace unietp {

/// An open file or folder of the operating system, closed at the end of its life.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  /// Negative when nothing is open.
  int get() const { return number_; }
  /// Gives the number away; whoever takes it closes it.
  int release();

 private:
  int number_ = -1;
};

/// A file by its open folder and its name in it, as openat(2), renameat(2) and unlinkat(2) take them.
struct FilePlace {
  Descriptor folder;
  std::string name;
  std::filesystem::path shown;  // for error messages
};

enum class MissingFolders { Refused, Made };  // of a place: an error, or made when it is asked for

/// The place of the file `inner` ("homes/kitchen.json") below the folder `root`, from where nothing leads out of the
/// folder: each part of `inner` between slashes must be a plain name (core/plain_name.h), and no folder on the way is a
/// symbolic link. `root` is the user's own path and may be one. Each part is opened in the one before it, so the tree
/// may change meanwhile. The file itself need not exist; do not follow it if it is a symbolic link (O_NOFOLLOW).
/// Errors: Schema for a part that is no plain name; Io, naming the folder and the system's reason.
Result<FilePlace> place_inside(const std::filesystem::path& root, std::string_view inner, MissingFolders missing);

/// The same file as a path, for libraries that open a file by its path: `root` without its symbolic links, then
/// `inner`. Errors: those of place_inside, and Io when the file is a symbolic link.
Result<std::filesystem::path> path_inside(const std::filesystem::path& root, std::string_view inner,
                                          MissingFolders missing);

/// Opens a file that the user named. A FIFO, a socket and a device are refused without waiting for them.
/// Errors: Io, naming the file and what it is, or the system's reason.
Result<Descriptor> open_regular_file(const std::filesystem::path& path);

/// The same for the file `inner` in the folder `root`, which no symbolic link stands for. Errors: also those of
/// place_inside.
Result<Descriptor> open_regular_file(const std::filesystem::path& root, std::string_view inner);

}  // namespace unietp
