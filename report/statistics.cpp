#include "report/statistics.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/text.h"
#include "record/dataset_reader.h"
#include "record/record_file.h"
#include "scene/simulator.h"

namespace unietp {
namespace {

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

/// Whether a text says a phrase; of "something to read: I'm bored." both parts.
bool says(const std::string& text, const std::string& phrase) {
  const std::string spoken = lower(text);
  const auto parts = split(lower(phrase), ':');
  return std::all_of(parts.begin(), parts.end(),
                     [&](const std::string& part) { return spoken.find(trim(part)) != std::string::npos; });
}

/// The narrowest phrase of the knowledge base that holds for all of these, of those that the text says if it says any;
/// their names when none does.
std::string phrase_for(const std::vector<std::string>& serving, const std::string& text, const Knowledge& base) {
  std::map<std::pair<AliasKind, std::string>, std::set<std::string>> holders;
  for (const auto& alias : base.aliases()) {
    // A request begins with the state that it asks for: "closed The milk is going to go bad."
    const bool request = alias.kind == AliasKind::Request;
    holders[{alias.kind, request ? alias.text.substr(alias.text.find(' ') + 1) : alias.text}].insert(alias.category);
  }
  const std::string* best = nullptr;
  std::pair<bool, std::size_t> best_rank;
  for (const auto& [phrase, members] : holders) {
    if (!std::includes(members.begin(), members.end(), serving.begin(), serving.end())) continue;
    const std::pair rank(!says(text, phrase.second), members.size());
    if (best == nullptr || rank < best_rank) best = &phrase.second, best_rank = rank;
  }
  return best == nullptr ? join(serving, " or ") : *best;
}

/// The narrowest kinds of these, each once, in order of name: "cup, glass".
std::string kinds_of(const std::vector<std::string>& serving, const Knowledge& base) {
  std::set<std::string> kinds;
  for (const std::string& name : serving) {
    const auto* category = base.find(name);
    kinds.insert(category == nullptr || category->kinds.empty() ? name : category->kinds.front());
  }
  return join(std::vector<std::string>(kinds.begin(), kinds.end()), ", ");
}

/// Of a home, in the start of its first task.
struct HomeFigures {
  std::string layout, simulator;
  int rooms = 0, objects = 0;
  std::map<std::string, int> categories;  // objects of each
};

/// Adds up what the tasks and the rejections of a data set have.
class Counter {
 public:
  explicit Counter(DatasetStatistics& statistics) : statistics_(statistics) {}

  void add(const TaskFigures& task) {
    ++statistics_.tasks;
    ++statistics_.by_simulator_and_split[{task.simulator, task.split}];
    ++statistics_.templates[task.template_name];
    if (!task.purpose.empty()) ++statistics_.purposes[task.purpose];
    ++statistics_.styles[task.style];
    for (const auto& name : task.phenomena) ++statistics_.phenomena[name];
    ++statistics_.writers[task.writer];
    ++funnel_[task.template_name].accepted;
    handled_[task.simulator].insert(task.categories.begin(), task.categories.end());
    things_[task.simulator].add(task.things);
    ++things_[task.simulator].templates[task.template_name];
    homes_.emplace(task.layout, FirstTask{task.id});
    for (const auto& name : task.goal.operators) ++statistics_.operators[name];
    for (const auto& name : task.goal.predicates) ++statistics_.predicates[name];
    for (const auto& serving : task.alternatives) ++alternatives_[task.simulator][{serving, task.instruction}];
    add_words(task.words);
    for (const auto& [mode, plan] : task.plans) add_plan(std::string(name_of(mode)), plan);
  }

  void add(const RejectionRecord& candidate) {
    ++funnel_[candidate.template_name].causes[candidate.stage + ": " + candidate.reason];
  }

  /// Whether the task is the first of its home. Several threads may call this while starts are added.
  bool is_first(const TaskRecord& task) const {
    const auto home = homes_.find(task.layout);
    return home != homes_.end() && home->second.id == task.id;
  }

  /// The start of the first task of a home; a second task of the same name does not count.
  void add(const HomeFigures& home) {
    bool& is_counted = homes_.at(home.layout).is_counted;
    if (is_counted) return;
    is_counted = true;
    ++statistics_.homes;
    statistics_.rooms.add(home.rooms);
    statistics_.objects.add(home.objects);
    for (const auto& [category, objects] : home.categories) in_homes_[home.simulator][category] += objects;
  }

  std::size_t homes() const { return homes_.size(); }

  void finish(const std::vector<const Knowledge*>& knowledge) {
    statistics_.distinct_words = static_cast<int>(statistics_.words.size() + function_words_.size());
    for (auto& [name, row] : funnel_) {
      row.template_name = name;
      statistics_.funnel.push_back(std::move(row));
    }
    for (const Knowledge* base : knowledge) {
      add_coverage(*base);
      add_things(*base);
      for (const auto& [asked, parts] : alternatives_[std::string(name_of(base->simulator()))]) {
        const auto& [serving, text] = asked;
        statistics_.alternatives[phrase_for(serving, text, *base)] += parts;
        statistics_.kinds_asked_for[kinds_of(serving, *base)] += parts;
      }
    }
  }

