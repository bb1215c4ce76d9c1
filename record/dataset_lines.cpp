#include "record/dataset_lines.h"

#include <algorithm>

namespace unietp {
namespace {

/// The name in one of the first fields of a line, found without parsing it; "" when it is not there.
std::string name_in(const FileLine& line, std::string_view quoted_field) {
  constexpr std::size_t kSearched = 400;  // the field is the second of the format
  const std::string_view text = line.text;
  const auto field = text.substr(0, kSearched).find(quoted_field);
  if (field == std::string_view::npos) return "";
  const auto open = text.find('"', field + quoted_field.size());
  const auto close = open == std::string_view::npos ? open : text.find('"', open + 1);
  return close == std::string_view::npos ? "" : std::string(text.substr(open + 1, close - open - 1));
}

std::string noun_of(const std::optional<Mode>& mode) { return mode ? "demonstration" : "wordings"; }

std::string owner_of(const std::string& task) { return task.empty() ? "of no task" : "of " + task; }

/// A line that belongs to no task here; `expected` is the task whose line it should be, or "" after the last one.
StrayLine stray_line(const std::optional<Mode>& mode, const LineFile& file, const FileLine& line,
                     const std::string& task, const std::string& expected) {
  std::string message = line.fault;
  if (message.empty())
    message = expected.empty() ? "expected the end of the file, not the " + noun_of(mode) + " " + owner_of(task)
                               : "expected the " + noun_of(mode) + " of " + expected + ", not " + owner_of(task);
  return {mode, task, line.fault.empty(), {Error::Kind::Schema, file.at(line.number), {}, std::move(message)}};
}

}  // namespace

std::string demonstrations_file(Mode mode) { return "demonstrations/" + std::string(name_of(mode)) + ".jsonl"; }

std::vector<Mode> shown_modes(const std::filesystem::path& folder) {
  std::vector<Mode> modes;
  std::error_code code;
  for (const Mode mode : kModes) {
    if (std::filesystem::exists(std::filesystem::symlink_status(folder / demonstrations_file(mode), code)))
      modes.push_back(mode);  // also a link, which is refused when it is opened
  }
  return modes;
}

Result<DatasetLines> DatasetLines::open(const std::filesystem::path& folder, const DatasetParts& parts,
                                        FileNames names) {
  auto tasks = LineFile::open(folder, kTasksFile, names);
  if (!tasks) return tasks.error();
  DatasetLines lines(std::move(*tasks));
  std::vector<std::optional<Mode>> wanted(parts.modes.begin(), parts.modes.end());
  if (parts.wordings) wanted.emplace_back();
  for (const auto& mode : wanted) {
    auto file = LineFile::open(folder, mode ? demonstrations_file(*mode) : kWordingsFile, names);
    if (!file) return file.error();
    lines.parts_.push_back({mode, std::move(*file), {}, 0, 0});
  }
  return lines;
}

bool DatasetLines::PartFile::read_ahead() {
  auto line = file->next();
  if (!line) return false;
  lines = line->number;
  bytes_ahead += line->text.size();
  auto task = name_in(*line, "\"task\":");
  ahead.emplace_back(std::move(*line), std::move(task));
  return true;
}

/// The position of the task's line among those ahead; nullopt when it is not within kLookAheadBytes.
std::optional<std::size_t> DatasetLines::PartFile::find(std::string_view task) {
  for (std::size_t i = 0; i < ahead.size() || (bytes_ahead < kLookAheadBytes && read_ahead()); ++i) {
    if (ahead[i].second == task) return i;
  }
  return std::nullopt;
}

std::pair<FileLine, std::string> DatasetLines::PartFile::pop() {
  auto line = std::move(ahead.front());
  ahead.pop_front();
  bytes_ahead -= line.first.text.size();
  return line;
}

PartLine DatasetLines::PartFile::take(const std::string& task, std::vector<StrayLine>& strays) {
  if (const auto place = task.empty() ? std::nullopt : find(task)) {
    for (std::size_t i = 0; i < *place; ++i) {
      const auto [line, name] = pop();
      strays.push_back(stray_line(mode, *file, line, name, task));
    }
    return {pop().first, {}};
  }
  if (ahead.empty() && !read_ahead())
    return {std::nullopt,
            {Error::Kind::Schema,
             file->at(lines + 1),
             {},
             "expected the " + noun_of(mode) + " of " + task + ", not the end of the file"}};
  const auto& [line, name] = ahead.front();
  if (name.empty())
    return {pop().first, {}};  // assumed to be the task's line, whose error is reported when it is parsed
  return {std::nullopt, stray_line(mode, *file, line, name, task).error};
}

std::optional<TaskLines> DatasetLines::next() {
  auto line = tasks_.next();
  if (!line) return std::nullopt;
  TaskLines lines;
  lines.id = name_in(*line, "\"id\":");
  lines.task = std::move(*line);
  for (const Mode mode : kModes)
    lines.shown[static_cast<std::size_t>(mode)].missing = {
        Error::Kind::Schema, demonstrations_file(mode), {}, "is missing; expected the demonstration of " + lines.id};
  for (PartFile& file : parts_) {
    auto& own = file.mode ? lines.shown[static_cast<std::size_t>(*file.mode)] : lines.wordings;
    own = file.take(lines.id, lines.strays);
  }
  return lines;
}

std::optional<StrayLine> DatasetLines::next_stray() {
  for (PartFile& file : parts_) {
    if (file.ahead.empty() && !file.read_ahead()) continue;
    const auto [line, name] = file.pop();
    return stray_line(file.mode, *file.file, line, name, "");
  }
  return std::nullopt;
}

std::string DatasetLines::shown_at(Mode mode, int line) const {
  for (const PartFile& file : parts_) {
    if (file.mode == mode) return file.file->at(line);
  }
  return demonstrations_file(mode) + ":" + std::to_string(line);
}

std::string DatasetLines::wordings_at(int line) const {
  for (const PartFile& file : parts_) {
    if (!file.mode) return file.file->at(line);
  }
  return std::string(kWordingsFile) + ":" + std::to_string(line);
}

}  // namespace unietp
