#include "validator/repeats.h"

#include <map>
#include <mutex>

#include "core/files.h"
#include "core/share_work.h"
#include "record/home_shelf.h"
#include "record/manifest_record.h"

namespace unietp {
namespace {

Problem about(ProblemKind kind, const TaskReading& task, std::string message) {
  auto problem = problem_in(kind, task.where, std::move(message));
  problem.task = task.name;
  return problem;
}

}  // namespace

std::vector<Problem> find_repeats(const FolderReading& set, const std::vector<TaskFacts>& facts) {
  std::vector<Problem> problems;
  std::map<std::string_view, std::size_t> starts, texts;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const TaskReading& task = set.tasks[i];
    if (facts[i].start_key.empty()) continue;
    if (const auto [first, is_new] = starts.try_emplace(facts[i].start_key, i); !is_new)
      problems.push_back(about(ProblemKind::RepeatedStart, task,
                               "has the same template, binding, goal and start as " + set.tasks[first->second].name));
    if (const auto [first, is_new] = texts.try_emplace(facts[i].text_key, i); !is_new)
      problems.push_back(about(ProblemKind::RepeatedText, task,
                               "has the same instruction as " + set.tasks[first->second].name + " in the same home"));
  }
  return problems;
}

Result<SetPrint> print_of(const std::filesystem::path& folder, int threads) {
  SetPrint print;
  print.folder = folder.string();
  const auto text = read_file(folder / "manifest.json");
  if (!text) return text.error();
  const auto manifest = read_manifest((folder / "manifest.json").string(), *text);
  if (!manifest) return manifest.error();
  print.seed = manifest->run.seed;
  std::vector<Problem> problems;
  const auto set = read_folder(folder, problems);
  if (!set) return set.error();
  HomeShelf homes(folder);
  std::mutex mutex;
  std::map<std::size_t, Error> failed;  // by task, so that the first is told whatever the threads do
  share_work(threads, set->tasks.size(), [&](std::size_t i) {
    const TaskReading& task = set->tasks[i];
    const auto fail = [&](Error error) {
      const std::scoped_lock lock(mutex);
      failed.emplace(i, std::move(error));
    };
    if (!task.record) return fail(task.record.error());
    const auto home = homes.home(task.record->layout);
    if (!home) return fail(home.error());
    auto key = home_key_of(**home);
    const std::scoped_lock lock(mutex);
    print.layouts.insert(task.record->layout);
    print.words.insert(plain_words(task.record->instruction));
    print.home_keys.insert(std::move(key));
  });
  if (!failed.empty()) return failed.begin()->second;
  return print;
}

std::vector<Problem> find_leaks(const FolderReading& set, std::uint64_t seed, const std::vector<TaskFacts>& facts,
                                const SetPrint& other) {
  std::vector<Problem> problems;
  if (seed == other.seed)
    problems.push_back(problem_in(ProblemKind::SharedSeed, "manifest.json",
                                  "the run's seed " + std::to_string(seed) + " is also that of " + other.folder));
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const TaskReading& task = set.tasks[i];
    if (!task.record) continue;
    const TaskRecord& record = *task.record;
    if (other.layouts.contains(record.layout)) {
      problems.push_back(
          about(ProblemKind::SharedLayout, task, "its home " + record.layout + " is also in " + other.folder));
    } else if (other.home_keys.contains(facts[i].home_key)) {
      problems.push_back(about(ProblemKind::SharedLayout, task,
                               "the rooms and furniture of " + record.layout + " are also in " + other.folder));
    }
    if (other.words.contains(plain_words(record.instruction)))
      problems.push_back(about(ProblemKind::SharedText, task, "its instruction is also in " + other.folder));
  }
  return problems;
}

}  // namespace unietp
