#include "core/file_writer.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlock = 1 << 16;  // bytes that are written at once

/// With the system's reason.
Error failed_write(const fs::path& path, const std::string& what) {
  return {Error::Kind::Io, path.string(), {}, what + ": " + std::strerror(errno)};
}

/// Whether the name still leads to the open file; another writer may have renamed or removed it.
bool still_named(const FilePlace& place, const std::string& name, const struct stat& open_file) {
  struct stat named {};
  return ::fstatat(place.folder.get(), name.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0 &&
         open_file.st_ino == named.st_ino && open_file.st_dev == named.st_dev;
}

/// The nearest folder above `path` that is there.
fs::path folder_above(const fs::path& path) {
  std::error_code code;
  fs::path folder = fs::absolute(path, code).parent_path();
  while (folder.has_relative_path() && !fs::exists(folder, code)) folder = folder.parent_path();
  return folder;
}

}  // namespace

Result<FilePlace> place_of(const fs::path& path) {
  const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  FilePlace place{Descriptor(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)), path.filename(), path};
  if (place.folder.get() < 0) return failed_write(path, "cannot open its folder");
  return place;
}

Result<FileWriter> FileWriter::begin(const fs::path& path) {
  auto place = place_of(path);
  if (!place) return place.error();
  std::string name = place->name;
  return open(std::move(*place), std::move(name));
}

Result<FileWriter> FileWriter::replace(FilePlace place) {
  std::string temporary = place.name + ".tmp";
  return open(std::move(place), std::move(temporary));
}

Result<FileWriter> FileWriter::open(FilePlace place, std::string written) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  const int folder = place.folder.get();
  for (;;) {
    Descriptor file(::openat(folder, written.c_str(), kFlags, 0666));
    if (file.get() < 0 && errno == ELOOP && ::unlinkat(folder, written.c_str(), 0) == 0) continue;
    if (file.get() < 0) return failed_write(place.shown, "cannot open for writing");
    (void)::fcntl(file.get(), F_SETFL, 0);  // a pipe without a reader is refused at once, but a slow one is waited for
    while (::flock(file.get(), LOCK_EX) != 0 && errno == EINTR) continue;  // without, where a file system has no locks
    struct stat about {};
    if (::fstat(file.get(), &about) != 0) return failed_write(place.shown, "cannot open for writing");
    if (!still_named(place, written, about)) continue;
    if (S_ISREG(about.st_mode) && about.st_nlink > 1 && ::unlinkat(folder, written.c_str(), 0) == 0) continue;
    if (S_ISREG(about.st_mode) && about.st_size > 0 && ::ftruncate(file.get(), 0) != 0)
      return failed_write(place.shown, "cannot empty the older file");
    return FileWriter(std::move(place), std::move(written), std::move(file));
  }
}

FileWriter::~FileWriter() {
  if (file_.get() >= 0 && is_replacing()) (void)::unlinkat(place_.folder.get(), written_.c_str(), 0);
}

Error FileWriter::failed(const std::string& what) const { return failed_write(place_.shown, what); }

Result<Done> FileWriter::add(std::string_view bytes) {
  waiting_ += bytes;
  return waiting_.size() < kBlock ? Result<Done>(Done{}) : flush();
}

Result<Done> FileWriter::flush() {
  for (std::size_t done = 0; done < waiting_.size();) {
    const ssize_t written = ::write(file_.get(), waiting_.data() + done, waiting_.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failed("cannot write");
    done += static_cast<std::size_t>(written);
  }
  waiting_.clear();
  return Done{};
}

Result<Done> FileWriter::finish() {
  if (auto flushed = flush(); !flushed) return flushed;
  if (!is_replacing()) {
    if (::close(file_.release()) != 0) return failed("cannot write");
    return Done{};
  }
  // Closing a duplicate tells what closing would; the file itself stays open, and so no other writer's, until renamed.
  const int duplicate = ::fcntl(file_.get(), F_DUPFD_CLOEXEC, 0);
  if (duplicate < 0 || ::close(duplicate) != 0) return failed("cannot write");
  const int folder = place_.folder.get();
  if (::renameat(folder, written_.c_str(), folder, place_.name.c_str()) != 0) return failed("cannot rename into place");
  (void)::close(file_.release());
  return Done{};
}

Result<Done> check_writable(const fs::path& path) {
  std::error_code code;
  if (fs::is_directory(path, code)) return Error{Error::Kind::Io, path.string(), {}, "is a folder; expected a file"};
  if (fs::exists(path, code) && !fs::is_regular_file(path, code)) return Done{};  // a device or a pipe
  auto place = place_of(folder_above(path) / path.filename());
  if (!place) return place.error();
  place->shown = path;
  const auto begun = FileWriter::replace(std::move(*place));
  if (!begun) return begun.error();
  return Done{};
}

Result<Done> confirm_written(const fs::path& path) {
  Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (file.get() < 0) return failed_write(path, "cannot be opened again");
  if (::fsync(file.get()) != 0 && errno != EINVAL) return failed_write(path, "cannot write");  // EINVAL: it has no disk
  if (::close(file.release()) != 0) return failed_write(path, "cannot write");
  return Done{};
}

}  // namespace unietp
