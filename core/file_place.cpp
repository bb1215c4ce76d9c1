#include "core/file_place.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/in_quotes.h"
#include "core/plain_name.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr int kFolderFlags = O_PATH | O_DIRECTORY | O_CLOEXEC;
constexpr int kFileFlags = O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK;  // a FIFO without a writer opens at once

Error place_error(const fs::path& path, std::string message) {
  return {Error::Kind::Io, path.string(), {}, std::move(message)};
}

/// `errno` after a failed call for something in a folder, whose symbolic links are not followed.
std::string reason_inside() {
  return errno == ELOOP ? "is a symbolic link, which is not followed inside a folder" : std::strerror(errno);
}

bool is_link(const Descriptor& folder, const std::string& name) {
  struct stat status {};
  return ::fstatat(folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(status.st_mode);
}

/// The folder `name` in `parent`, made if it may be.
Result<Descriptor> step_into(const Descriptor& parent, const std::string& name, const fs::path& shown,
                             MissingFolders missing) {
  if (missing == MissingFolders::Made && ::mkdirat(parent.get(), name.c_str(), 0777) != 0 && errno != EEXIST)
    return place_error(shown, std::string("cannot create this folder: ") + std::strerror(errno));
  Descriptor folder(::openat(parent.get(), name.c_str(), kFolderFlags | O_NOFOLLOW));
  if (folder.get() >= 0) return folder;
  // For a link openat says ENOTDIR, since it is asked for a folder.
  if (errno == ENOTDIR && is_link(parent, name)) errno = ELOOP;
  return place_error(shown, "cannot open this folder: " + reason_inside());
}

std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

Result<Descriptor> if_regular(Descriptor file, const fs::path& shown) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return place_error(shown, std::string("cannot read: ") + std::strerror(errno));
  if (!S_ISREG(status.st_mode))
    return place_error(shown, "is " + std::string(kind_of(status.st_mode)) + "; expected a file");
  return file;
}

}  // namespace

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) (void)::close(number_);
}

int Descriptor::release() { return std::exchange(number_, -1); }

Result<FilePlace> place_inside(const fs::path& root, std::string_view inner, MissingFolders missing) {
  std::error_code failed;
  if (missing == MissingFolders::Made) fs::create_directories(root, failed);
  if (failed && !fs::is_directory(root)) return place_error(root, "cannot create this folder: " + failed.message());
  FilePlace place{Descriptor(::open(root.empty() ? "." : root.c_str(), kFolderFlags)), "", root};
  if (place.folder.get() < 0) return place_error(root, std::string("cannot open this folder: ") + std::strerror(errno));
  for (;;) {
    const auto slash = inner.find('/');
    place.name = inner.substr(0, slash);
    if (!is_plain_file_name(place.name))
      return Error{Error::Kind::Schema,
                   root.string(),
                   {},
                   in_quotes(place.name) + " names no file of a folder; " + plain_name_expected()};
    place.shown /= place.name;
    if (slash == std::string_view::npos) return place;
    auto next = step_into(place.folder, place.name, place.shown, missing);
    if (!next) return next.error();
    place.folder = std::move(*next);
    inner.remove_prefix(slash + 1);
  }
}

Result<fs::path> path_inside(const fs::path& root, std::string_view inner, MissingFolders missing) {
  const auto place = place_inside(root, inner, missing);
  if (!place) return place.error();
  if (is_link(place->folder, place->name)) {
    errno = ELOOP;
    return place_error(place->shown, reason_inside());
  }
  std::error_code failed;
  const fs::path own = fs::canonical(root.empty() ? "." : root, failed);
  if (failed) return place_error(root, "cannot resolve this folder: " + failed.message());
  return own / inner;
}

Result<Descriptor> open_regular_file(const fs::path& path) {
  Descriptor file(::open(path.c_str(), kFileFlags));
  if (file.get() < 0) return place_error(path, std::string("cannot open for reading: ") + std::strerror(errno));
  return if_regular(std::move(file), path);
}

Result<Descriptor> open_regular_file(const fs::path& root, std::string_view inner) {
  const auto place = place_inside(root, inner, MissingFolders::Refused);
  if (!place) return place.error();
  Descriptor file(::openat(place->folder.get(), place->name.c_str(), kFileFlags | O_NOFOLLOW));
  if (file.get() < 0) return place_error(place->shown, "cannot open for reading: " + reason_inside());
  return if_regular(std::move(file), place->shown);
}

}  // namespace unietp
