#include "report/data_set.h"

#include <mutex>

#include "core/digest.h"
#include "core/files.h"
#include "core/share_work.h"
#include "core/sqlite_file.h"
#include "record/home_shelf.h"
#include "validator/folder_reading.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

/// The records of a file of lines, each read by `read`.
template <class Record>
Result<std::vector<Record>> read_all(const LineFile& file, const fs::path& folder,
                                     Result<Record> (*read)(std::string_view, int, std::string_view)) {
  std::vector<Record> all;
  for (std::size_t i = 0; i < file.size(); ++i) {
    auto record = read((folder / file.name()).string(), static_cast<int>(i) + 1, file.line(i));
    if (!record) return record.error();
    all.push_back(std::move(*record));
  }
  return all;
}

/// The table `trait` of the database: which template, categories, places, rooms and home each task has.
Result<Done> read_level(const fs::path& file, FinishedSet& set) {
  try {
    SqliteFile database(file, SqliteFile::Mode::Read);
    auto rows = database.prepare("SELECT dimension, value, count(*) FROM trait GROUP BY 1, 2");
    while (rows.step())
      set.level[std::string(rows.text(0))][std::string(rows.text(1))] = static_cast<int>(rows.integer(2));
    return Done{};
  } catch (const std::exception& reason) {
    return Error{Error::Kind::Io, file.string(), {}, std::string("cannot read the table trait: ") + reason.what()};
  }
}

}  // namespace

Result<FinishedSet> read_finished_set(const fs::path& folder) {
  if (std::error_code code; !fs::is_directory(folder, code))
    return Error{Error::Kind::Usage, folder.string(), {}, "is not a folder; expected a finished data set"};
  FinishedSet set;
  set.folder = folder;
  set.name = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  if (!fs::exists(folder / "tasks.jsonl"))
    return Error{Error::Kind::Io, (folder / "tasks.jsonl").string(), {}, "cannot be read: there is no such file"};
  const auto lines = LineFile::read(folder, "tasks.jsonl");
  if (!lines) return lines.error();
  set.digest = sha256(lines->bytes());
  auto tasks = read_all<TaskRecord>(*lines, folder, read_task);
  if (!tasks) return tasks.error();
  set.tasks = std::move(*tasks);
  const auto rejections = LineFile::read(folder, "rejections.jsonl");
  if (!rejections) return rejections.error();
  auto given_up = read_all<RejectionRecord>(*rejections, folder, read_rejection);
  if (!given_up) return given_up.error();
  set.given_up = std::move(*given_up);
  if (auto level = read_level(folder / "dataset.sqlite", set); !level) return level.error();
  for (const Mode mode : kModes) {
    if (std::error_code code; fs::exists(folder / demonstrations_file(mode), code)) set.modes.push_back(mode);
  }
  return set;
}

Result<Scene> read_start_scene(const fs::path& folder, const TaskRecord& task) {
  return HomeShelf(folder).start("tasks.jsonl, " + task.id, task.layout, task.changes, task.scene);
}

Result<Done> read_demonstrations(const FinishedSet& set, Mode mode, int threads,
                                 const std::function<void(std::size_t, const DemonstrationRecord&)>& use) {
  const std::string file = (set.folder / demonstrations_file(mode)).string();
  const auto lines = LineFile::read(set.folder, demonstrations_file(mode));
  if (!lines) return lines.error();
  const auto at = [&](std::size_t i) { return SourcePos{static_cast<int>(i) + 1, 1}; };
  if (lines->size() != set.tasks.size())
    return Error{Error::Kind::Schema,
                 file,
                 {},
                 "expected one line for each of the " + std::to_string(set.tasks.size()) + " tasks, found " +
                     std::to_string(lines->size())};
  std::mutex mutex;
  std::map<std::size_t, Error> errors;  // by line, so that the first is told whoever found it
  share_work(threads, lines->size(), [&](std::size_t i) {
    const auto read = read_demonstration(file, static_cast<int>(i) + 1, lines->line(i));
    if (read && read->task == set.tasks[i].id) return use(i, *read);
    const std::lock_guard lock(mutex);
    errors.emplace(
        i, read ? Error{Error::Kind::Schema, file, at(i), "expected the task " + set.tasks[i].id} : read.error());
  });
  if (!errors.empty()) return errors.begin()->second;
  return Done{};
}

}  // namespace unietp
