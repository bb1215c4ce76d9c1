#include "validator/recount.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"
#include "record/manifest_record.h"
#include "record/record_fields.h"

namespace unietp {
namespace {

using Counts = std::map<std::string, int>;

int count_of(const Counts& counts, const std::string& name) {
  const auto found = counts.find(name);
  return found == counts.end() ? 0 : found->second;
}

/// A problem for each name of which `told` and `there` have different numbers.
void compare(ProblemKind kind, const Counts& told, const Counts& there, const std::string& verb,
             const std::string& noun, std::vector<Problem>& problems) {
  Counts all = told;
  all.insert(there.begin(), there.end());
  for (const auto& [name, unused] : all) {
    const int wanted = count_of(told, name), found = count_of(there, name);
    if (wanted != found)
      problems.push_back(
          problem_in(kind, kManifest,
                     verb + std::to_string(wanted) + " " + noun + " " + name + ", there are " + std::to_string(found)));
  }
}

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct MeasuredSpread {
  int values = 0;
  double effective = 0, variation = 0;
};

MeasuredSpread spread_of(const Counts& counts) {
  double sum = 0, squares = 0;
  for (const auto& [value, count] : counts) {
    sum += count;
    squares += static_cast<double>(count) * count;
  }
  const auto values = static_cast<double>(counts.size());
  const double mean = sum / values;
  return {static_cast<int>(counts.size()), sum * sum / squares,
          std::sqrt(std::max(0.0, squares / values - mean * mean)) / mean};
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)}); }

}  // namespace

std::vector<Problem> recount_tasks(const ManifestRecord& manifest, const FolderReading& set) {
  std::vector<Problem> problems;
  const auto tasks = static_cast<int>(set.tasks.size());
  if (manifest.tasks != tasks)
    problems.push_back(
        problem_in(ProblemKind::Counts, set.task_lines.name(),
                   "has " + std::to_string(tasks) + " tasks, but the manifest says " + std::to_string(manifest.tasks)));
  Counts splits, simulators, templates;
  for (const TaskReading& task : set.tasks) {
    if (!task.record) return problems;  // what it is of is not known
    ++splits[task.record->split];
    ++simulators[task.record->simulator];
    ++templates[task.record->template_name];
  }
  compare(ProblemKind::Counts, manifest.by_split, splits, "counts ", "tasks of the split", problems);
  compare(ProblemKind::Counts, manifest.by_simulator, simulators, "counts ", "tasks on", problems);
  compare(ProblemKind::Counts, manifest.by_template, templates, "counts ", "tasks of the template", problems);
  return problems;
}

std::vector<Problem> recount_rejections(const ManifestRecord& manifest, const FolderReading& set) {
  std::vector<Problem> problems;
  const auto lines = LineFile::read(set.folder, "rejections.jsonl");
  if (!lines) return {{ProblemKind::Unreadable, "", lines.error()}};
  std::map<std::pair<int, int>, std::string> taken;  // by slot and attempt
  for (const TaskReading& task : set.tasks) {
    if (!task.record) continue;
    const auto [other, is_new] = taken.try_emplace({task.record->slot, task.record->attempt}, task.name);
    if (!is_new)
      problems.push_back({ProblemKind::RepeatedTask,
                          task.name,
                          {Error::Kind::Schema, task.where, {}, "is the same candidate as " + other->second}});
  }
  Counts reasons;
  for (std::size_t i = 0; i < lines->size(); ++i) {
    const auto rejection = read_rejection(lines->name(), static_cast<int>(i) + 1, lines->line(i));
    if (!rejection) {
      problems.push_back({ProblemKind::Unreadable, "", rejection.error()});
      continue;
    }
    ++reasons[rejection->stage + " " + rejection->reason];
    const auto [other, is_new] = taken.try_emplace({rejection->slot, rejection->attempt}, lines->at(i));
    if (!is_new)
      problems.push_back(
          problem_in(ProblemKind::Rejections, lines->at(i), "is the same candidate as " + other->second));
  }
  compare(ProblemKind::Counts, manifest.rejections, reasons, "counts ", "rejections by", problems);
  const auto candidates = static_cast<int>(set.tasks.size() + lines->size());
  if (manifest.candidates != candidates)
    problems.push_back(problem_in(ProblemKind::Counts, kManifest,
                                  "counts " + std::to_string(manifest.candidates) + " candidates, but there are " +
                                      std::to_string(candidates) + " tasks and rejections"));
  return problems;
}

