#include "report/data_set.h"

#include "core/file_digest.h"
#include "record/dataset_reader.h"
#include "record/home_cache.h"
#include "record/record_file.h"

namespace unietp {

namespace fs = std::filesystem;

Result<FinishedSet> read_finished_set(const fs::path& folder) {
  if (std::error_code code; !fs::is_directory(folder, code))
    return Error{Error::Kind::Usage, folder.string(), {}, "is not a folder; expected a finished data set"};
  FinishedSet set;
  set.folder = folder;
  set.name = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  auto reader = DatasetReader::open(folder, {});
  if (!reader) return reader.error();
  const auto digest = digest_of_file(folder, kTasksFile);
  if (!digest) return digest.error();
  set.digest = digest->sha256;
  while (const auto lines = reader->lines().next()) {
    auto task = reader->read(*lines);
    if (!task) return task.error();
    set.tasks.push_back(std::move(task->record));
  }
  auto rejections =
      RecordFile<RejectionRecord>::open(folder, "rejections.jsonl", FileNames::WithFolder, read_rejection);
  if (!rejections) return rejections.error();
  while (auto rejection = rejections->next()) {
    if (!*rejection) return rejection->error();
    set.given_up.push_back(std::move(**rejection));
  }
  auto level = trait_counts(folder / "dataset.sqlite");
  if (!level) return level.error();
  set.level = std::move(*level);
  set.modes = shown_modes(folder);
  return set;
}

Result<Scene> read_start_scene(const fs::path& folder, const TaskRecord& task) {
  return HomeCache(folder).start("tasks.jsonl, " + task.id, task.layout, task.changes, task.scene);
}

Result<Done> read_demonstrations(const FinishedSet& set, Mode mode, int threads,
                                 const std::function<void(std::size_t, const DemonstrationRecord&)>& use) {
  auto reader = DatasetReader::open(set.folder, {.modes = {mode}});
  if (!reader) return reader.error();
  std::size_t next = 0;
  const auto done = for_each_task<DemonstrationRecord>(
      std::move(*reader), threads,
      [mode](const FinishedTask& task) -> Result<DemonstrationRecord> { return task.shown.at(mode); },
      [&](DemonstrationRecord&& shown) -> Result<Done> {
        use(next++, shown);
        return Done{};
      });
  return done;
}

}  // namespace unietp
