#include "validator/recount.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.h"
#include "record/record_file.h"
#include "record/recorded_words.h"
#include "record/task_record.h"
#include "record/text_writer.h"

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

RejectionCounts count_rejections(const std::filesystem::path& folder, KeyList& candidates, const TaskNames& tasks,
                                 const std::function<void(const RejectionRecord&, const std::string&)>& on_line) {
  RejectionCounts counts;
  std::error_code code;
  if (!std::filesystem::exists(folder / kRejections, code)) return counts;  // the manifest lists it, or there are none
  auto file = RecordFile<RejectionRecord>::open(folder, kRejections, FileNames::InFolder, read_rejection);
  if (!file) {
    counts.problems.add({ProblemKind::Unreadable, "", file.error()});
    counts.all_read = false;
    return counts;
  }
  while (const auto rejection = file->next()) {
    if (!*rejection) {
      counts.problems.add({ProblemKind::Unreadable, "", rejection->error()});
      counts.all_read = false;
      continue;
    }
    const RejectionRecord& record = **rejection;
    on_line(record, file->at());
    ++counts.reasons[record.stage + " " + record.reason];
    candidates.add(candidate_key(record.slot, record.attempt),
                   tasks.size() + static_cast<std::size_t>(file->lines()) - 1);
    if (!record.is_by_review()) continue;
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
      auto problem = problem_in(ProblemKind::RepeatedTask, at_line(kTasksFile, static_cast<int>(place) + 1), message);
      problem.task = tasks.name(place);
      counts.problems.add(std::move(problem));
    } else {
      counts.problems.add(problem_in(ProblemKind::Rejections, at_line(kRejections, line_of(place)), message));
    }
  }
  return counts;
}

void TaskRecount::add(const TaskReading& task) {
  ++tasks_;
  all_read_ = all_read_ && task.record;
  if (!all_read_) return;
  ++splits_[task.record->split];
  ++simulators_[task.record->simulator];
  ++templates_[task.record->template_name];
  ++grades_[task.record->grade];
  for (const std::string& form : task.record->forms) ++forms_[form];
  if (recorded_grade(task.record->grade) != RecordedGrade::Usual) ++not_usual_[task.record->template_name];
  ++writers_[task.record->writer];
  check_task(task);
}

void TaskRecount::check_task(const TaskReading& task) {
  const RecordedRun& run = manifest_.run;
  const TaskRecord& record = *task.record;
  const auto found = [&](const std::string& message) {
    quota_problems_.add({ProblemKind::Quota, task.name, {Error::Kind::Schema, task.where, {}, message}});
  };
  if (!is_among(run.simulators, record.simulator))
    found("has the simulator " + record.simulator + ", which is not in the configuration");
  if (run.by_simulator.empty() && !run.simulators.empty() && record.slot >= 0) {
    const auto& turn = run.simulators[static_cast<std::size_t>(record.slot) % run.simulators.size()];
    if (record.simulator != turn)
      found("has the simulator " + record.simulator +
            ", but the simulators of the configuration take turns, and it is " + turn + "'s");
  }
  if (!run.splits.empty() && !is_among(run.splits, record.split))
    found("has the split " + record.split + ", which is not in the configuration");
  if (is_among(run.without, record.template_name) ||
      (!run.templates.empty() && !is_among(run.templates, record.template_name)))
    found("has the template " + record.template_name + ", which is not in the configuration");
  if (recorded_grade(record.grade) == RecordedGrade::Senseless && least_grade(run.sense) != RecordedGrade::Senseless)
    found("is senseless, but the configuration asks for tasks that are " + run.sense);
  if (record.run != run.seed)
    found("has the seed " + std::to_string(record.run) + ", but the run has " + std::to_string(run.seed));
  for (const Mode mode : run.modes) {
    if (!counts_steps(record, mode))
      found("is not demonstrated in " + std::string(name_of(mode)) + ", which the configuration requires");
  }
  for (const auto& count : record.expert) {
    if (std::find(run.modes.begin(), run.modes.end(), count.mode) == run.modes.end())
      found("is demonstrated in " + std::string(name_of(count.mode)) + ", which is not in the configuration");
  }
  for (const auto& wanted : run.binding) {
    if (std::none_of(record.bindings.begin(), record.bindings.end(),
                     [&](const auto& bound) { return bound.first + "=" + bound.second == wanted; }))
      found("does not bind " + wanted + ", which the configuration requires");
  }
}

