#include "scores/comparison.h"

#include <algorithm>
#include <map>

#include "core/in_quotes.h"
#include "scores/figures.h"
#include "scores/paired_test.h"
#include "scores/result_tables.h"
#include "scores/table_cells.h"

namespace unietp {
namespace {

constexpr std::uint64_t kFlipSeed = 2;

/// A task in one run: finished repeats, and how many of them succeeded.
struct TaskCount {
  int finished = 0, successes = 0;
  std::string home;
  double rate() const { return successes / static_cast<double>(finished); }
};
using TaskCounts = std::map<std::string, TaskCount>;

TaskCounts counts_of(const ScoredRun& run, Mode mode) {
  TaskCounts counts;
  for (const EpisodeScore& one : run.scores) {
    if (one.key.mode != mode || one.errored()) continue;
    TaskCount& task = counts[one.key.task];
    ++task.finished;
    task.successes += one.success ? 1 : 0;
    task.home = one.layout;
  }
  return counts;
}

bool is_single(const TaskCounts& counts) {
  return std::all_of(counts.begin(), counts.end(), [](const auto& one) { return one.second.finished == 1; });
}

PairComparison compare(const TaskCounts& first, const TaskCounts& second) {
  PairComparison pair;
  std::map<std::string, double> by_home;
  double sum = 0;
  for (const auto& [task, one] : first) {
    const auto other = second.find(task);
    if (other == second.end()) continue;
    const double difference = one.rate() - other->second.rate();
    ++pair.tasks;
    sum += difference;
    pair.only_first += difference > 0 ? 1 : 0;
    pair.only_second += difference < 0 ? 1 : 0;
    by_home[one.home] += difference;
  }
  if (pair.tasks > 0) pair.difference = sum / pair.tasks;
  std::vector<double> homes;
  for (const auto& [home, difference] : by_home) homes.push_back(difference);
  pair.p = is_single(first) && is_single(second) ? mcnemar_test(pair.only_first, pair.only_second)
                                                 : sign_flip_test(homes, Rng(kFlipSeed));
  return pair;
}

std::string p_text(double p) { return p < 0.001 ? "< 0.001" : fixed_text(p, 3); }

ResultCell cell(std::string text) { return {std::move(text), "", "", false}; }

ResultTable pair_table(const std::vector<PairComparison>& pairs, const std::vector<std::string>& labels,
                       const std::string& conditions, const std::string& mode) {
  ResultTable table{"pairs-" + mode,
                    "Pairs of runs in " + mode,
                    conditions +
                        " Difference of the success rates on the tasks that both finished, in points; the "
                        "probability of one as large between equal runs, corrected for the number of pairs (Holm).",
                    {{"", 8}},
                    {"", "against", "Tasks", "Difference", "Better in", "Worse in", "p", "Verdict"},
                    {}};
  for (const PairComparison& pair : pairs) {
    const std::string verdict = !pair.differ() ? "cannot be told apart" : pair.difference > 0 ? "better" : "worse";
    table.rows.push_back({cell(labels[pair.first]), cell(labels[pair.second]), cell(std::to_string(pair.tasks)),
                          cell(fixed_text(100 * pair.difference, 1)), cell(std::to_string(pair.only_first)),
                          cell(std::to_string(pair.only_second)), cell(p_text(pair.corrected)), cell(verdict)});
  }
  return table;
}

ResultTable rank_table(std::span<const ScoredRun> runs, Mode mode, const std::vector<PairComparison>& pairs,
                       const std::vector<std::string>& labels, const std::string& conditions) {
  const std::string name(name_of(mode));
  ResultTable table{"ranks-" + name,
                    "Ranks in " + name,
                    conditions + " A run shares its place with all that it cannot be told apart from.",
                    {{"", 4}},
                    {"Rank", "", "Success rate", "Cannot be told apart from"},
                    {}};
  const auto places = ranks(runs.size(), pairs);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto episodes = episodes_where(runs[i], [&](const EpisodeScore& one) { return one.key.mode == mode; });
    if (!episodes.empty()) order.emplace_back(-figures_of(episodes, false).success_rate(), i);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [rate, run] : order) {
    const auto episodes = episodes_where(runs[run], [&](const EpisodeScore& one) { return one.key.mode == mode; });
    const RankRange place = places[run];
    std::string alike;
    for (const PairComparison& pair : pairs) {
      if (pair.differ() || (pair.first != run && pair.second != run)) continue;
      alike += (alike.empty() ? "" : ", ") + labels[pair.first == run ? pair.second : pair.first];
    }
    ResultCell rate_cell = success_cell(figures_of(episodes, is_repeated(runs[run])));
    rate_cell.filter = filter_text(run, {{"mode", name}});
    table.rows.push_back(
        {cell(place.best == place.worst ? std::to_string(place.best)
                                        : std::to_string(place.best) + "–" + std::to_string(place.worst)),
         {labels[run], "", filter_text(run, {}), false},
         std::move(rate_cell),
         cell(alike.empty() ? "–" : alike)});
  }
  return table;
}

}  // namespace

