#include "audit/audit.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "audit/other_homes.h"
#include "audit/play.h"
#include "audit/tail.h"
#include "audit/task_questions.h"
#include "audit/text_rank.h"
#include "core/share_work.h"
#include "record/dataset_reader.h"
#include "scene/simulator.h"
#include "scores/paired_test.h"

namespace unietp {
namespace {

/// The guesses of all policies of one question's choice.
struct Played {
  const AuditedTask* task = nullptr;
  const GuessQuestion* question = nullptr;
  std::vector<std::pair<const ShortcutPolicy*, Guesses>> guesses;
};

void play_all(Played& played, std::uint64_t number, const LearnedModels& models,
              const std::map<GuessChoice, KindPool>& pools, const std::vector<const ShortcutPolicy*>& policies) {
  const std::size_t part = part_of(*played.task);
  const ModelsOfPart of_part{&models.small_things[part], &models.of_kind[part]};
  std::map<std::size_t, std::vector<const ShortcutPolicy*>> by_channel;  // by place of the first policy that has it
  for (const ShortcutPolicy* policy : policies) {
    if (policy->choice != played.question->choice) continue;
    const auto first = std::find_if(policies.begin(), policies.end(), [&](const ShortcutPolicy* other) {
      return other->choice == policy->choice && other->channel == policy->channel;
    });
    by_channel[static_cast<std::size_t>((*first) - shortcut_policies().data())].push_back(policy);
  }
  for (const auto& [channel, together] : by_channel) {
    const auto guesses = play(*played.question, together, of_part, pools.at(played.question->choice),
                              Rng(number).fork("audit", channel));
    for (std::size_t p = 0; p < together.size(); ++p) played.guesses.emplace_back(together[p], guesses[p]);
  }
}

/// Questions of a cell, added one by one.
struct Sum {
  int asked = 0, right = 0;
  std::vector<int> by_permutation = std::vector<int>(kPermutations, 0);
  std::vector<double> chances;

  void add(const Guesses& guesses) {
    ++asked;
    right += guesses[0] ? 1 : 0;
    for (std::size_t i = 0; i < kPermutations; ++i) by_permutation[i] += guesses[i + 1] ? 1 : 0;
    chances.push_back(static_cast<double>(guesses.count()) / (1 + kPermutations));
  }
};

AuditCell cell_of(const ShortcutPolicy& policy, Mode mode, std::string group, Sum sum) {
  AuditCell cell{&policy, mode, std::move(group), sum.asked, sum.right};
  std::sort(sum.by_permutation.begin(), sum.by_permutation.end());
  const double asked = sum.asked;
  cell.chance = std::accumulate(sum.by_permutation.begin(), sum.by_permutation.end(), 0.0) / asked / kPermutations;
  cell.low = sum.by_permutation[kPermutations / 40] / asked;
  cell.high = sum.by_permutation[kPermutations - 1 - kPermutations / 40] / asked;
  cell.p = chance_of_at_least(sum.right, sum.chances);
  return cell;
}

/// "all" first, then splits, then simulators.
std::vector<std::string> groups_of(const AuditedTask& task) {
  return {"all", task.split, std::string(name_of(task.simulator))};
}

std::vector<AuditCell> cells_of(const std::vector<Played>& all, int threads) {
  using Key = std::tuple<std::size_t, Mode, std::size_t, std::string>;  // place of the policy, mode, level, group
  std::map<Key, Sum> sums;
  for (const Played& played : all) {
    const auto groups = groups_of(*played.task);
    for (const auto& [policy, guesses] : played.guesses) {
      for (std::size_t level = 0; level < groups.size(); ++level)
        sums[{static_cast<std::size_t>(policy - shortcut_policies().data()), played.question->mode, level,
              groups[level]}]
            .add(guesses);
    }
  }
  std::vector<std::pair<Key, Sum>> listed(std::make_move_iterator(sums.begin()), std::make_move_iterator(sums.end()));
  std::vector<AuditCell> cells(listed.size());
  share_work(threads, listed.size(), [&](std::size_t i) {
    auto& [key, sum] = listed[i];
    cells[i] = cell_of(shortcut_policies()[std::get<0>(key)], std::get<1>(key), std::get<3>(key), std::move(sum));
  });
  std::vector<double> chances;
  for (const AuditCell& cell : cells) chances.push_back(cell.p);
  chances = holm(std::move(chances));
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i].p = chances[i];
  return cells;
}

}  // namespace

int AuditReport::leaks() const {
  return static_cast<int>(
      std::count_if(cells.begin(), cells.end(), [](const AuditCell& cell) { return cell.leaks(); }));
}

Result<std::vector<AuditedTask>> audited_tasks(const std::filesystem::path& folder, int threads,
                                               const std::function<void(int)>& progress) {
  auto reader = DatasetReader::open(folder, {shown_modes(folder), false, true});
  if (!reader) return reader.error();
  std::vector<AuditedTask> tasks;
  const auto done = for_each_task<AuditedTask>(
      std::move(*reader), threads, [](const FinishedTask& task) -> Result<AuditedTask> { return audited_task(task); },
      [&](AuditedTask&& task) -> Result<Done> {
        tasks.push_back(std::move(task));
        progress(static_cast<int>(tasks.size()));
        return Done{};
      });
  if (!done) return done.error();
  if (tasks.empty()) return Error{Error::Kind::Schema, folder.string(), {}, "has no tasks to audit"};
  return tasks;
}

AuditSettings whole_audit() {
  AuditSettings settings;
  for (const ShortcutPolicy& policy : shortcut_policies()) settings.policies.push_back(&policy);
  return settings;
}

AuditReport audit(std::vector<AuditedTask> tasks, std::vector<AuditedTask> training, const AuditSettings& settings) {
  AuditReport report;
  report.tasks = static_cast<int>(tasks.size());
  report.examples = static_cast<int>(training.size());
  std::set<std::string> homes;
  for (const AuditedTask& task : tasks) homes.insert(task.home);
  report.homes = static_cast<int>(homes.size());
  if (training.empty()) training = tasks;
  compare_with_other_homes(tasks, training);
  compare_with_other_homes(training, training);
  learn_from_texts(tasks, training);
  const LearnedModels models = learn_models(training);
  std::vector<Played> played;
  std::map<GuessChoice, KindPool> pools;
  for (const ShortcutPolicy& policy : shortcut_policies()) {
    if (!pools.contains(policy.choice)) pools.emplace(policy.choice, pool_of(tasks, policy.choice));
  }
  for (const AuditedTask& task : tasks) {
    for (const GuessQuestion& question : task.questions) played.push_back({&task, &question, {}});
  }
  std::atomic<int> done = 0;
  share_work(settings.threads, played.size(), [&](std::size_t i) {
    play_all(played[i], i, models, pools, settings.policies);
    const int count = ++done;
    if (settings.progress) settings.progress(count);
  });
  report.cells = cells_of(played, settings.threads);
  return report;
}

}  // namespace unietp
