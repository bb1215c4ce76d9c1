#include "report/data_set.h"

#include "core/file_digest.h"
#include "record/dataset_reader.h"
#include "record/home_cache.h"

namespace unietp {

namespace fs = std::filesystem;

Result<FinishedSet> read_finished_set(const fs::path& folder) {
  if (std::error_code code; !fs::is_directory(folder, code))
    return Error{Error::Kind::Usage, folder.string(), {}, "is not a folder; expected a finished data set"};
  FinishedSet set;
  set.folder = folder;
  set.name = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  if (const auto reader = DatasetReader::open(folder, {}); !reader) return reader.error();
  const auto digest = digest_of_file(folder, kTasksFile);
  if (!digest) return digest.error();
  set.digest = digest->sha256;
  auto level = trait_counts(folder / "dataset.sqlite");
  if (!level) return level.error();
  set.level = std::move(*level);
  set.modes = shown_modes(folder);
  return set;
}

Result<Scene> read_start_scene(const fs::path& folder, const TaskRecord& task) {
  return HomeCache(folder).start("tasks.jsonl, " + task.id, task.layout, task.changes, task.scene);
}

Error changed_while_read(const FinishedSet& set) {
  return {Error::Kind::Io, (set.folder / kTasksFile).string(), {}, "was changed while it was read; try again"};
}

}  // namespace unietp
