#include "report/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <set>

#include "core/share_work.h"
#include "report/formula_census.h"
#include "scene/simulator.h"

namespace unietp {
namespace {

constexpr std::array<std::string_view, 64> kFunctionWords{
    "a",     "all",   "also", "an",   "and",    "any",    "are",  "as",    "at",   "be",   "been",  "but",   "by",
    "can",   "could", "do",   "each", "for",    "from",   "has",  "have",  "i",    "if",   "in",    "into",  "is",
    "it",    "its",   "just", "let",  "like",   "make",   "me",   "must",  "my",   "need", "needs", "not",   "of",
    "on",    "one",   "onto", "or",   "please", "should", "so",   "some",  "sure", "that", "the",   "them",  "then",
    "there", "they",  "this", "to",   "want",   "was",    "with", "would", "you",  "your", "see",   "ensure"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool joins = (text[i] == '-' || text[i] == '\'') && i + 1 < text.size() && is_letter(text[i + 1]);
    if (is_letter(text[i]) || (text[i] >= '0' && text[i] <= '9') || (joins && !words.back().empty())) {
      words.back() += static_cast<char>(text[i] >= 'A' && text[i] <= 'Z' ? text[i] - 'A' + 'a' : text[i]);
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool is_function_word(const std::string& word) {
  return std::find(kFunctionWords.begin(), kFunctionWords.end(), word) != kFunctionWords.end();
}

void count_texts(const FinishedSet& set, DatasetStatistics& statistics) {
  std::set<std::string> distinct;
  for (const TaskRecord& task : set.tasks) {
    const auto words = words_of(task.instruction);
    statistics.instruction_words.add(static_cast<int>(words.size()));
    distinct.insert(words.begin(), words.end());
    for (const auto& word : words) {
      if (!is_function_word(word)) ++statistics.words[word];
    }
  }
  statistics.distinct_words = static_cast<int>(distinct.size());
}

void count_goals(const FinishedSet& set, DatasetStatistics& statistics) {
  for (const TaskRecord& task : set.tasks) {
    const FormulaCensus census = census_of(task.goal_tree);
    for (const auto& name : census.operators) ++statistics.operators[name];
    for (const auto& name : census.predicates) ++statistics.predicates[name];
  }
}

std::vector<FunnelRow> funnel_of(const FinishedSet& set) {
  std::map<std::string, FunnelRow> rows;
  for (const TaskRecord& task : set.tasks) ++rows[task.template_name].accepted;
  for (const RejectionRecord& candidate : set.given_up)
    ++rows[candidate.template_name].causes[candidate.stage + ": " + candidate.reason];
  std::vector<FunnelRow> funnel;
  for (auto& [name, row] : rows) {
    row.template_name = name;
    funnel.push_back(std::move(row));
  }
  return funnel;
}

Evenness evenness_of(const std::string& dimension, const Tally& tasks) {
  Evenness even{dimension, tasks};
  double sum = 0, squares = 0, entropy = 0;
  for (const auto& [value, count] : tasks) sum += count, squares += static_cast<double>(count) * count;
  for (const auto& [value, count] : tasks) entropy -= count / sum * std::log(count / sum);
  const auto values = static_cast<double>(tasks.size());
  const double mean = sum / values;
  even.effective = sum * sum / squares;
  even.by_entropy = std::exp(entropy);
  even.variation = std::sqrt(std::max(0.0, squares / values - mean * mean)) / mean;
  return even;
}

/// Rooms, objects and categories of each home, in the start of its first task.
Result<Done> count_homes(const FinishedSet& set, int threads, DatasetStatistics& statistics,
                         std::map<std::string, std::set<std::string>>& in_homes) {
  std::map<std::string, const TaskRecord*> first;  // of a home
  for (const TaskRecord& task : set.tasks) first.emplace(task.layout, &task);
  const std::vector<std::pair<std::string, const TaskRecord*>> homes(first.begin(), first.end());
  std::vector<std::optional<Error>> errors(homes.size());
  std::mutex mutex;
  share_work(threads, homes.size(), [&](std::size_t i) {
    const auto scene = read_start_scene(set.folder, *homes[i].second);
    const std::lock_guard lock(mutex);
    if (!scene) {
      errors[i] = scene.error();
      return;
    }
    statistics.rooms.add(static_cast<int>(scene->rooms.size()));
    statistics.objects.add(static_cast<int>(scene->nodes.size()));
    for (const Node& node : scene->nodes) in_homes[homes[i].second->simulator].insert(node.category);
  });
  for (const auto& error : errors) {
    if (error) return *error;
  }
  statistics.homes = static_cast<int>(homes.size());
  return Done{};
}

Result<Done> count_actions(const FinishedSet& set, int threads, DatasetStatistics& statistics) {
  for (const Mode mode : set.modes) {
    const std::string name(name_of(mode));
    auto& lengths = statistics.plan_lengths[name];
    auto& actions = statistics.actions[name];
    int& failed = statistics.failed_steps[name];
    const auto read = read_demonstrations(set, mode, threads, [&](std::size_t, const DemonstrationRecord& shown) {
      lengths.add(static_cast<int>(shown.steps.size()));
      for (const StepRecord& step : shown.steps) {
        ++actions[step.command.action];
        failed += step.success ? 0 : 1;
      }
    });
    if (!read) return read.error();
  }
  return Done{};
}

}  // namespace

int Histogram::total() const {
  int sum = 0;
  for (const auto& [value, count] : counts) sum += count;
  return sum;
}

double Histogram::mean() const {
  double sum = 0;
  for (const auto& [value, count] : counts) sum += static_cast<double>(value) * count;
  return counts.empty() ? 0 : sum / total();
}

double Histogram::median() const {
  const int all = total();
  const auto at = [&](int rank) {
    for (const auto& [value, count] : counts) {
      if (rank < count) return value;
      rank -= count;
    }
    return 0;
  };
  return all == 0 ? 0 : (at((all - 1) / 2) + at(all / 2)) / 2.0;
}

int Histogram::least() const { return counts.empty() ? 0 : counts.begin()->first; }
int Histogram::most() const { return counts.empty() ? 0 : counts.rbegin()->first; }

int FunnelRow::candidates() const {
  int sum = accepted;
  for (const auto& [cause, count] : causes) sum += count;
  return sum;
}

int DatasetStatistics::candidates() const {
  int sum = 0;
  for (const FunnelRow& row : funnel) sum += row.candidates();
  return sum;
}

Result<DatasetStatistics> statistics_of_set(const FinishedSet& set, const std::vector<const Knowledge*>& knowledge,
                                            int threads) {
  DatasetStatistics statistics;
  statistics.name = set.name;
  statistics.tasks = static_cast<int>(set.tasks.size());
  std::map<std::string, std::set<std::string>> handled, in_homes;  // by simulator
  for (const TaskRecord& task : set.tasks) {
    ++statistics.by_simulator_and_split[{task.simulator, task.split}];
    ++statistics.templates[task.template_name];
    ++statistics.styles[task.style];
    ++statistics.writers[task.writer];
    for (const auto& [placeholder, category] : task.bindings) handled[task.simulator].insert(category);
  }
  count_texts(set, statistics);
  count_goals(set, statistics);
  statistics.funnel = funnel_of(set);
  for (const auto& [dimension, tasks] : set.level) statistics.evenness.push_back(evenness_of(dimension, tasks));
  if (auto done = count_homes(set, threads, statistics, in_homes); !done) return done.error();
  if (auto done = count_actions(set, threads, statistics); !done) return done.error();
  for (const Knowledge* base : knowledge) {
    const std::string simulator(name_of(base->simulator()));
    if (handled[simulator].empty() && in_homes[simulator].empty()) continue;
    CategoryCoverage coverage{simulator, static_cast<int>(base->categories().size())};
    for (const auto& category : base->categories()) {
      const bool is_handled = handled[simulator].contains(category.name);
      coverage.handled += is_handled ? 1 : 0;
      coverage.in_homes += is_handled || in_homes[simulator].contains(category.name) ? 1 : 0;
    }
    statistics.coverage.push_back(coverage);
  }
  return statistics;
}

}  // namespace unietp
