#include "report/data_set.h"

#include <atomic>
#include <mutex>
#include <thread>

#include <nlohmann/json.hpp>

#include "core/digest.h"
#include "core/files.h"
#include "core/sqlite_file.h"
#include "core/text.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path demonstrations_of(const fs::path& folder, Mode mode) {
  return folder / "demonstrations" / (std::string(name_of(mode)) + ".jsonl");
}

Result<std::vector<GivenUp>> read_given_up(const fs::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  std::vector<GivenUp> all;
  int number = 0;
  for (const auto& line : split(*text, '\n')) {
    ++number;
    if (line.empty()) continue;
    try {
      const Json json = Json::parse(line);
      const auto field = [&](const char* name) { return json.at(name).get<std::string>(); };
      all.push_back({field("template"), field("simulator"), field("split"), field("stage"), field("reason")});
    } catch (const Json::exception& reason) {
      return Error{
          Error::Kind::Schema, file.string(), {number, 1}, std::string("expected a rejection: ") + reason.what()};
    }
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
    return Error{Error::Kind::Io, file.string(), {}, std::string("cannot read its table trait: ") + reason.what()};
  }
}

}  // namespace

void in_threads(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  const auto turn = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(turn);
  turn();
  for (auto& other : others) other.join();
}

Result<FinishedSet> read_finished_set(const fs::path& folder) {
  if (std::error_code code; !fs::is_directory(folder, code))
    return Error{Error::Kind::Usage, folder.string(), {}, "is no folder; a finished data set is expected"};
  FinishedSet set;
  set.folder = folder;
  set.name = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  const auto file = folder / "tasks.jsonl";
  const auto text = read_file(file);
  if (!text) return text.error();
  set.digest = sha256(*text);
  int number = 0;
  for (const auto& line : split(*text, '\n')) {
    ++number;
    if (line.empty()) continue;
    auto task = read_task(file.string(), number, line);
    if (!task) return task.error();
    set.tasks.push_back(std::move(*task));
  }
  auto given_up = read_given_up(folder / "rejections.jsonl");
  if (!given_up) return given_up.error();
  set.given_up = std::move(*given_up);
  if (auto level = read_level(folder / "dataset.sqlite", set); !level) return level.error();
  for (const Mode mode : kModes) {
    if (std::error_code code; fs::exists(demonstrations_of(folder, mode), code)) set.modes.push_back(mode);
  }
  return set;
}

Result<Scene> read_start_scene(const fs::path& folder, const TaskRecord& task) {
  const auto file = folder / "scenes" / (task.scene + ".scene.json.gz");
  const auto text = read_maybe_gzip(file);
  if (!text) return text.error();
  return scene_from_json(file.string(), *text);
}

Result<Done> read_demonstrations(const FinishedSet& set, Mode mode, int threads,
                                 const std::function<void(std::size_t, const DemonstrationRecord&)>& use) {
  const auto file = demonstrations_of(set.folder, mode);
  const auto text = read_file(file);
  if (!text) return text.error();
  std::vector<std::string_view> lines;
  for (std::size_t from = 0; from < text->size();) {
    const std::size_t end = std::min(text->find('\n', from), text->size());
    if (end > from) lines.push_back(std::string_view(*text).substr(from, end - from));
    from = end + 1;
  }
  const auto at = [&](std::size_t i) { return SourcePos{static_cast<int>(i) + 1, 1}; };
  if (lines.size() != set.tasks.size())
    return Error{Error::Kind::Schema,
                 file.string(),
                 {},
                 "expected one line for each of the " + std::to_string(set.tasks.size()) + " tasks, found " +
                     std::to_string(lines.size())};
  std::mutex mutex;
  std::map<std::size_t, Error> errors;  // by line, so that the first is told whoever found it
  in_threads(lines.size(), threads, [&](std::size_t i) {
    const auto read = read_demonstration(file.string(), static_cast<int>(i) + 1, lines[i]);
    if (read && read->task == set.tasks[i].id) return use(i, *read);
    const std::lock_guard lock(mutex);
    errors.emplace(i, read ? Error{Error::Kind::Schema, file.string(), at(i), "expected the task " + set.tasks[i].id}
                           : read.error());
  });
  if (!errors.empty()) return errors.begin()->second;
  return Done{};
}

}  // namespace unietp
