#include "core/files.h"
#include "exports/formats.h"
#include "exports/task_folder.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

/// `<scene>.scene.json.gz` for each task, for readers that do not want to apply a task's changes to its home.
Result<ExportSummary> write_starts(const ExportRequest& request) {
  using LeftOut = Result<std::optional<std::string>>;
  const auto say = [](const FinishedTask& task, const std::filesystem::path& folder) {
    const auto file = task.start.id + ".scene.json.gz";
    if (auto written = write_file(folder, file, gzip(scene_to_json(task.start))); !written)
      return LeftOut(written.error());
    return LeftOut(std::nullopt);
  };
  const auto made = write_task_folder(request.dataset, {}, request.out, say);
  if (!made) return made.error();
  return summary_of(*made, request.out);
}

}  // namespace

ExportFormat starts_format() { return {"starts", "each task's complete start scene", {}, false, write_starts}; }

}  // namespace unietp
