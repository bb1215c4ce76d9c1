#include "validator/repeats.h"

#include <array>
#include <cstdio>
#include <map>

#include "record/manifest_record.h"

namespace unietp {
namespace {

Problem of_task(ProblemKind kind, std::string where, std::string task, std::string message) {
  auto problem = problem_in(kind, std::move(where), std::move(message));
  problem.task = std::move(task);
  return problem;
}

/// What of one task must not occur in another data set.
struct TaskPrint {
  std::string name, layout, home_key;
  std::shared_ptr<const HomeFingerprint> home;
  GoalPrint goal;
  TextFingerprint text;
};

TaskPrint print_of_task(const TaskRecord& task, const Scene& home, LazyValues<HomeFingerprint>& homes) {
  return {task.id,
          task.layout,
          home_key_of(home),
          homes.get(task.layout, [&home] { return print_of_home(home); }),
          print_of_goal(task.goal_tree),
          print_of_text(task.instruction)};
}

std::string two_digits(double value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

}  // namespace

void RepeatSearch::add(std::size_t place, const TaskFacts& facts) {
  if (facts.start_key.empty()) return;
  starts_.add(facts.start_key, place);
  texts_.add(facts.text_key, place);
}

ProblemList RepeatSearch::problems(const TaskNames& names) {
  ProblemList problems;
  const auto found = [&](ProblemKind kind, std::size_t place, std::string message) {
    problems.add(of_task(kind, std::string(kTasksFile) + ":" + std::to_string(place + 1), names.name(place),
                         std::move(message)));
  };
  for (const auto& [place, first] : starts_.repeats())
    found(ProblemKind::RepeatedStart, place, "has the same template, binding, goal and start as " + names.name(first));
  for (const auto& [place, first] : texts_.repeats())
    found(ProblemKind::RepeatedText, place, "has the same instruction as " + names.name(first) + " in the same home");
  return problems;
}

Result<SetFingerprint> print_of(const std::filesystem::path& folder, int threads) {
  const auto manifest = read_manifest_file(folder);
  if (!manifest) return manifest.error();
  SetFingerprint print;
  print.folder = folder.string();
  print.seed = manifest->run.seed;
  auto reader = DatasetReader::open(folder, {});
  if (!reader) return reader.error();
  HomeCache& homes = reader->homes();
  LazyValues<HomeFingerprint> prints;
  std::map<std::string, std::size_t> places;  // of the homes
  const auto done = for_each_task<TaskPrint>(
      std::move(*reader), threads,
      [&homes, &prints](const FinishedTask& task) -> Result<TaskPrint> {
        const auto home = homes.home(task.record.layout);
        if (!home) return home.error();
        return print_of_task(task.record, **home, prints);
      },
      [&print, &places](TaskPrint&& task) -> Result<Done> {
        const auto [place, is_new] = places.emplace(task.layout, print.compared.homes.size());
        if (is_new) print.compared.homes.push_back({task.layout, std::move(task.home)});
        print.compared.tasks.push_back(
            {std::move(task.name), place->second, std::move(task.goal), std::move(task.text)});
        print.home_keys.insert(std::move(task.home_key));
        return Done{};
      });
  if (!done) return done.error();
  return print;
}

LeakSearch::LeakSearch(SetFingerprint other)
    : other_(std::move(other)), search_(std::exchange(other_.compared, {})), count_(other_.folder) {}

std::optional<Nearest> LeakSearch::nearest(const TaskReading& task, const Scene& home) const {
  return search_.of(*task.record, home);
}

void LeakSearch::add(const TaskReading& task, const TaskFacts& facts, const std::optional<Nearest>& nearest) {
  if (!task.record) return;
  const TaskRecord& record = *task.record;
  const auto found = [&](ProblemKind kind, std::string message) {
    of_tasks_.add(of_task(kind, task.where, task.name, std::move(message)));
  };
  if (other_.home_keys.contains(facts.home_key)) {
    found(ProblemKind::SharedLayout, "the rooms and furniture of " + record.layout + " are also in " + other_.folder);
  } else if (nearest && nearest->home >= kCopiedHome) {
    found(ProblemKind::SimilarHome, "its home " + record.layout + " is " + two_digits(nearest->home) + " like " +
                                        search_.other().homes[nearest->home_place].name + " of " + other_.folder +
                                        " (from " + two_digits(kCopiedHome) + " on it is a copy)");
  }
  if (!nearest) return;
  count_.add(record, *nearest, search_.other());
  if (const auto& [place, likeness] = nearest->by_all; likeness.nearness() >= 1)
    found(ProblemKind::SimilarTask, "is much like " + search_.other().tasks[place].name + " of " + other_.folder +
                                        ": goal " + two_digits(likeness.goal) + ", text " + two_digits(likeness.text) +
                                        ", home " + two_digits(likeness.home) + " (from " + two_digits(kSimilarGoal) +
                                        ", " + two_digits(kSimilarText) + " and " + two_digits(kSimilarHome) +
                                        " on it is a copy)");
}

ProblemList LeakSearch::problems(std::uint64_t seed) const {
  ProblemList problems;
  if (seed == other_.seed)
    problems.add(problem_in(ProblemKind::SharedSeed, "manifest.json",
                            "the run's seed " + std::to_string(seed) + " is also that of " + other_.folder));
  problems.add(of_tasks_);
  return problems;
}

}  // namespace unietp
