#include "validator/validate.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <thread>

#include "core/files.h"
#include "core/text.h"
#include "scene/scene_json.h"
#include "validator/manifest_check.h"
#include "validator/prove.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
constexpr const char* kTasks = "tasks.jsonl";
constexpr const char* kDemonstrations = "demonstrations/M1.jsonl";

std::string at_line(std::string_view file, std::size_t index) {
  return std::string(file) + ":" + std::to_string(index + 1);
}
std::string scene_file(const std::string& scene) { return "scenes/" + scene + ".scene.json.gz"; }

/// A line of tasks.jsonl with what belongs to it, each part as it read.
struct Entry {
  std::string name;  // the task's id, or the best guess at it
  Result<TaskRecord> task = Error{};
  std::optional<std::size_t> line_of_demonstration;
  std::vector<Error> errors;
};

Result<std::vector<std::string>> lines_of(const fs::path& folder, const char* file) {
  const auto text = read_file(folder / file);
  if (!text) return text.error();
  auto lines = split(*text, '\n');
  if (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

struct Demonstrations {
  std::vector<Result<DemonstrationRecord>> lines;
  std::map<std::string, std::size_t> line_of_task;
};

Demonstrations read_demonstrations(const std::vector<std::string>& lines, std::vector<Problem>& problems) {
  Demonstrations all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    all.lines.push_back(read_demonstration(kDemonstrations, static_cast<int>(i + 1), lines[i]));
    if (!all.lines.back()) continue;
    const auto& task = all.lines.back()->task;
    if (!all.line_of_task.emplace(task, i).second)
      problems.push_back({task, {Error::Kind::Schema, at_line(kDemonstrations, i), {}, "repeats a demonstration"}});
  }
  return all;
}

/// Reads all tasks and finds each one's demonstration: by name, or, where one of the two does not read, by line.
std::vector<Entry> read_entries(const std::vector<std::string>& lines, const Demonstrations& demonstrations,
                                std::vector<Problem>& problems) {
  std::vector<Entry> entries(lines.size());
  std::map<std::string, std::size_t> first_line;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Entry& entry = entries[i];
    const auto* beside = i < demonstrations.lines.size() ? &demonstrations.lines[i] : nullptr;
    entry.task = read_task(kTasks, static_cast<int>(i + 1), lines[i]);
    if (!entry.task) {
      entry.name = beside != nullptr && *beside ? (*beside)->task : at_line(kTasks, i);
      entry.errors.push_back(entry.task.error());
      continue;
    }
    entry.name = entry.task->id;
    if (!first_line.emplace(entry.name, i).second)
      entry.errors.push_back({Error::Kind::Schema, at_line(kTasks, i), {}, "the id is taken by an earlier task"});
    const auto named = demonstrations.line_of_task.find(entry.name);
    if (named != demonstrations.line_of_task.end()) {
      entry.line_of_demonstration = named->second;
    } else if (beside != nullptr && !*beside) {
      entry.errors.push_back(beside->error());
    } else {
      entry.errors.push_back({Error::Kind::Schema, kDemonstrations, {}, "has no demonstration of this task"});
    }
  }
  for (const auto& [task, line] : demonstrations.line_of_task) {
    const bool known =
        std::any_of(entries.begin(), entries.end(), [&id = task](const auto& e) { return e.name == id; });
    if (!known)
      problems.push_back(
          {task, {Error::Kind::Schema, at_line(kDemonstrations, line), {}, "is of no task in tasks.jsonl"}});
  }
  for (std::size_t i = lines.size(); i < demonstrations.lines.size(); ++i) {
    if (!demonstrations.lines[i]) problems.push_back({"", demonstrations.lines[i].error()});
  }
  return entries;
}

Result<Scene> read_scene(const fs::path& folder, const std::string& file) {
  const auto packed = read_file(folder / file);
  if (!packed) return Error{Error::Kind::Io, file, {}, packed.error().message};
  const auto text = gunzip(file, *packed);
  if (!text) return text.error();
  return scene_from_json(file, *text);
}

