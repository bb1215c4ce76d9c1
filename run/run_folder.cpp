#include "run/run_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

// Marker file, written just before the rename: tells a finished run from an unrelated folder with the name of `out`.
constexpr const char* kPublishing = "publishing";

Error io(const fs::path& path, std::string message) { return {Error::Kind::Io, path.string(), {}, std::move(message)}; }

/// Removes the marker last, so that the next process can tell what is left to do if this one is killed.
void remove_marker_last(const fs::path& folder) {
  std::error_code code;
  for (auto it = fs::directory_iterator(folder, code); !code && it != fs::directory_iterator(); it.increment(code)) {
    if (it->path().filename() == kPublishing) continue;
    std::error_code ignored;
    fs::remove_all(it->path(), ignored);
  }
  fs::remove_all(folder, code);
}

fs::path without_slash(const fs::path& path) { return path.has_filename() ? path : path.parent_path(); }

}  // namespace

Error usage_error(const fs::path& path, std::string message) {
  return {Error::Kind::Usage, path.string(), {}, std::move(message)};
}

Result<RunFolder> RunFolder::enter(const fs::path& asked, bool resume) {
  const fs::path out = without_slash(asked);
  const fs::path folder = out.string() + ".partial";
  std::error_code code;
  const bool unfinished = fs::exists(folder, code);
  const bool published = fs::exists(folder / kPublishing, code) && !fs::exists(folder / "data", code);
  const bool tidy_up = resume && unfinished && (published || fs::is_empty(folder, code));
  if (fs::exists(out, code) && !tidy_up)
    return usage_error(out, "already exists; choose another folder, or remove this one first");

  fs::create_directories(folder, code);
  if (code)
    return io(folder, "cannot create this folder: " + code.message() + "; choose a folder that you can write to");
  const int lock = ::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock < 0) {
    const std::string reason = std::strerror(errno);
    if (!unfinished) fs::remove(folder, code);
    return io(folder, "cannot write here: " + reason + "; choose a folder that you can write to");
  }
  RunFolder run(out, folder, lock);
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0)
    return usage_error(folder, "another run is using this folder; wait for it to finish, or choose another folder");
  if (unfinished && !resume)
    return usage_error(folder,
                       "contains an unfinished run; add --resume to continue it, or remove that folder to start over");
  if (tidy_up && fs::exists(out, code)) {
    remove_marker_last(folder);
    run.already_published_ = true;
  }
  return run;
}

RunFolder::RunFolder(RunFolder&& other) noexcept
    : out_(std::move(other.out_)),
      folder_(std::move(other.folder_)),
      lock_(std::exchange(other.lock_, -1)),
      already_published_(other.already_published_) {}

RunFolder::~RunFolder() {
  if (lock_ >= 0) ::close(lock_);
}

Result<fs::path> RunFolder::fresh_data_folder() const {
  const fs::path data = folder_ / "data";
  std::error_code code;
  fs::remove_all(data, code);
  if (!code) fs::create_directories(data, code);
  if (code) return io(data, "cannot create this folder: " + code.message());
  return data;
}

Result<Done> RunFolder::publish() {
  if (const auto marked = write_file(folder_ / kPublishing, ""); !marked) return marked.error();
  std::error_code code;
  fs::rename(folder_ / "data", out_, code);
  if (code) return io(out_, "cannot rename the finished data set into place: " + code.message());
  remove_marker_last(folder_);
  return Done{};
}

}  // namespace unietp
