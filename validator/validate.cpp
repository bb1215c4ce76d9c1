#include "validator/validate.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "core/files.h"
#include "core/ordered_work.h"
#include "core/share_work.h"
#include "core/version.h"
#include "record/dataset_reader.h"
#include "record/manifest_record.h"
#include "validator/candidate_check.h"
#include "validator/database_check.h"
#include "validator/derived_files.h"
#include "validator/file_check.h"
#include "validator/home_check.h"
#include "validator/proof_memory.h"
#include "validator/prove.h"
#include "validator/recount.h"
#include "validator/repeats.h"
#include "validator/review_check.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

std::optional<ManifestRecord> manifest_in(const fs::path& folder, std::string_view knowledge_digest,
                                          ProblemList& problems) {
  const auto text = read_file(folder, kManifest);
  auto manifest = text ? read_manifest(kManifest, *text) : Result<ManifestRecord>(text.error());
  if (!manifest) {
    problems.add({ProblemKind::Manifest, "", manifest.error()});
    return std::nullopt;
  }
  if (manifest->knowledge_digest != knowledge_digest)
    problems.add(problem_in(ProblemKind::OtherKnowledge, kManifest,
                            "was made with different tables, profiles, layouts or templates (digest " +
                                manifest->knowledge_digest.substr(0, 12) + ") than the current ones (digest " +
                                std::string(knowledge_digest.substr(0, 12)) +
                                "); use --data to select the right ones"));
  if (manifest->program_version != program_version())
    problems.add(problem_in(ProblemKind::OtherVersion, kManifest,
                            "was made by version " + manifest->program_version + ", and this is version " +
                                std::string(program_version()) + "; verify it with the version that made it"));
  return std::move(*manifest);
}

ProblemList check_files(const FileCheck& files, int threads) {
  std::vector<std::vector<Problem>> found(files.files().size());
  share_work(threads, found.size(), [&](std::size_t i) { found[i] = files.of(files.files()[i]); });
  ProblemList problems;
  problems.add(files.listing());
  for (auto& own : found) problems.add(std::move(own));
  return problems;
}

/// What is gathered of all tasks, in a few hundred bytes each: what is wrong with them taken together.
class WholeSet {
 public:
  WholeSet(const fs::path& folder, const ManifestRecord& manifest, const ValidationOptions& options)
      : folder_(folder),
        manifest_(manifest),
        options_(options),
        recount_(manifest),
        candidates_(manifest),
        database_(folder),
        reviews_(folder, manifest) {
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
    if (task.record) {
      candidate_keys_.add(candidate_key(task.record->slot, task.record->attempt), place);
      candidates_.add(*task.record, task.name, task.where);
      reviews_.add(*task.record);
    }
    if (recount_.all_read()) database_.add(task, facts);
    if (task.record) placed_.push_back({place, task.record->slot, &*homes_.insert(task.record->layout).first});
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

  ProblemList problems(TaskNames& names) {
    const bool tasks_read = recount_.all_read();
    const auto rejections = count_rejections(folder_, candidate_keys_, names,
                                             [&](const RejectionRecord& rejection, const std::string& where) {
                                               candidates_.add(rejection, where);
                                               reviews_.add(rejection);
                                               if (tasks_read) database_.add(rejection);
                                             });
    ProblemList problems = recount_.wrong_counts(rejections);
    problems.add(recount_.wrong_quotas(rejections));
    if (tasks_read) {
      problems.add(recount_.wrong_writers(reviews_.edited()));
      problems.add(database_.finish());
      problems.add(check_balance(manifest_, database_.traits()));
    }
    problems.add(candidates_.finish(tasks_read && rejections.all_read));
    problems.add(reviews_.finish(names));
    std::error_code code;
    const bool has_pairs = manifest_.writing && manifest_.writing->pairs;
    if (fs::exists(folder_ / kWordingsFile, code) != has_pairs)
      problems.add(problem_in(ProblemKind::Wordings, kManifest,
                              has_pairs ? "says how wordings.jsonl was written, which is not there"
                                        : "does not say how wordings.jsonl was written"));
    problems.add(check_derived_files(folder_, manifest_, options_.derive_files));
    if (tasks_read) problems.add(check_homes(folder_, manifest_, {homes_.begin(), homes_.end()}, options_));
    problems.add(wrong_homes(names, rejections.lines));
    problems.add(repeats_.problems(names));
    for (const auto& search : leaks_) {
      if (search) problems.add(search->problems(manifest_.run.seed));
      if (!search) problems.add({ProblemKind::Unreadable, "", search.error()});
    }
    return problems;
  }

 private:
  /// Tasks in homes in which the run does not fill their slots. `rejections`: how many lines there are. A run of more
  /// slots than there are candidates is a problem of its own, and may be too long to be planned again.
  ProblemList wrong_homes(const TaskNames& names, int rejections) const {
    ProblemList problems;
    const auto candidates = static_cast<std::int64_t>(placed_.size()) + rejections;
    if (!options_.home_in_run || manifest_.run.count > candidates) return problems;
    for (const Placed& task : placed_) {
      auto fault = options_.home_in_run(task.slot, *task.home, manifest_);
      if (fault.empty()) continue;
      auto problem = problem_in(ProblemKind::HomeFile, kTasksFile, std::move(fault));
      problem.task = names.name(task.place);
      problems.add(std::move(problem));
    }
    return problems;
  }

  const fs::path& folder_;
  const ManifestRecord& manifest_;
  const ValidationOptions& options_;
  TaskRecount recount_;
  std::set<std::string> homes_;  // of the tasks
  struct Placed {
    std::size_t place = 0;
    int slot = 0;
    const std::string* home = nullptr;  // of homes_
  };
  std::vector<Placed> placed_;
  KeyList candidate_keys_;
  CandidateCheck candidates_;
  DatabaseCheck database_;
  ReviewCheck reviews_;
  RepeatSearch repeats_;
  std::vector<Result<LeakSearch>> leaks_;
};

/// The part of the tasks that is proven.
class OwnTasks {
 public:
  /// `tasks`: as many as the manifest says; 0: not known, then all are of the first part.
  OwnTasks(const ValidationOptions& options, int tasks) : part_(options.part), parts_(options.parts), tasks_(tasks) {}