 private:
  struct FirstTask {
    std::string id;
    bool is_counted = false;  // its home
  };

  void add_words(const std::vector<std::string>& words) {
    statistics_.instruction_words.add(static_cast<int>(words.size()));
    for (const auto& word : words) {
      if (is_function_word(word)) {
        function_words_.insert(word);
      } else {
        ++statistics_.words[word];
      }
    }
  }

  void add_plan(const std::string& mode, const TaskFigures::Plan& plan) {
    statistics_.plan_lengths[mode].add(plan.steps);
    statistics_.failed_steps[mode] += plan.failed;
    for (const auto& [action, count] : plan.actions) statistics_.actions[mode][action] += count;
  }

  void add_coverage(const Knowledge& base) {
    const std::string simulator(name_of(base.simulator()));
    const auto& handled = handled_[simulator];
    const auto& in_homes = in_homes_[simulator];
    if (handled.empty() && in_homes.empty()) return;
    CategoryCoverage coverage{simulator, static_cast<int>(base.categories().size())};
    for (const auto& category : base.categories()) {
      const bool is_handled = handled.contains(category.name);
      coverage.handled += is_handled ? 1 : 0;
      coverage.in_homes += is_handled || in_homes.contains(category.name) ? 1 : 0;
    }
    statistics_.coverage.push_back(coverage);
  }

  void add_things(const Knowledge& base) {
    const std::string simulator(name_of(base.simulator()));
    const auto found = things_.find(simulator);
    if (found == things_.end()) return;
    GoalThings& things = found->second;
    things.simulator = simulator;
    things.finish(base, in_homes_[simulator]);
    statistics_.things.push_back(std::move(things));
  }

  DatasetStatistics& statistics_;
  std::map<std::string, FirstTask> homes_;
  std::map<std::string, FunnelRow> funnel_;
  /// Parts of goals, by simulator, the categories that serve, and text.
  std::map<std::string, std::map<std::pair<std::vector<std::string>, std::string>, int>> alternatives_;
  std::map<std::string, std::set<std::string>> handled_;        // categories, by simulator
  std::map<std::string, std::map<std::string, int>> in_homes_;  // objects, by simulator and category
  std::map<std::string, GoalThings> things_;                    // by simulator
  std::set<std::string> function_words_;                        // that occurred
};

Result<Done> count_tasks(const FinishedSet& set, int threads, Counter& counter) {
  auto reader = DatasetReader::open(set.folder, {.modes = set.modes});
  if (!reader) return reader.error();
  return for_each_task<TaskFigures>(
      std::move(*reader), threads, [](const FinishedTask& task) -> Result<TaskFigures> { return figures_of(task); },
      [&](TaskFigures&& figures) -> Result<Done> {
        counter.add(figures);
        return Done{};
      });
}

Result<Done> count_rejections(const FinishedSet& set, Counter& counter) {
  auto rejections =
      RecordFile<RejectionRecord>::open(set.folder, "rejections.jsonl", FileNames::WithFolder, read_rejection);
  if (!rejections) return rejections.error();
  while (const auto rejection = rejections->next()) {
    if (!*rejection) return rejection->error();
    counter.add(**rejection);
  }
  return Done{};
}

/// A second pass, since which task is the first of its home is known after the first one only, whatever threads do.
Result<Done> count_homes(const FinishedSet& set, int threads, Counter& counter) {
  auto reader = DatasetReader::open(set.folder, {});
  if (!reader) return reader.error();
  using Home = std::optional<HomeFigures>;
  return for_each_task<Home>(
      std::move(*reader), threads,
      [&](const FinishedTask& task) -> Result<Home> {
        if (!counter.is_first(task.record)) return Home();
        const auto start = read_start_scene(set.folder, task.record);
        if (!start) return start.error();
        HomeFigures home{task.record.layout,
                         task.record.simulator,
                         static_cast<int>(start->rooms.size()),
                         static_cast<int>(start->nodes.size()),
                         {}};
        for (const Node& node : start->nodes) ++home.categories[node.category];
        return Home(std::move(home));
      },
      [&](Home&& home) -> Result<Done> {
        if (home) counter.add(*home);
        return Done{};
      });
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
  for (const Mode mode : set.modes) {  // also where there is no task
    const std::string name(name_of(mode));
    statistics.plan_lengths[name] = {};
    statistics.actions[name] = {};
    statistics.failed_steps[name] = 0;
  }
  for (const auto& [dimension, tasks] : set.level) statistics.evenness.push_back(evenness_of(dimension, tasks));
  Counter counter(statistics);
  if (auto done = count_tasks(set, threads, counter); !done) return done.error();
  if (auto done = count_rejections(set, counter); !done) return done.error();
  if (auto done = count_homes(set, threads, counter); !done) return done.error();
  if (static_cast<std::size_t>(statistics.homes) != counter.homes()) return changed_while_read(set);
  counter.finish(knowledge);
  return statistics;
}

}  // namespace unietp