void prove_entry(Entry& entry, std::size_t index, const fs::path& folder, const Demonstrations& demonstrations,
                 const std::vector<ValidationBackend>& backends, const ValidationOptions& options) {
  if (!entry.task) return;
  const auto& task = *entry.task;
  const auto simulator = simulator_named(task.simulator);
  if (!simulator)
    entry.errors.push_back(
        {Error::Kind::Schema,
         at_line(kTasks, index),
         {},
         "unknown simulator \"" + task.simulator + "\"; accepted are ai2thor, virtualhome, habitat, behavior"});
  if (task.scene.find('/') != std::string::npos) {  // would lead out of the data set
    entry.errors.push_back({Error::Kind::Schema, at_line(kTasks, index), {}, "a scene's name has no '/'"});
    return;
  }
  const auto scene = read_scene(folder, scene_file(task.scene));
  if (!scene) entry.errors.push_back(scene.error());
  if (!simulator || !scene || !entry.line_of_demonstration) return;
  const std::size_t line = *entry.line_of_demonstration;
  const TaskFiles files{at_line(kTasks, index), scene_file(task.scene), at_line(kDemonstrations, line)};
  auto found = prove_task(task, *scene, *demonstrations.lines[line], backends[static_cast<std::size_t>(*simulator)],
                          options, files);
  entry.errors.insert(entry.errors.end(), found.begin(), found.end());
}

/// A checksum that fails is the task's own problem when the file belongs to one task alone.
std::string owner_of(const std::string& file, const std::vector<Entry>& entries) {
  for (const auto& entry : entries) {
    if (entry.task && scene_file(entry.task->scene) == file) return entry.name;
  }
  return "";
}

}  // namespace

ValidationReport validate_dataset(const fs::path& folder, const std::vector<ValidationBackend>& backends,
                                  std::string_view knowledge_digest, const ValidationOptions& options) {
  ValidationReport report;
  if (std::error_code code; !fs::is_directory(folder, code)) {
    report.problems.push_back(
        {"", {Error::Kind::Io, folder.string(), {}, "is no folder; a finished data set is expected"}});
    return report;
  }
  const auto manifest = check_manifest(folder, knowledge_digest);
  const auto task_lines = lines_of(folder, kTasks);
  const auto demonstration_lines = lines_of(folder, kDemonstrations);
  for (const auto* lines : {&task_lines, &demonstration_lines}) {
    if (!*lines) report.problems.push_back({"", lines->error()});
  }
  std::vector<Problem> strays;
  const auto demonstrations =
      read_demonstrations(demonstration_lines ? *demonstration_lines : std::vector<std::string>{}, strays);
  auto entries = read_entries(task_lines ? *task_lines : std::vector<std::string>{}, demonstrations, strays);
  for (const auto& error : manifest.errors) report.problems.push_back({owner_of(error.where, entries), error});
  report.problems.insert(report.problems.end(), strays.begin(), strays.end());
  if (manifest.tasks >= 0 && manifest.tasks != static_cast<int>(entries.size()))
    report.problems.push_back(
        {"",
         {Error::Kind::Schema,
          kTasks,
          {},
          "has " + std::to_string(entries.size()) + " tasks, the manifest counts " + std::to_string(manifest.tasks)}});

  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < entries.size(); i = next++)
      prove_entry(entries[i], i, folder, demonstrations, backends, options);
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < options.threads; ++i) threads.emplace_back(work);
  work();
  for (auto& thread : threads) thread.join();

  report.tasks = std::max(static_cast<int>(entries.size()), manifest.tasks);
  for (const auto& entry : entries) {
    if (entry.errors.empty()) ++report.proven;
    for (const auto& error : entry.errors) report.problems.push_back({entry.name, error});
  }
  return report;
}

}  // namespace unietp
