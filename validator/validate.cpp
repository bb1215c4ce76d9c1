#include "validator/validate.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "core/files.h"
#include "core/ordered_work.h"
#include "core/share_work.h"
#include "record/dataset_reader.h"
#include "record/manifest_record.h"
#include "validator/database_check.h"
#include "validator/file_check.h"
#include "validator/prove.h"
#include "validator/recount.h"
#include "validator/repeats.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

std::optional<ManifestRecord> manifest_in(const fs::path& folder, std::string_view knowledge_digest,
                                          std::vector<Problem>& problems) {
  const auto text = read_file(folder, kManifest);
  auto manifest = text ? read_manifest(kManifest, *text) : Result<ManifestRecord>(text.error());
  if (!manifest) {
    problems.push_back({ProblemKind::Manifest, "", manifest.error()});
    return std::nullopt;
  }
  if (manifest->knowledge_digest != knowledge_digest)
    problems.push_back(problem_in(ProblemKind::OtherKnowledge, kManifest,
                                  "was made with different tables, profiles, layouts or templates (digest " +
                                      manifest->knowledge_digest.substr(0, 12) + ") than the current ones (digest " +
                                      std::string(knowledge_digest.substr(0, 12)) +
                                      "); use --data to select the right ones"));
  return std::move(*manifest);
}

std::vector<Problem> check_files(const FileCheck& files, int threads) {
  std::vector<std::vector<Problem>> found(files.files().size());
  share_work(threads, found.size(), [&](std::size_t i) { found[i] = files.of(files.files()[i]); });
  std::vector<Problem> problems;
  for (auto& own : found) append(problems, std::move(own));
  return problems;
}

/// What is gathered of all tasks, in a few hundred bytes each: what is wrong with them taken together.
class WholeSet {
 public:
  WholeSet(const fs::path& folder, const ManifestRecord& manifest, const ValidationOptions& options)
      : folder_(folder), manifest_(manifest), recount_(manifest), database_(folder) {
    for (const auto& other : options.against) {
      auto print = print_of(other, options.threads);
      if (print) {
        leaks_.emplace_back(LeakSearch(std::move(*print)));
      } else {
        leaks_.emplace_back(print.error());
      }
    }
  }

  /// What is most alike to a task whose record reads, in each of the other sets that read. Thread-safe.
  std::vector<std::optional<Nearest>> nearest(const TaskReading& task, const Scene& home) const {
    std::vector<std::optional<Nearest>> found;
    for (const auto& search : leaks_) found.push_back(search ? search->nearest(task, home) : std::nullopt);
    return found;
  }

  /// `nearest`: of each of the other sets, or none when the home does not read.
  void add(std::size_t place, const TaskReading& task, const TaskFacts& facts,
           const std::vector<std::optional<Nearest>>& nearest) {
    recount_.add(task);
    if (task.record) candidates_.add(candidate_key(task.record->slot, task.record->attempt), place);
    if (recount_.all_read()) database_.add(task, facts);
    repeats_.add(place, facts);
    for (std::size_t i = 0; i < leaks_.size(); ++i) {
      if (leaks_[i]) leaks_[i]->add(task, facts, nearest.empty() ? std::nullopt : nearest[i]);
    }
  }

  std::vector<LikenessReport> likeness() const {
    std::vector<LikenessReport> reports;
    for (const auto& search : leaks_) {
      if (search) reports.push_back(search->likeness());
    }
    return reports;
  }

  std::vector<Problem> problems(const TaskNames& names) {
    const auto rejections = count_rejections(folder_, candidates_, names);
    auto problems = recount_.wrong_counts(rejections);
    append(problems, recount_.wrong_quotas(rejections));
    if (recount_.all_read()) {
      append(problems, database_.finish(rejections.lines));
      append(problems, check_balance(manifest_, database_.traits()));
    }
    append(problems, repeats_.problems(names));
    for (const auto& search : leaks_) {
      if (search) append(problems, search->problems(manifest_.run.seed));
      if (!search) problems.push_back({ProblemKind::Unreadable, "", search.error()});
    }
    return problems;
  }

 private:
  const fs::path& folder_;
  const ManifestRecord& manifest_;
  TaskRecount recount_;
  KeyList candidates_;
  DatabaseCheck database_;
  RepeatSearch repeats_;
  std::vector<Result<LeakSearch>> leaks_;
};

/// What one task showed.
struct TaskVerdict {
  TaskReading reading;
  TaskProof proof;
  std::vector<std::optional<Nearest>> nearest;
};

/// What all tasks showed, in the order of tasks.jsonl.
struct SetVerdict {
  TaskNames names;
  std::vector<std::uint8_t> simulators;  // of each task; kSimulators.size() where it is not known
  std::vector<Problem> reading, wordings, proofs;
  bool lacks_wordings = false;                               // of some task; the first is named
  ProofCounts counts;                                        // without those that are proven
  std::array<ProofCounts, kSimulators.size()> by_simulator;  // likewise
};

/// Problems of the data set as a whole first, then task by task; within each as they were found.
void sort_by_task(std::vector<Problem>& problems, TaskNames& names) {
  std::map<std::string, std::size_t> place;  // of the tasks that problems name; 0: none
  for (const Problem& problem : problems) {
    if (problem.task.empty() || place.contains(problem.task)) continue;
    const auto places = names.places(problem.task);
    place[problem.task] = places.empty() ? 0 : places.front() + 1;
  }
  const auto of = [&](const Problem& problem) { return problem.task.empty() ? 0 : place.at(problem.task); };
  std::stable_sort(problems.begin(), problems.end(), [&](const Problem& a, const Problem& b) { return of(a) < of(b); });
}