std::vector<Problem> check_quotas(const RecordedRun& run, const FolderReading& set) {
  std::vector<Problem> problems;
  // What people took out in a review was asked for and made.
  Counts splits, simulators;
  auto tasks = static_cast<int>(set.tasks.size());
  if (const auto lines = LineFile::read(set.folder, "rejections.jsonl")) {
    for (std::size_t i = 0; i < lines->size(); ++i) {
      const auto rejection = read_rejection(lines->name(), static_cast<int>(i) + 1, lines->line(i));
      if (!rejection || rejection->stage != "review") continue;
      ++tasks;
      ++splits[rejection->split];
      ++simulators[rejection->simulator];
    }
  }
  const auto found = [&problems](const TaskReading& task, const std::string& message) {
    problems.push_back({ProblemKind::Quota, task.name, {Error::Kind::Schema, task.where, {}, message}});
  };
  if (tasks != run.count)
    problems.push_back(problem_in(
        ProblemKind::Quota, kManifest,
        "the configuration asks for " + std::to_string(run.count) + " tasks, but there are " + std::to_string(tasks)));
  for (const TaskReading& task : set.tasks) {
    if (!task.record) return problems;
    const TaskRecord& record = *task.record;
    ++splits[record.split];
    ++simulators[record.simulator];
    if (!is_among(run.simulators, record.simulator))
      found(task, "has the simulator " + record.simulator + ", which is not in the configuration");
    if (!run.splits.empty() && !is_among(run.splits, record.split))
      found(task, "has the split " + record.split + ", which is not in the configuration");
    if (is_among(run.without, record.template_name) ||
        (!run.templates.empty() && !is_among(run.templates, record.template_name)))
      found(task, "has the template " + record.template_name + ", which is not in the configuration");
    if (record.run != run.seed)
      found(task, "has the seed " + std::to_string(record.run) + ", but the run has " + std::to_string(run.seed));
    for (const Mode mode : run.modes) {
      if (std::none_of(record.expert.begin(), record.expert.end(),
                       [mode](const auto& count) { return count.mode == mode; }))
        found(task, "is not demonstrated in " + std::string(name_of(mode)) + ", which the configuration requires");
    }
  }
  if (!run.by_split.empty())
    compare(ProblemKind::Quota, run.by_split, splits, "the configuration asks for ", "tasks of the split", problems);
  if (!run.by_simulator.empty())
    compare(ProblemKind::Quota, run.by_simulator, simulators, "the configuration asks for ", "tasks on", problems);
  return problems;
}

std::vector<Problem> check_balance(const ManifestRecord& manifest, ValueCounts counts) {
  std::vector<Problem> problems;
  const auto wrong = [&problems](const std::string& message) {
    problems.push_back(problem_in(ProblemKind::Balance, kManifest, message));
  };
  for (const RecordedSpread& told : manifest.balance) {
    const auto own = counts.find(told.dimension);
    if (own == counts.end()) {
      wrong("has a balance figure for " + told.dimension + ", which no task has");
      continue;
    }
    const auto there = spread_of(own->second);
    if (told.values != there.values || !near(told.effective, there.effective) || !near(told.variation, there.variation))
      wrong("has " + std::to_string(told.values) + " values of " + told.dimension + ", effectively " +
            number_text(told.effective) + ", variation " + number_text(told.variation) + "; the tasks have " +
            std::to_string(there.values) + ", " + number_text(there.effective) + ", " + number_text(there.variation));
    counts.erase(own);
  }
  for (const auto& [dimension, unused] : counts) wrong("has no balance figure for " + dimension);
  return problems;
}

}  // namespace unietp
