#include "validator/recount.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.h"
#include "record/record_file.h"
#include "record/task_record.h"

namespace unietp {
namespace {

constexpr const char* kRejections = "rejections.jsonl";

std::string at_line(const char* file, int line) { return std::string(file) + ":" + std::to_string(line); }

NameCounts sum(NameCounts counts, const NameCounts& more) {
  for (const auto& [name, count] : more) counts[name] += count;
  return counts;
}

int count_of(const NameCounts& counts, const std::string& name) {
  const auto found = counts.find(name);
  return found == counts.end() ? 0 : found->second;
}

/// A problem for each name of which `recorded` and `there` have different numbers.
void compare(ProblemKind kind, const NameCounts& recorded, const NameCounts& there, const std::string& verb,
             const std::string& noun, std::vector<Problem>& problems) {
  NameCounts all = recorded;
  all.insert(there.begin(), there.end());
  for (const auto& [name, unused] : all) {
    const int wanted = count_of(recorded, name), found = count_of(there, name);
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

MeasuredSpread spread_of(const NameCounts& counts) {
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

Digest candidate_key(int slot, int attempt) {
  return {static_cast<std::uint64_t>(slot), static_cast<std::uint64_t>(attempt)};
}

RejectionCounts count_rejections(const std::filesystem::path& folder, KeyList& candidates, const TaskNames& tasks) {
  RejectionCounts counts;
  std::error_code code;
  if (!std::filesystem::exists(folder / kRejections, code)) return counts;  // the manifest lists it, or there are none
  auto file = RecordFile<RejectionRecord>::open(folder, kRejections, FileNames::InFolder, read_rejection);
  if (!file) {
    counts.problems.push_back({ProblemKind::Unreadable, "", file.error()});
    return counts;
  }
  std::vector<std::pair<int, Problem>> of_lines;
  while (const auto rejection = file->next()) {
    if (!*rejection) {
      of_lines.emplace_back(file->lines(), Problem{ProblemKind::Unreadable, "", rejection->error()});
      continue;
    }
    const RejectionRecord& record = **rejection;
    ++counts.reasons[record.stage + " " + record.reason];
    candidates.add(candidate_key(record.slot, record.attempt),
                   tasks.size() + static_cast<std::size_t>(file->lines()) - 1);
    if (record.stage != "review") continue;
    ++counts.reviewed;
    ++counts.reviewed_splits[record.split];
    ++counts.reviewed_simulators[record.simulator];
  }
  counts.lines = file->lines();
  const auto line_of = [&](std::size_t place) { return static_cast<int>(place - tasks.size()) + 1; };
  const auto name_of_place = [&](std::size_t place) {
    return place < tasks.size() ? tasks.name(place) : at_line(kRejections, line_of(place));
  };
  for (const auto& [place, first] : candidates.repeats()) {
    const std::string message = "is the same candidate as " + name_of_place(first);
    if (place < tasks.size()) {
      counts.problems.push_back(
          problem_in(ProblemKind::RepeatedTask, at_line(kTasksFile, static_cast<int>(place) + 1), message));
      counts.problems.back().task = tasks.name(place);
    } else {
      const int line = line_of(place);
      of_lines.emplace_back(line, problem_in(ProblemKind::Rejections, at_line(kRejections, line), message));
    }
  }
  std::stable_sort(of_lines.begin(), of_lines.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [line, problem] : of_lines) counts.problems.push_back(std::move(problem));
  return counts;
}

void TaskRecount::add(const TaskReading& task) {
  ++tasks_;
  all_read_ = all_read_ && task.record;
  if (!all_read_) return;
  ++splits_[task.record->split];
  ++simulators_[task.record->simulator];
  ++templates_[task.record->template_name];
  check_task(task);
}

void TaskRecount::check_task(const TaskReading& task) {
  const RecordedRun& run = manifest_.run;
  const TaskRecord& record = *task.record;
  const auto found = [&](const std::string& message) {
    quota_problems_.push_back({ProblemKind::Quota, task.name, {Error::Kind::Schema, task.where, {}, message}});
  };
  if (!is_among(run.simulators, record.simulator))
    found("has the simulator " + record.simulator + ", which is not in the configuration");
  if (!run.splits.empty() && !is_among(run.splits, record.split))
    found("has the split " + record.split + ", which is not in the configuration");
  if (is_among(run.without, record.template_name) ||
      (!run.templates.empty() && !is_among(run.templates, record.template_name)))
    found("has the template " + record.template_name + ", which is not in the configuration");
  if (record.run != run.seed)
    found("has the seed " + std::to_string(record.run) + ", but the run has " + std::to_string(run.seed));
  for (const Mode mode : run.modes) {
    if (!counts_steps(record, mode))
      found("is not demonstrated in " + std::string(name_of(mode)) + ", which the configuration requires");
  }
}

std::vector<Problem> TaskRecount::wrong_counts(const RejectionCounts& rejections) const {
  std::vector<Problem> problems;
  if (manifest_.tasks != tasks_)
    problems.push_back(problem_in(
        ProblemKind::Counts, kTasksFile,
        "has " + std::to_string(tasks_) + " tasks, but the manifest says " + std::to_string(manifest_.tasks)));
  if (all_read_) {
    compare(ProblemKind::Counts, manifest_.by_split, splits_, "counts ", "tasks of the split", problems);
    compare(ProblemKind::Counts, manifest_.by_simulator, simulators_, "counts ", "tasks on", problems);
    compare(ProblemKind::Counts, manifest_.by_template, templates_, "counts ", "tasks of the template", problems);
  }
  append(problems, rejections.problems);
  NameCounts recorded;
  for (const auto& [stage, reasons] : manifest_.rejections) {
    for (const auto& [reason, count] : reasons) recorded[stage + " " + reason] = count;
  }
  compare(ProblemKind::Counts, recorded, rejections.reasons, "counts ", "rejections by", problems);
  const int candidates = tasks_ + rejections.lines;
  if (manifest_.candidates != candidates)
    problems.push_back(problem_in(ProblemKind::Counts, kManifest,
                                  "counts " + std::to_string(manifest_.candidates) + " candidates, but there are " +
                                      std::to_string(candidates) + " tasks and rejections"));
  return problems;
}

std::vector<Problem> TaskRecount::wrong_quotas(const RejectionCounts& rejections) const {
  const RecordedRun& run = manifest_.run;
  std::vector<Problem> problems;
  // What people took out in a review was asked for and made.
  const int tasks = tasks_ + rejections.reviewed;
  if (tasks != run.count)
    problems.push_back(problem_in(
        ProblemKind::Quota, kManifest,
        "the configuration asks for " + std::to_string(run.count) + " tasks, but there are " + std::to_string(tasks)));
  append(problems, quota_problems_);
  if (!all_read_) return problems;
  if (!run.by_split.empty())
    compare(ProblemKind::Quota, run.by_split, sum(splits_, rejections.reviewed_splits), "the configuration asks for ",
            "tasks of the split", problems);
  if (!run.by_simulator.empty())
    compare(ProblemKind::Quota, run.by_simulator, sum(simulators_, rejections.reviewed_simulators),
            "the configuration asks for ", "tasks on", problems);
  return problems;
}

std::vector<Problem> check_balance(const ManifestRecord& manifest, TraitCounts counts) {
  std::vector<Problem> problems;
  const auto wrong = [&problems](const std::string& message) {
    problems.push_back(problem_in(ProblemKind::Balance, kManifest, message));
  };
  for (const RecordedSpread& recorded : manifest.balance) {
    const auto own = counts.find(recorded.dimension);
    if (own == counts.end()) {
      wrong("has a balance figure for " + recorded.dimension + ", which no task has");
      continue;
    }
    const auto there = spread_of(own->second);
    if (recorded.values != there.values || !near(recorded.effective, there.effective) ||
        !near(recorded.variation, there.variation))
      wrong("has " + std::to_string(recorded.values) + " values of " + recorded.dimension + ", effectively " +
            number_text(recorded.effective) + ", variation " + number_text(recorded.variation) + "; the tasks have " +
            std::to_string(there.values) + ", " + number_text(there.effective) + ", " + number_text(there.variation));
    counts.erase(own);
  }
  for (const auto& [dimension, unused] : counts) wrong("has no balance figure for " + dimension);
  return problems;
}

}  // namespace unietp