Result<Done> check_comparable(std::span<const ScoredRun> runs) {
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const EvaluationSetup &one = runs[0].manifest.setup, &other = runs[i].manifest.setup;
    const auto named = [](const EvaluationSetup& setup) {
      return setup.dataset.version.empty()
                 ? in_quotes(setup.dataset.name) + " (" + setup.dataset.digest.substr(0, 12) + ")"
                 : setup.dataset.version;
    };
    const auto differ = [&](const std::string& what, const std::string& first, const std::string& second) {
      return Error{Error::Kind::Usage,
                   runs[i].name,
                   {},
                   "was made on " + what + second + ", but " + in_quotes(runs[0].name) + " on " + first +
                       "; runs on different benchmarks cannot be compared"};
    };
    if (one.dataset.digest != other.dataset.digest || one.dataset.version != other.dataset.version)
      return differ("", named(one), named(other));
    if (one.backend != other.backend) return differ("backend ", one.backend, other.backend);
  }
  return Done{};
}

std::vector<PairComparison> compare_pairs(std::span<const ScoredRun> runs, Mode mode) {
  std::vector<TaskCounts> counts;
  for (const ScoredRun& run : runs) counts.push_back(counts_of(run, mode));
  std::vector<PairComparison> pairs;
  std::vector<double> raw;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t k = i + 1; k < runs.size(); ++k) {
      if (counts[i].empty() || counts[k].empty()) continue;
      PairComparison pair = compare(counts[i], counts[k]);
      pair.first = i;
      pair.second = k;
      raw.push_back(pair.p);
      pairs.push_back(pair);
    }
  }
  const auto corrected = holm(raw);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].corrected = corrected[i];
  return pairs;
}

std::vector<RankRange> ranks(std::size_t runs, const std::vector<PairComparison>& pairs) {
  std::vector<int> better(runs, 0), worse(runs, 0), others(runs, 0);
  for (const PairComparison& pair : pairs) {
    ++others[pair.first];
    ++others[pair.second];
    if (!pair.differ()) continue;
    const bool first_wins = pair.difference > 0;
    ++(first_wins ? better[pair.second] : better[pair.first]);
    ++(first_wins ? worse[pair.first] : worse[pair.second]);
  }
  std::vector<RankRange> places;
  for (std::size_t i = 0; i < runs; ++i) places.push_back({1 + better[i], 1 + others[i] - worse[i]});
  return places;
}

std::vector<ResultTable> comparison_tables(std::span<const ScoredRun> runs) {
  std::vector<ResultTable> tables;
  const auto labels = labels_of(runs);
  const std::string conditions = conditions_of(runs);
  for (const Mode mode : kModes) {
    const auto pairs = compare_pairs(runs, mode);
    if (pairs.empty()) continue;
    tables.push_back(rank_table(runs, mode, pairs, labels, conditions));
    tables.push_back(pair_table(pairs, labels, conditions, std::string(name_of(mode))));
  }
  return tables;
}

}  // namespace unietp
