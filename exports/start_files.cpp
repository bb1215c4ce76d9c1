#include "exports/start_files.h"

#include "core/files.h"
#include "scene/scene_json.h"

namespace unietp {

Result<ExportedTasks> export_starts(const std::filesystem::path& dataset, const std::filesystem::path& out) {
  using LeftOut = Result<std::optional<std::string>>;
  return write_task_folder(dataset, {}, out, [](const FinishedTask& task, const std::filesystem::path& folder) {
    const auto file = folder / (task.start.id + ".scene.json.gz");
    if (auto written = write_file(file, gzip(scene_to_json(task.start))); !written) return LeftOut(written.error());
    return LeftOut(std::nullopt);
  });
}

}  // namespace unietp