void add(ProofCounts& to, const ProofCounts& other) {
  to.tasks += other.tasks;
  to.proven += other.proven;
  to.demonstrations += other.demonstrations;
  to.steps += other.steps;
  to.spoilt_plans += other.spoilt_plans;
  to.texts += other.texts;
}

void take(TaskVerdict&& task, SetVerdict& set) {
  set.names.add(task.reading.name);
  append(set.reading, std::move(task.reading.problems));
  append(set.wordings, std::move(task.reading.wordings_problems));
  if (task.reading.missing_wordings && !set.lacks_wordings)
    set.wordings.push_back({ProblemKind::Wordings, "", *task.reading.missing_wordings});
  set.lacks_wordings = set.lacks_wordings || task.reading.missing_wordings;
  append(set.proofs, std::move(task.proof.problems));
  task.proof.counts.tasks = 1;
  add(set.counts, task.proof.counts);
  const auto simulator =
      task.reading.record ? simulator_named(task.reading.record->simulator) : std::optional<Simulator>();
  const auto index = simulator ? static_cast<std::size_t>(*simulator) : kSimulators.size();
  set.simulators.push_back(static_cast<std::uint8_t>(index));
  if (simulator) add(set.by_simulator[index], task.proof.counts);
}

void take_left_over_lines(DatasetLines& lines, SetVerdict& set) {
  while (const auto stray = lines.next_stray())
    (stray->mode ? set.reading : set.wordings).push_back(stray_problem(*stray));
}

/// Tasks of which nothing is wrong count as proven.
void count_proven(const std::vector<Problem>& problems, SetVerdict& set) {
  std::vector<bool> wrong(set.names.size());
  std::set<std::string_view> done;
  for (const Problem& problem : problems) {
    if (problem.task.empty() || !done.insert(problem.task).second) continue;
    for (const std::size_t place : set.names.places(problem.task)) wrong[place] = true;
  }
  for (std::size_t place = 0; place < wrong.size(); ++place) {
    if (wrong[place]) continue;
    ++set.counts.proven;
    if (set.simulators[place] < kSimulators.size()) ++set.by_simulator[set.simulators[place]].proven;
  }
}

}  // namespace

ValidationReport validate_dataset(const fs::path& folder, const std::vector<ValidationBackend>& backends,
                                  std::string_view knowledge_digest, const ValidationOptions& options) {
  ValidationReport report;
  auto& problems = report.problems;
  const auto stop_with = [&](Error error) {
    problems.push_back({ProblemKind::Unreadable, "", std::move(error)});
    return report;
  };
  std::error_code code;
  if (!fs::is_directory(folder, code))
    return stop_with({Error::Kind::Io, folder.string(), {}, "is not a folder; expected a finished data set"});
  const auto manifest = manifest_in(folder, knowledge_digest, problems);
  auto reader =
      DatasetReader::open(folder, {shown_modes(folder), fs::exists(folder / kWordingsFile, code)}, FileNames::InFolder);
  if (!reader) return stop_with(reader.error());

  RestCheck rest(options.rest_m);
  const ProofTools tools{*reader, backends, options, rest, manifest ? manifest->phrasings : "all"};
  std::optional<WholeSet> whole;
  if (manifest) whole.emplace(folder, *manifest, options);
  SetVerdict set;
  (void)work_in_order<TaskLines, TaskVerdict>(
      options.threads, [&] { return reader->lines().next(); },
      [&](const TaskLines& lines) {
        TaskVerdict task{read_task_lines(*reader, lines), {}, {}};
        if (!task.reading.record) return task;
        task.proof = prove_task(task.reading, lines, tools);
        if (const auto home = reader->homes().home(task.reading.record->layout); home && whole)
          task.nearest = whole->nearest(task.reading, **home);
        return task;
      },
      [&](TaskVerdict&& task) -> Result<Done> {
        if (whole) whole->add(set.names.size(), task.reading, task.proof.facts, task.nearest);
        take(std::move(task), set);
        return Done{};
      });
  take_left_over_lines(reader->lines(), set);

  append(problems, std::move(set.reading));
  for (const auto& [place, first] : set.names.repeats()) {
    problems.push_back(problem_in(ProblemKind::RepeatedTask, reader->lines().task_at(static_cast<int>(place) + 1),
                                  "an earlier task has the same id"));
    problems.back().task = set.names.name(place);
  }
  if (manifest) {
    const FileCheck files(folder, *manifest);
    append(problems, files.listing());
    append(problems, check_files(files, options.threads));
  }
  append(problems, std::move(set.wordings));
  append(problems, std::move(set.proofs));
  if (whole) append(problems, whole->problems(set.names));
  sort_by_task(problems, set.names);
  count_proven(problems, set);
  if (whole) report.likeness = whole->likeness();
  report.counts = set.counts;
  report.by_simulator = set.by_simulator;
  if (manifest) report.counts.tasks = std::max(report.counts.tasks, manifest->tasks);
  return report;
}

}  // namespace unietp