  bool has(const TaskLines& lines) const {
    const std::int64_t before = lines.task.number - 1;
    const std::int64_t part = tasks_ == 0 ? 0 : std::min<std::int64_t>(before * parts_ / tasks_, parts_ - 1);
    return part == part_ - 1;
  }
  bool are_all() const { return parts_ == 1; }
  bool have_the_whole_set() const { return part_ == 1; }  // what is of the whole set is checked with them

 private:
  int part_, parts_, tasks_;
};

/// What one task showed.
struct TaskVerdict {
  bool own = true;  // of the part that is proven; of others there are facts, and only with the whole set
  TaskReading reading;
  TaskProof proof;
  std::vector<std::optional<Nearest>> nearest;
};

/// Proves a task, or takes its proof from the memory of an earlier call.
TaskProof proof_of(const TaskReading& task, const TaskLines& lines, const ProofTools& tools) {
  ProofMemory* memory = tools.options.memory;
  const auto home = tools.manifest == nullptr ? std::map<std::string, RecordedFile>::const_iterator()
                                              : tools.manifest->files.find(home_file(task.record->layout));
  if (memory == nullptr || tools.manifest == nullptr || home == tools.manifest->files.end())
    return prove_task(task, lines, tools);
  const auto former = tools.former.find(task.record->id);
  const auto key = ProofMemory::key_of(lines, home->second.sha256, *tools.manifest,
                                       former == tools.former.end() ? "" : former->second);
  if (const auto known = memory->find(key)) return *known;
  auto proof = prove_task(task, lines, tools);
  memory->keep(key, proof);
  return proof;
}

/// What all tasks showed, in the order of tasks.jsonl.
struct SetVerdict {
  TaskNames names;
  std::vector<std::uint8_t> simulators;  // of each task; kSimulators.size() where it is not known
  std::vector<bool> own;                 // of each task
  std::vector<bool> unchecked;           // of each task: whether its text failed the checks
  ProblemList reading, wordings, proofs;
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
  to.altered_plans += other.altered_plans;
  to.constrained += other.constrained;
  to.tempting += other.tempting;
  to.texts += other.texts;
  to.unchecked += other.unchecked;
}

void take(TaskVerdict&& task, SetVerdict& set) {
  set.names.add(task.reading.name);
  set.own.push_back(task.own);
  set.unchecked.push_back(task.own && task.proof.counts.unchecked > 0);
  const auto simulator =
      task.reading.record ? simulator_named(task.reading.record->simulator) : std::optional<Simulator>();
  const auto index = simulator ? static_cast<std::size_t>(*simulator) : kSimulators.size();
  set.simulators.push_back(static_cast<std::uint8_t>(index));
  if (!task.own) return;  // its own part tells what is wrong with it
  set.reading.add(std::move(task.reading.problems));
  set.wordings.add(std::move(task.reading.wordings_problems));
  if (task.reading.missing_wordings && !set.lacks_wordings)
    set.wordings.add({ProblemKind::Wordings, "", *task.reading.missing_wordings});
  set.lacks_wordings = set.lacks_wordings || task.reading.missing_wordings;
  set.proofs.add(std::move(task.proof.problems));
  task.proof.counts.tasks = 1;
  add(set.counts, task.proof.counts);
  if (simulator) add(set.by_simulator[index], task.proof.counts);
}

void take_left_over_lines(DatasetLines& lines, SetVerdict& set) {
  while (const auto stray = lines.next_stray()) (stray->mode ? set.reading : set.wordings).add(stray_problem(*stray));
}

/// Tasks of which nothing is wrong count as proven, unless their text failed the checks and was accepted.
void count_proven(const ProblemList& problems, SetVerdict& set) {
  for (std::size_t place = 0; place < set.names.size(); ++place) {
    if (!set.own[place] || set.unchecked[place] || problems.blames(set.names.name(place))) continue;
    ++set.counts.proven;
    if (set.simulators[place] < kSimulators.size()) ++set.by_simulator[set.simulators[place]].proven;
  }
}

}  // namespace

