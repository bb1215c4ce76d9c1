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

std::string demonstrations_file(Mode mode) { return "demonstrations/" + std::string(name_of(mode)) + ".jsonl"; }
std::string at_line(std::string_view file, std::size_t index) {
  return std::string(file) + ":" + std::to_string(index + 1);
}
std::string scene_file(const std::string& scene) { return "scenes/" + scene + ".scene.json.gz"; }

/// A line of tasks.jsonl with what belongs to it, each part as it read.
struct Entry {
  std::string name;  // the task's id, or the best guess at it
  Result<TaskRecord> task = Error{};
  struct Shown {
    Mode mode = Mode::M1;
    std::size_t line = 0;
  };
  std::vector<Shown> demonstrations;
  std::vector<Error> errors;
};

Result<std::vector<std::string>> lines_of(const fs::path& folder, const std::string& file) {
  const auto text = read_file(folder / file);
  if (!text) return text.error();
  auto lines = split(*text, '\n');
  if (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

/// The file of one mode.
struct Demonstrations {
  Mode mode = Mode::M1;
  std::vector<Result<DemonstrationRecord>> lines;
  std::map<std::string, std::size_t> line_of_task;
};

Demonstrations read_demonstrations(Mode mode, const std::vector<std::string>& lines, std::vector<Problem>& problems) {
  Demonstrations all;
  all.mode = mode;
  const std::string file = demonstrations_file(mode);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    all.lines.push_back(read_demonstration(file, static_cast<int>(i + 1), lines[i]));
    if (!all.lines.back()) continue;
    const auto& task = all.lines.back()->task;
    if (!all.line_of_task.emplace(task, i).second)
      problems.push_back({task, {Error::Kind::Schema, at_line(file, i), {}, "repeats a demonstration"}});
  }
  return all;
}

/// A task's demonstrations in the modes that it counts steps for: by name, or, where one does not read, by line.
void find_demonstrations(Entry& entry, std::size_t index, const std::vector<Demonstrations>& all) {
  for (const Demonstrations& shown : all) {
    const auto counted = [&shown](const TaskRecord::Count& count) { return count.mode == shown.mode; };
    if (std::none_of(entry.task->expert.begin(), entry.task->expert.end(), counted)) continue;
    const auto named = shown.line_of_task.find(entry.name);
    if (named != shown.line_of_task.end()) {
      entry.demonstrations.push_back({shown.mode, named->second});
    } else if (index < shown.lines.size() && !shown.lines[index]) {
      entry.errors.push_back(shown.lines[index].error());
    } else {
      entry.errors.push_back(
          {Error::Kind::Schema, demonstrations_file(shown.mode), {}, "has no demonstration of this task"});
    }
  }
}

/// Demonstrations of no task, or of one that counts no steps for the mode.
void find_strays(const Demonstrations& shown, const std::vector<Entry>& entries, std::vector<Problem>& problems) {
  const std::string file = demonstrations_file(shown.mode);
  for (const auto& [task, line] : shown.line_of_task) {
    const auto entry =
        std::find_if(entries.begin(), entries.end(), [&id = task](const auto& e) { return e.name == id; });
    if (entry == entries.end()) {
      problems.push_back({task, {Error::Kind::Schema, at_line(file, line), {}, "is of no task in tasks.jsonl"}});
      continue;
    }
    const auto used = [&shown](const Entry::Shown& one) { return one.mode == shown.mode; };
    if (entry->task && std::none_of(entry->demonstrations.begin(), entry->demonstrations.end(), used))
      problems.push_back(
          {task, {Error::Kind::Schema, at_line(file, line), {}, "is in a mode for which its task counts no steps"}});
  }
  for (std::size_t i = entries.size(); i < shown.lines.size(); ++i) {
    if (!shown.lines[i]) problems.push_back({"", shown.lines[i].error()});
  }
}

/// Reads all tasks and finds each one's demonstrations.
std::vector<Entry> read_entries(const std::vector<std::string>& lines, const std::vector<Demonstrations>& shown,
                                std::vector<Problem>& problems) {
  std::vector<Entry> entries(lines.size());
  std::map<std::string, std::size_t> first_line;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Entry& entry = entries[i];
    entry.task = read_task(kTasks, static_cast<int>(i + 1), lines[i]);
    if (!entry.task) {
      const auto& beside = shown.front().lines;  // M1
      entry.name = i < beside.size() && beside[i] ? beside[i]->task : at_line(kTasks, i);
      entry.errors.push_back(entry.task.error());
      continue;
    }
    entry.name = entry.task->id;
    if (!first_line.emplace(entry.name, i).second)
      entry.errors.push_back({Error::Kind::Schema, at_line(kTasks, i), {}, "the id is taken by an earlier task"});
    find_demonstrations(entry, i, shown);
  }
  for (const Demonstrations& one : shown) find_strays(one, entries, problems);
  return entries;
}

Result<Scene> read_scene(const fs::path& folder, const std::string& file) {
  const auto packed = read_file(folder / file);
  if (!packed) return Error{Error::Kind::Io, file, {}, packed.error().message};
  const auto text = gunzip(file, *packed);
  if (!text) return text.error();
  return scene_from_json(file, *text);
}

void prove_entry(Entry& entry, std::size_t index, const fs::path& folder, const std::vector<Demonstrations>& shown,
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
  if (!simulator || !scene) return;
  const auto& backend = backends[static_cast<std::size_t>(*simulator)];
  const auto found_in = [&entry](std::vector<Error> found) {
    entry.errors.insert(entry.errors.end(), found.begin(), found.end());
  };
  TaskFiles files{at_line(kTasks, index), scene_file(task.scene), ""};
  found_in(prove_task(task, *scene, backend, options, files));
  for (const auto& [mode, line] : entry.demonstrations) {
    files.demonstration = at_line(demonstrations_file(mode), line);
    found_in(
        prove_demonstration(task, *scene, mode, *shown[static_cast<std::size_t>(mode)].lines[line], backend, files));
  }
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
  if (!task_lines) report.problems.push_back({"", task_lines.error()});
  std::vector<Problem> strays;
  std::vector<Demonstrations> shown;  // by mode
  for (const Mode mode : kModes) {
    const auto file = demonstrations_file(mode);
    std::error_code code;
    const bool wanted = mode == Mode::M1 || fs::exists(folder / file, code);
    const auto lines = wanted ? lines_of(folder, file) : std::vector<std::string>{};
    if (!lines) report.problems.push_back({"", lines.error()});
    shown.push_back(read_demonstrations(mode, lines ? *lines : std::vector<std::string>{}, strays));
  }
  auto entries = read_entries(task_lines ? *task_lines : std::vector<std::string>{}, shown, strays);
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
      prove_entry(entries[i], i, folder, shown, backends, options);
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
