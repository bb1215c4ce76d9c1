#include "record/dataset_reader.h"

#include <algorithm>

#include "core/limits.h"
#include "core/text.h"
#include "logic/formula_size.h"

namespace unietp {
namespace {

Error at_line(std::string where, std::string message) {
  return {Error::Kind::Schema, std::move(where), {}, std::move(message)};
}

/// "tasks.jsonl" of "tasks.jsonl:3": readers of lines add the number themselves.
std::string without_line(const std::string& where) { return where.substr(0, where.rfind(':')); }

/// Members that a domain has at the start, pieces that are cut later aside.
double members_at_most(const Domain& domain, const Scene& start) {
  if (domain.kind == Domain::Kind::Agent) return 1;
  if (domain.kind == Domain::Kind::Room) return static_cast<double>(start.rooms.size());
  if (domain.kind == Domain::Kind::Object) return static_cast<double>(start.nodes.size());
  return static_cast<double>(std::count_if(start.nodes.begin(), start.nodes.end(), [&](const Node& node) {
    return std::any_of(domain.members.begin(), domain.members.end(),
                       [&](const Domain::Member& member) { return member.category == node.category; });
  }));
}

template <class Record>
Result<Record> parse(const std::string& where, const FileLine& line,
                     Result<Record> (*read)(std::string_view, int, std::string_view)) {
  if (!line.fault.empty()) return at_line(where, line.fault);
  return read(without_line(where), line.number, line.text);
}

}  // namespace

Result<Done> check_combinations(const std::string& where, const Formula& goal, const Scene& start) {
  const auto members = [&](const Domain& domain) { return members_at_most(domain, start); };
  const double all = combinations_of(goal, members);
  if (all <= limits::kCombinations) return Done{};
  return at_line(where, "its goal ranges over " + number_text(all) + " combinations of objects; accepted are at most " +
                            number_text(limits::kCombinations));
}

Result<DatasetReader> DatasetReader::open(const std::filesystem::path& folder, const DatasetParts& parts,
                                          FileNames names) {
  auto lines = DatasetLines::open(folder, parts, names);
  if (!lines) return lines.error();
  return DatasetReader(std::move(*lines), parts, std::make_shared<HomeCache>(folder));
}

Result<TaskRecord> DatasetReader::task(const TaskLines& lines) const {
  return parse(lines_.task_at(lines.task.number), lines.task, read_task);
}

Result<DemonstrationRecord> DatasetReader::demonstration(const TaskLines& lines, Mode mode) const {
  const FileLine& line = *lines.shown_in(mode).line;
  return parse(lines_.shown_at(mode, line.number), line, read_demonstration);
}

Result<WordingsRecord> DatasetReader::wordings(const TaskLines& lines) const {
  const FileLine& line = *lines.wordings.line;
  const auto where = lines_.wordings_at(line.number);
  auto wordings = parse(where, line, read_wordings);
  if (wordings && !lines.id.empty() && wordings->task != lines.id)
    return at_line(where, "expected the wordings of " + lines.id + ", not of " + wordings->task);
  return wordings;
}

std::optional<Error> DatasetReader::misplaced(const TaskLines& lines, Mode mode, const DemonstrationRecord& shown,
                                              const TaskRecord& task) const {
  const auto where = lines_.shown_at(mode, lines.shown_in(mode).line->number);
  if (shown.task != task.id)
    return at_line(where, "expected the demonstration of " + task.id + ", not of " + shown.task);
  if (shown.mode != name_of(mode))
    return at_line(where, "expected the mode \"" + std::string(name_of(mode)) + "\", not \"" + shown.mode + "\"");
  if (std::none_of(task.expert.begin(), task.expert.end(), [mode](const auto& count) { return count.mode == mode; }))
    return at_line(where, "is in a mode that its task does not list");
  return std::nullopt;
}

Result<Scene> DatasetReader::start(const TaskLines& lines, const TaskRecord& task) const {
  const auto where = lines_.task_at(lines.task.number);
  auto start = homes_->start(where, task.layout, task.changes, task.scene);
  if (!start) return start;
  if (auto fine = check_combinations(where, task.goal_tree, *start); !fine) return fine.error();
  return start;
}

std::optional<Error> DatasetReader::line_error(const TaskLines& lines) const {
  if (!lines.strays.empty()) return lines.strays.front().error;
  if (!lines.task.fault.empty()) return at_line(lines_.task_at(lines.task.number), lines.task.fault);
  for (const Mode mode : parts_.modes) {
    const PartLine& shown = lines.shown_in(mode);
    if (!shown.line) return shown.missing;
    if (!shown.line->fault.empty()) return at_line(lines_.shown_at(mode, shown.line->number), shown.line->fault);
  }
  if (!parts_.wordings) return std::nullopt;
  const PartLine& wordings = lines.wordings;
  if (!wordings.line) return wordings.missing;
  if (wordings.line->fault.empty()) return std::nullopt;
  return at_line(lines_.wordings_at(wordings.line->number), wordings.line->fault);
}

Result<FinishedTask> DatasetReader::read(const TaskLines& lines) const {
  if (auto error = line_error(lines)) return *error;
  auto record = task(lines);
  if (!record) return record.error();
  FinishedTask finished;
  finished.record = std::move(*record);
  for (const Mode mode : parts_.modes) {
    auto shown = demonstration(lines, mode);
    if (!shown) return shown.error();
    if (auto error = misplaced(lines, mode, *shown, finished.record)) return *error;
    finished.shown[mode] = std::move(*shown);
  }
  if (parts_.wordings) {
    auto own = wordings(lines);
    if (!own) return own.error();
    finished.wordings = std::move(*own);
  }
  if (parts_.starts) {
    auto scene = start(lines, finished.record);
    if (!scene) return scene.error();
    finished.start = std::move(*scene);
  }
  return finished;
}

}  // namespace unietp
