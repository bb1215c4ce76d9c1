#include <nlohmann/json.hpp>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "record/dataset_reader.h"
#include "record/manifest_record.h"
#include "record/review_mark_record.h"
#include "record/task_record.h"
#include "record/wordings_record.h"
#include "scene/scene_json.h"
#include "support.h"

namespace unietp::fuzz {

bool task_body(std::string_view text) {
  const auto task = read_task("fuzz", 1, text);
  if (!task) {
    check_error(task.error());
    return false;
  }
  for (const auto& count : task->expert) require(count.steps >= 0 && count.failures >= 0);
  const auto goal = parse_formula("fuzz", task->goal_text, FormulaUse::Goal);
  if (goal && *goal == task->goal_tree) check_formula(task->goal_tree, FormulaUse::Goal);
  return true;
}

bool demonstration_body(std::string_view text) {
  const auto demonstration = read_demonstration("fuzz", 1, text);
  if (!demonstration) {
    check_error(demonstration.error());
    return false;
  }
  const auto plan = read_demonstrated_plan("fuzz", 1, text);
  require(plan && plan->task == demonstration->task && plan->commands.size() == demonstration->steps.size());
  for (const StepRecord& step : demonstration->steps) {
    const auto command = command_from_json("fuzz", command_to_json(step.command));
    require(command && *command == step.command);
    const auto changes = delta_from_json("fuzz", nlohmann::ordered_json::parse(delta_to_json(step.changes)));
    require(changes && *changes == step.changes);
  }
  return true;
}

bool wordings_body(std::string_view text) {
  const auto wordings = read_wordings("fuzz", 1, text);
  if (!wordings) {
    check_error(wordings.error());
    return false;
  }
  require(wordings->wordings.contains(WordingKind::Direct));
  for (const auto& [kind, wording] : wordings->wordings) require(!wording.text.empty());
  return true;
}

bool rejection_body(std::string_view text) {
  const auto rejection = read_rejection("fuzz", 1, text);
  if (!rejection) {
    check_error(rejection.error());
    return false;
  }
  require(rejection->slot >= 0 && rejection->attempt >= 0 && !rejection->reason.empty());
  return true;
}

bool manifest_body(std::string_view text) {
  const auto manifest = read_manifest("fuzz", text);
  if (!manifest) {
    check_error(manifest.error());
    return false;
  }
  require(manifest->tasks >= 0 && manifest->run.count >= 0);
  return true;
}

bool mark_body(std::string_view text) {
  const auto mark = read_review_mark("fuzz", 1, text);
  if (!mark) {
    check_error(mark.error());
    return false;
  }
  require(!mark->task.empty() && !name_of(mark->verdict).empty());
  return true;
}

namespace {

/// What is wrong with the lines of one task; nullopt: nothing.
std::optional<Error> task_error(const DatasetReader& reader, const TaskLines& lines) {
  if (auto wrong = reader.line_error(lines)) return wrong;
  const auto task = reader.task(lines);
  if (!task) return task.error();
  const auto shown = reader.demonstration(lines, Mode::M1);
  if (!shown) return shown.error();
  if (auto wrong = reader.misplaced(lines, Mode::M1, *shown, *task)) return wrong;
  const auto wordings = reader.wordings(lines);
  if (!wordings) return wordings.error();
  const auto read = reader.read(lines);
  require(read && read->record.id == task->id && read->shown.contains(Mode::M1));
  return std::nullopt;
}

}  // namespace

bool lines_body(std::string_view text) {
  static const Folder folder("lines");
  constexpr std::string_view kBetween = "====\n";
  std::filesystem::create_directories(folder.path() / "demonstrations");
  for (const std::string& name : {std::string(kTasksFile), demonstrations_file(Mode::M1), std::string(kWordingsFile)}) {
    const std::size_t end = text.find(kBetween);
    folder.write(name, text.substr(0, end));
    text = end == std::string_view::npos ? "" : text.substr(end + kBetween.size());
  }
  auto reader = DatasetReader::open(folder.path(), {{Mode::M1}, true, false}, FileNames::InFolder);
  require(static_cast<bool>(reader));
  bool sound = true;
  while (const auto lines = reader->lines().next()) {
    const auto wrong = task_error(*reader, *lines);
    if (wrong) check_error(*wrong);
    for (const StrayLine& stray : lines->strays) check_error(stray.error);
    sound = sound && !wrong && lines->strays.empty();
  }
  while (const auto stray = reader->lines().next_stray()) {
    check_error(stray->error);
    sound = false;
  }
  return sound;
}

}  // namespace unietp::fuzz
