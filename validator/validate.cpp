#include "validator/validate.h"

#include <algorithm>

#include "core/files.h"
#include "core/share_work.h"
#include "record/manifest_record.h"
#include "validator/file_check.h"
#include "validator/prove.h"
#include "validator/recount.h"
#include "validator/repeats.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

std::optional<ManifestRecord> manifest_in(const fs::path& folder, std::string_view knowledge_digest,
                                          std::vector<Problem>& problems) {
  const auto text = read_file(folder / kManifest);
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

/// Wordings by task; those that do not read or are of nobody are problems.
std::map<std::string, WordingsRecord> wordings_in(const FolderReading& folder, std::vector<Problem>& problems) {
  std::map<std::string, WordingsRecord> wordings;
  const auto lines = LineFile::read(folder.folder, "wordings.jsonl");
  if (!lines) {
    problems.push_back({ProblemKind::Unreadable, "", lines.error()});
    return wordings;
  }
  std::set<std::string_view> names;
  for (const TaskReading& task : folder.tasks) names.insert(task.name);
  for (std::size_t i = 0; i < lines->size(); ++i) {
    auto record = read_wordings(lines->name(), static_cast<int>(i) + 1, lines->line(i));
    if (!record) {
      problems.push_back({ProblemKind::Unreadable, "", record.error()});
      continue;
    }
    const std::string task = record->task;
    if (!names.contains(task)) {
      problems.push_back(problem_in(ProblemKind::Wordings, lines->at(i), "belong to no task in tasks.jsonl"));
    } else if (!wordings.emplace(task, std::move(*record)).second) {
      problems.push_back(problem_in(ProblemKind::Wordings, lines->at(i), "repeat those of " + task));
    }
  }
  if (lines->size() > 0 && wordings.size() < names.size())
    problems.push_back(problem_in(ProblemKind::Wordings, lines->name(), "has no wordings for some tasks"));
  return wordings;
}

/// What is wrong with the tasks taken together.
std::vector<Problem> check_as_a_whole(const FolderReading& folder, const ManifestRecord& manifest,
                                      const std::vector<TaskFacts>& facts, const ValidationOptions& options) {
  auto problems = recount_tasks(manifest, folder);
  append(problems, recount_rejections(manifest, folder));
  append(problems, check_quotas(manifest.run, folder));
  const bool all_read = std::all_of(folder.tasks.begin(), folder.tasks.end(),
                                    [](const TaskReading& task) { return static_cast<bool>(task.record); });
  if (all_read) {
    auto database = check_database(folder, facts);
    append(problems, std::move(database.problems));
    append(problems, check_balance(manifest, std::move(database.traits)));
  }
  append(problems, find_repeats(folder, facts));
  for (const auto& other : options.against) {
    const auto print = print_of(other, options.threads);
    if (print) {
      append(problems, find_leaks(folder, manifest.run.seed, facts, *print));
    } else {
      problems.push_back({ProblemKind::Unreadable, "", print.error()});
    }
  }
  return problems;
}

/// Folder-wide problems first, then task by task; within each as they were found.
void sort_by_task(std::vector<Problem>& problems, const FolderReading& folder) {
  std::map<std::string_view, std::size_t> place{{"", 0}};
  for (const TaskReading& task : folder.tasks) place.emplace(task.name, place.size());
  const auto of = [&](const Problem& problem) {
    const auto found = place.find(problem.task);
    return found == place.end() ? 0 : found->second;
  };
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

}  // namespace

ValidationReport validate_dataset(const fs::path& folder, const std::vector<ValidationBackend>& backends,
                                  std::string_view knowledge_digest, const ValidationOptions& options) {
  ValidationReport report;
  auto& problems = report.problems;
  const auto stop_with = [&](Error error) {
    problems.push_back({ProblemKind::Unreadable, "", std::move(error)});
    return report;
  };
  if (std::error_code code; !fs::is_directory(folder, code))
    return stop_with({Error::Kind::Io, folder.string(), {}, "is not a folder; expected a finished data set"});
  const auto manifest = manifest_in(folder, knowledge_digest, problems);
  const auto reading = read_folder(folder, problems);
  if (!reading) return stop_with(reading.error());
  std::optional<FileCheck> files;
  if (manifest) {
    files.emplace(folder, *manifest);
    append(problems, files->listing());
    append(problems, check_files(*files, options.threads));
  }

  RestCheck rest(options.rest_m);
  HomeShelf homes(folder);
  ProofTools tools{*reading, backends, options, rest, homes, "all", {}};
  if (manifest) tools.phrasings = manifest->phrasings;
  tools.wordings = wordings_in(*reading, problems);
  const auto count = reading->tasks.size();
  std::vector<TaskProof> proofs(count);
  share_work(options.threads, count, [&](std::size_t i) {
    if (reading->tasks[i].record) proofs[i] = prove_task(reading->tasks[i], tools);
  });

  std::vector<TaskFacts> facts;
  for (TaskProof& proof : proofs) {
    facts.push_back(std::move(proof.facts));
    append(problems, std::move(proof.problems));
  }
  if (manifest) append(problems, check_as_a_whole(*reading, *manifest, facts, options));
  sort_by_task(problems, *reading);

  std::set<std::string_view> wrong;
  for (const Problem& problem : problems) wrong.insert(problem.task);
  for (std::size_t i = 0; i < count; ++i) {
    ProofCounts& own = proofs[i].counts;
    own.tasks = 1;
    own.proven = wrong.contains(reading->tasks[i].name) ? 0 : 1;
    add(report.counts, own);
    const auto& record = reading->tasks[i].record;
    const auto simulator = record ? simulator_named(record->simulator) : std::nullopt;
    if (simulator) add(report.by_simulator[static_cast<std::size_t>(*simulator)], own);
  }
  if (manifest) report.counts.tasks = std::max(report.counts.tasks, manifest->tasks);
  return report;
}

}  // namespace unietp
