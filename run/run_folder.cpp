#include "run/run_folder.h"

#include <algorithm>
#include <optional>

#include "core/files.h"
#include "run/run_differences.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

// The run's identity. It is renamed just before the data set is, which tells a finished run from an unrelated folder
// with the name of `out`.
constexpr const char* kRun = "run.json";
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

/// Whose run is in the folder; nothing when it does not say.
std::optional<std::string> identity_in(const fs::path& folder) {
  for (const char* name : {kRun, kPublishing}) {
    if (auto text = read_file(folder / name)) return *text;
  }
  return std::nullopt;
}

/// A run that was killed while it wrote its identity has left nothing else.
bool holds_a_run(const fs::path& folder) {
  std::error_code code;
  const auto entries = fs::directory_iterator(folder, code);
  return !code && std::any_of(begin(entries), end(entries), [](const fs::directory_entry& entry) {
    return entry.path().filename() != std::string(kRun) + ".tmp";
  });
}

}  // namespace

Error usage_error(const fs::path& path, std::string message) {
  return {Error::Kind::Usage, path.string(), {}, std::move(message)};
}

Result<RunFolder> RunFolder::enter(const fs::path& asked, const std::string& identity, bool resume) {
  auto lock = FolderLock::take(asked);
  if (!lock) return lock.error();
  const fs::path out = one_name_of(asked), folder = out.string() + ".partial";
  std::error_code code;
  const auto before = identity_in(folder);
  const bool unfinished = holds_a_run(folder), same = before == identity;
  const bool published = same && fs::exists(folder / kPublishing, code) && !fs::exists(folder / "data", code);
  const bool tidy_up = resume && (published || fs::is_empty(folder, code));
  if (fs::exists(out, code) && !tidy_up)
    return usage_error(asked, "already exists; choose another folder, or remove this one first");
  if (unfinished && !resume)
    return usage_error(folder,
                       "contains an unfinished run; add --resume to continue it, or remove that folder to start over");
  if (unfinished && !before)
    return usage_error(folder,
                       "does not say which run it is of, so it cannot be resumed; if another version of this program "
                       "made it, resume it with that version, or remove that folder to start anew");
  if (unfinished && !same)
    return usage_error(folder, "contains an unfinished run with different settings, so it cannot be resumed" +
                                   run_differences(*before, identity) +
                                   "\nrepeat the command with the same options and program, or remove that folder to "
                                   "start anew");
  RunFolder run(std::move(*lock), out, folder);
  if (tidy_up && fs::exists(out, code)) {
    remove_marker_last(folder);
    run.already_published_ = true;
    return run;
  }
  fs::create_directories(folder, code);
  if (code)
    return io(folder, "cannot create this folder: " + code.message() + "; choose a folder that you can write to");
  if (unfinished) return run;
  if (auto written = write_file(folder / kRun, identity); !written) {
    fs::remove_all(folder, code);  // there was nothing in it
    return written.error();
  }
  return run;
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
  std::error_code code;
  if (!fs::exists(folder_ / kPublishing, code)) fs::rename(folder_ / kRun, folder_ / kPublishing, code);
  if (!code) fs::rename(folder_ / "data", out_, code);
  if (code) return io(out_, "cannot rename the finished data set into place: " + code.message());
  remove_marker_last(folder_);
  return Done{};
}

}  // namespace unietp
