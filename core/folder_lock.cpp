#include "core/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "core/files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

Error lock_error(Error::Kind kind, const fs::path& path, std::string message) {
  return {kind, path.string(), {}, std::move(message)};
}

/// "process 4711 on node3 (unietp export)". Of the command line only the first two words: the rest may name what is
/// nobody's business.
std::string own_name() {
  std::array<char, 256> host{};
  (void)::gethostname(host.data(), host.size() - 1);
  const auto line = read_file("/proc/self/cmdline");
  std::string command;
  if (line) {
    const auto first = line->find('\0'), second = line->find('\0', first == std::string::npos ? first : first + 1);
    command = fs::path(line->substr(0, first)).filename().string();
    if (second != std::string::npos) command += " " + line->substr(first + 1, second - first - 1);
  }
  return "process " + std::to_string(::getpid()) + " on " + host.data() + " (" + command + ")";
}

bool names_file(const fs::path& path, int file) {
  struct stat open_file {
  }, named{};
  return ::fstat(file, &open_file) == 0 && ::stat(path.c_str(), &named) == 0 && open_file.st_ino == named.st_ino &&
         open_file.st_dev == named.st_dev;
}

}  // namespace

fs::path one_name_of(const fs::path& path) {
  std::error_code code;
  auto whole = fs::weakly_canonical(fs::absolute(path, code), code);
  if (code) whole = path.lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

Result<FolderLock> FolderLock::take(const fs::path& asked) {
  const fs::path folder = one_name_of(asked), path = folder.string() + ".lock";
  constexpr int kMostTries = 100;
  for (int tried = 1;; ++tried) {
    std::error_code code;
    fs::create_directories(folder.parent_path(), code);
    if (code == std::errc::no_such_file_or_directory && tried < kMostTries) continue;  // as below
    if (code)
      return lock_error(Error::Kind::Io, asked,
                        "cannot create the folder that it is to be in: " + code.message() +
                            "; choose a folder that you can write to");
    const bool there = fs::exists(path, code);
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0 && errno == ENOENT && tried < kMostTries) continue;  // who made the folder has just removed it
    if (file < 0)
      return lock_error(
          Error::Kind::Io, asked,
          std::string("cannot write beside it: ") + std::strerror(errno) + "; choose a folder that you can write to");
    FolderLock lock(path, file, there);
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
      const int reason = errno;
      ::close(std::exchange(lock.file_, -1));  // the file is another's
      if (reason != EWOULDBLOCK)
        return lock_error(Error::Kind::Io, path,
                          std::string("cannot be locked: ") + std::strerror(reason) +
                              "; choose a folder on a file system that has locks");
      const auto holder = read_file(path);
      return lock_error(Error::Kind::Usage, asked,
                        (holder && holder->starts_with("process ") ? *holder : std::string("another process")) +
                            " is working on this folder; wait for it to finish, or choose another folder");
    }
    if (!names_file(path, file)) {  // its holder has just removed it
      ::close(std::exchange(lock.file_, -1));
      continue;
    }
    // Only to be read by people: on a full disk the right is there without the name.
    const std::string name = own_name();
    if (::ftruncate(file, 0) != 0 || ::write(file, name.data(), name.size()) < 0) (void)::ftruncate(file, 0);
    return lock;
  }
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), was_left_over_(other.was_left_over_) {}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  std::error_code code;
  fs::remove(path_, code);
  ::close(file_);
}

Result<FolderWatch> FolderWatch::begin(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0)
    return lock_error(Error::Kind::Io, folder, std::string("cannot be opened as a folder: ") + std::strerror(errno));
  return FolderWatch(folder, file);
}

FolderWatch::FolderWatch(FolderWatch&& other) noexcept
    : folder_(std::move(other.folder_)), file_(std::exchange(other.file_, -1)) {}

FolderWatch::~FolderWatch() {
  if (file_ >= 0) ::close(file_);
}

Result<Done> FolderWatch::check_same() const {
  if (names_file(folder_, file_)) return Done{};
  return lock_error(Error::Kind::Usage, folder_,
                    "another process put a new folder in its place while it was read; nothing was written, run this "
                    "command again");
}

}  // namespace unietp