ProblemList TaskRecount::wrong_counts(const RejectionCounts& rejections) const {
  std::vector<Problem> problems;
  if (manifest_.tasks != tasks_)
    problems.push_back(problem_in(
        ProblemKind::Counts, kTasksFile,
        "has " + std::to_string(tasks_) + " tasks, but the manifest says " + std::to_string(manifest_.tasks)));
  if (all_read_) {
    compare(ProblemKind::Counts, manifest_.by_split, splits_, "counts ", "tasks of the split", problems);
    compare(ProblemKind::Counts, manifest_.by_simulator, simulators_, "counts ", "tasks on", problems);
    compare(ProblemKind::Counts, manifest_.by_template, templates_, "counts ", "tasks of the template", problems);
    compare(ProblemKind::Counts, manifest_.by_sense, grades_, "counts ", "tasks of the grade", problems);
    compare(ProblemKind::Counts, manifest_.by_form, forms_, "counts ", "tasks in the form", problems);
    compare(ProblemKind::Counts, manifest_.not_usual, not_usual_, "counts ",
            "tasks that are not usual, of the template", problems);
  }
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
  ProblemList all;
  all.add(rejections.problems);
  all.add(std::move(problems));
  return all;
}

std::vector<Problem> TaskRecount::wrong_writers(int edited) const {
  std::vector<Problem> problems;
  const auto found = [&problems](const std::string& message) {
    problems.push_back(problem_in(ProblemKind::Counts, kManifest, message));
  };
  const auto by_person = [](const std::string& name) {
    const auto writer = text_writer_of(name);
    return writer == TextWriter::Person || writer == TextWriter::UncheckedPerson;
  };
  const auto by_grammar = [](const std::string& name) { return text_writer_of(name) == TextWriter::Grammar; };
  NameCounts written;
  for (const auto& [writer, count] : writers_) {
    if (!by_person(writer)) written[writer] = count;
  }
  if (!manifest_.writing) {
    for (const auto& [writer, count] : written) {
      if (!by_grammar(writer))
        found("does not say that instructions were rewritten, but " + std::to_string(count) + " are by " + writer);
    }
    return problems;
  }
  int missing = 0;
  std::string last;
  for (const auto& [writer, count] : manifest_.writing->counts) {
    if (writer <= last) found("does not list the writers in order");
    last = writer;
    const int there = count_of(written, writer);
    if (count < there || count > there + edited)
      found("counts " + std::to_string(count) + " instructions by " + writer + ", there are " + std::to_string(there));
    missing += count - there;
    written.erase(writer);
  }
  for (const auto& [writer, count] : written)
    found("does not list the writer " + writer + " of " + std::to_string(count) + " instructions");
  if (missing > edited) found("counts more instructions than there are tasks");
  const auto& counts = manifest_.writing->counts;
  const bool by_model =
      std::any_of(counts.begin(), counts.end(), [&](const auto& one) { return !by_grammar(one.first); });
  if (by_model && by_grammar(manifest_.writing->writer))
    found("says that the grammar wrote the instructions, unlike its counts");
  return problems;
}

ProblemList TaskRecount::wrong_quotas(const RejectionCounts& rejections) const {
  const RecordedRun& run = manifest_.run;
  std::vector<Problem> problems;
  // What people took out in a review was asked for and made.
  const int tasks = tasks_ + rejections.reviewed;
  if (tasks != run.count)
    problems.push_back(problem_in(
        ProblemKind::Quota, kManifest,
        "the configuration asks for " + std::to_string(run.count) + " tasks, but there are " + std::to_string(tasks)));
  const auto with_those_of_tasks = [&] {
    ProblemList all;
    all.add(std::move(problems));
    all.add(quota_problems_);
    return all;
  };
  if (!all_read_) return with_those_of_tasks();
  if (!run.by_split.empty())
    compare(ProblemKind::Quota, run.by_split, sum(splits_, rejections.reviewed_splits), "the configuration asks for ",
            "tasks of the split", problems);
  if (!run.by_simulator.empty())
    compare(ProblemKind::Quota, run.by_simulator, sum(simulators_, rejections.reviewed_simulators),
            "the configuration asks for ", "tasks on", problems);
  return with_those_of_tasks();
}

std::vector<Problem> check_balance(const ManifestRecord& manifest, TraitCounts counts) {
  std::vector<Problem> problems;
  const auto wrong = [&problems](const std::string& message) {
    problems.push_back(problem_in(ProblemKind::Balance, kManifest, message));
  };
  std::ptrdiff_t last = -1;
  for (const RecordedSpread& recorded : manifest.balance) {
    const auto place = std::find(kDimensions.begin(), kDimensions.end(), recorded.dimension) - kDimensions.begin();
    if (place <= last) wrong("has the balance figure for " + recorded.dimension + " out of order");
    last = place;
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
