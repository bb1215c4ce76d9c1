#include "exports/finished_tasks.h"

#include <nlohmann/json.hpp>

#include "core/files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

fs::path demonstrations_of(const fs::path& dataset, Mode mode) {
  return dataset / "demonstrations" / (std::string(name_of(mode)) + ".jsonl");
}

Error not_readable(const fs::path& file) {
  return {Error::Kind::Io, file.string(), {}, "cannot be read; expected a finished data set"};
}

}  // namespace

Result<FinishedTasks> FinishedTasks::open(const fs::path& dataset, const std::vector<Mode>& modes) {
  FinishedTasks all;
  all.dataset_ = dataset;
  all.homes_ = std::make_shared<HomeShelf>(dataset);
  all.tasks_.open(dataset / "tasks.jsonl");
  if (!all.tasks_) return not_readable(dataset / "tasks.jsonl");
  for (const Mode mode : modes) {
    auto& file = all.demonstrations_[mode];
    file.open(demonstrations_of(dataset, mode));
    if (!file) return not_readable(demonstrations_of(dataset, mode));
  }
  return all;
}

std::optional<TaskLines> FinishedTasks::next() {
  TaskLines lines;
  lines.number = ++number_;
  if (!std::getline(tasks_, lines.task) || lines.task.empty()) return std::nullopt;
  for (auto& [mode, file] : demonstrations_) std::getline(file, lines.shown[mode]);
  return lines;
}

Result<FinishedTask> FinishedTasks::read(const TaskLines& lines) const {
  FinishedTask task;
  const auto task_file = (dataset_ / "tasks.jsonl").string();
  auto record = read_task(task_file, lines.number, lines.task);
  if (!record) return record.error();
  task.record = std::move(*record);
  for (const auto& [mode, line] : lines.shown) {
    const auto file = demonstrations_of(dataset_, mode).string();
    auto shown = read_demonstration(file, lines.number, line);
    if (!shown) return shown.error();
    if (shown->task != task.record.id)
      return Error{Error::Kind::Schema,
                   file,
                   {lines.number, 1},
                   "expected the demonstration of " + task.record.id + ", not of " + shown->task};
    task.shown[mode] = std::move(*shown);
  }
  auto start = homes_->start(task_file + ":" + std::to_string(lines.number), task.record.layout, task.record.changes,
                             task.record.scene);
  if (!start) return start.error();
  task.start = std::move(*start);
  return task;
}

std::vector<Mode> shown_modes(const fs::path& dataset) {
  std::vector<Mode> modes;
  std::error_code code;
  for (const Mode mode : kModes) {
    if (fs::exists(demonstrations_of(dataset, mode), code)) modes.push_back(mode);
  }
  return modes;
}

bool acted_wide(const fs::path& dataset) {
  const auto text = read_file(dataset / "manifest.json");
  if (!text) return false;
  const auto manifest = nlohmann::json::parse(*text, nullptr, false);
  const nlohmann::json::json_pointer extended("/configuration/extended");
  return manifest.is_object() && manifest.contains(extended) && manifest[extended] == true;
}

const ValidationBackend& backend_of(const std::vector<ValidationBackend>& backends, const Scene& scene) {
  return backends[static_cast<std::size_t>(scene.simulator)];
}

}  // namespace unietp