ValidationReport validate_dataset(const fs::path& folder, const std::vector<ValidationBackend>& backends,
                                  std::string_view knowledge_digest, const ValidationOptions& options) {
  ValidationReport report;
  ProblemList problems;
  const auto reported = [&] {
    for (const auto& about : all_problems())
      report.found[static_cast<std::size_t>(about.kind)] = problems.count(about.kind);
    report.problems = problems.take();
    return report;
  };
  const auto stop_with = [&](Error error) {
    problems.add({ProblemKind::Unreadable, "", std::move(error)});
    return reported();
  };
  std::error_code code;
  if (!fs::is_directory(folder, code))
    return stop_with({Error::Kind::Io, folder.string(), {}, "is not a folder; expected a finished data set"});
  const auto manifest = manifest_in(folder, knowledge_digest, problems);
  auto reader =
      DatasetReader::open(folder, {shown_modes(folder), fs::exists(folder / kWordingsFile, code)}, FileNames::InFolder);
  if (!reader) return stop_with(reader.error());

  RestCheck rest(options.rest_m);
  const auto former = former_texts(folder);
  const ProofTools tools{*reader, backends, options, rest, manifest ? &*manifest : nullptr, former};
  const OwnTasks own(options, manifest ? manifest->tasks : 0);
  std::optional<WholeSet> whole;
  if (manifest && own.have_the_whole_set()) whole.emplace(folder, *manifest, options);
  SetVerdict set;
  (void)work_in_order<TaskLines, TaskVerdict>(
      options.threads, [&] { return reader->lines().next(); },
      [&](const TaskLines& lines) {
        const bool is_own = own.has(lines);
        if (!is_own && !whole) return TaskVerdict{is_own, {}, {}, {}};
        TaskVerdict task{is_own, read_task_lines(*reader, lines), {}, {}};
        if (!task.reading.record) return task;
        if (is_own) {
          task.proof = proof_of(task.reading, lines, tools);
        } else {
          task.proof.facts = read_task_facts(task.reading, lines, tools);
        }
        if (const auto home = reader->homes().home(task.reading.record->layout); home && whole)
          task.nearest = whole->nearest(task.reading, **home);
        return task;
      },
      [&](TaskVerdict&& task) -> Result<Done> {
        if (!task.own && !whole) return Done{};
        if (whole) whole->add(set.names.size(), task.reading, task.proof.facts, task.nearest);
        for (const TriedPlan& plan : task.proof.plans) options.take_plan(task.reading.name, plan);
        take(std::move(task), set);
        return Done{};
      });
  if (own.have_the_whole_set()) take_left_over_lines(reader->lines(), set);

  problems.add(std::move(set.reading));
  for (const auto& [place, first] : set.names.repeats()) {
    if (!own.have_the_whole_set()) break;
    auto problem = problem_in(ProblemKind::RepeatedTask, reader->lines().task_at(static_cast<int>(place) + 1),
                              "an earlier task has the same id");
    problem.task = set.names.name(place);
    problems.add(std::move(problem));
  }
  if (whole) problems.add(check_files(FileCheck(folder, *manifest), options.threads));
  problems.add(std::move(set.wordings));
  problems.add(std::move(set.proofs));
  if (whole) problems.add(whole->problems(set.names));
  count_proven(problems, set);
  if (whole) report.likeness = whole->likeness();
  report.counts = set.counts;
  report.by_simulator = set.by_simulator;
  if (manifest && own.are_all()) report.counts.tasks = std::max(report.counts.tasks, manifest->tasks);
  reported();
  sort_by_task(report.problems, set.names);
  return report;
}

}  // namespace unietp
