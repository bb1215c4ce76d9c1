#include "report/figure_table.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/text.h"

namespace unietp {
namespace {

using Sets = std::span<const DatasetStatistics>;
using Cell = std::function<std::string(const DatasetStatistics&)>;

FigureTable table(std::string id, std::string title, std::string note, std::string rows, Sets sets,
                  const std::string& alone) {
  FigureTable made{std::move(id), std::move(title), std::move(note), {std::move(rows)}, {}};
  for (const auto& set : sets) made.columns.push_back(sets.size() == 1 ? alone : set.name);
  return made;
}

void add_row(FigureTable& table, Sets sets, std::string name, const Cell& cell) {
  std::vector<std::string> row{std::move(name)};
  for (const auto& set : sets) row.push_back(cell(set));
  table.rows.push_back(std::move(row));
}

int count_in(const Tally& tally, const std::string& name) {
  const auto found = tally.find(name);
  return found == tally.end() ? 0 : found->second;
}

/// Every name of the sets' tallies, the most frequent first.
std::vector<std::string> names_in(Sets sets, const std::function<Tally(const DatasetStatistics&)>& tally_of) {
  Tally sum;
  for (const auto& set : sets) {
    for (const auto& [name, count] : tally_of(set)) sum[name] += count;
  }
  std::vector<std::string> names;
  for (const auto& [name, count] : sum) names.push_back(name);
  std::stable_sort(names.begin(), names.end(), [&](const auto& a, const auto& b) { return sum.at(a) > sum.at(b); });
  return names;
}

FigureTable tally_table(FigureTable made, Sets sets, const std::function<Tally(const DatasetStatistics&)>& tally_of,
                        bool with_share) {
  for (const auto& name : names_in(sets, tally_of)) {
    add_row(made, sets, name, [&](const DatasetStatistics& set) {
      const int count = count_in(tally_of(set), name);
      const bool share = with_share && set.tasks > 0;
      return count_text(count) + (share ? " (" + percent_text(static_cast<double>(count) / set.tasks) + ")" : "");
    });
  }
  return made;
}

FigureTable overview(Sets sets) {
  auto made = table("overview", "Overview", "", "", sets, "");
  add_row(made, sets, "tasks", [](const auto& set) { return count_text(set.tasks); });
  add_row(made, sets, "homes", [](const auto& set) { return count_text(set.homes); });
  add_row(made, sets, "templates", [](const auto& set) { return count_text(static_cast<int>(set.templates.size())); });
  add_row(made, sets, "demonstrations", [](const auto& set) {
    int count = 0;
    for (const auto& [mode, lengths] : set.plan_lengths) count += lengths.total();
    return count_text(count);
  });
  add_row(made, sets, "candidates", [](const auto& set) { return count_text(set.candidates()); });
  add_row(made, sets, "yield", [](const auto& set) {
    return set.candidates() == 0 ? "" : percent_text(static_cast<double>(set.tasks) / set.candidates());
  });
  return made;
}

FigureTable by_simulator_and_split(Sets sets) {
  std::set<std::string> simulators, splits;
  for (const auto& set : sets) {
    for (const auto& [key, count] : set.by_simulator_and_split) simulators.insert(key.first), splits.insert(key.second);
  }
  const auto count = [](const DatasetStatistics& set, const std::string& simulator, const std::string& split) {
    int sum = 0;
    for (const auto& [key, tasks] : set.by_simulator_and_split) {
      if ((simulator.empty() || key.first == simulator) && (split.empty() || key.second == split)) sum += tasks;
    }
    return count_text(sum);
  };
  FigureTable made{"tasks", "Tasks by simulator and split", "", {"simulator"}, {}};
  simulators.insert("");  // all of them, last
  splits.insert("");
  const auto ordered = [](const std::set<std::string>& names) {
    std::vector<std::string> all(std::next(names.begin()), names.end());
    all.emplace_back();
    return all;
  };
  if (sets.size() == 1) {
    for (const auto& split : ordered(splits)) made.columns.push_back(split.empty() ? "all" : split);
    for (const auto& simulator : ordered(simulators)) {
      std::vector<std::string> row{simulator.empty() ? "all" : simulator};
      for (const auto& split : ordered(splits)) row.push_back(count(sets.front(), simulator, split));
      made.rows.push_back(std::move(row));
    }
    return made;
  }
  made.columns = {"simulator, split"};
  for (const auto& set : sets) made.columns.push_back(set.name);
  for (const auto& simulator : ordered(simulators)) {
    for (const auto& split : ordered(splits))
      add_row(made, sets, (simulator.empty() ? "all" : simulator) + ", " + (split.empty() ? "all" : split),
              [&](const auto& set) { return count(set, simulator, split); });
  }
  return made;
}

void add_histogram(FigureTable& made, Sets sets, const std::string& name,
                   const std::function<Histogram(const DatasetStatistics&)>& of) {
  const auto row = [&](const std::string& what, const std::function<std::string(const Histogram&)>& value) {
    add_row(made, sets, name + ", " + what, [&](const auto& set) {
      const Histogram histogram = of(set);
      return histogram.counts.empty() ? "" : value(histogram);
    });
  };
  row("mean", [](const auto& all) { return decimal_text(all.mean()); });
  row("median", [](const auto& all) { return decimal_text(all.median()); });
  row("least", [](const auto& all) { return count_text(all.least()); });
  row("most", [](const auto& all) { return count_text(all.most()); });
}

FigureTable instructions(Sets sets) {
  auto made = table("instructions", "Instructions", "", "", sets, "");
  add_histogram(made, sets, "words", [](const auto& set) { return set.instruction_words; });
  add_row(made, sets, "distinct words", [](const auto& set) { return count_text(set.distinct_words); });
  return made;
}

std::set<std::string> modes_of(Sets sets) {
  std::set<std::string> modes;
  for (const auto& set : sets) {
    for (const auto& [mode, lengths] : set.plan_lengths) modes.insert(mode);
  }
  return modes;
}

FigureTable plan_lengths(Sets sets) {
  auto made = table("plan-lengths", "Plan lengths", "Number of actions per demonstration, including the final stop.",
                    "mode", sets, "actions");
  for (const auto& mode : modes_of(sets)) {
    add_histogram(made, sets, mode, [&](const auto& set) {
      const auto found = set.plan_lengths.find(mode);
      return found == set.plan_lengths.end() ? Histogram() : found->second;
    });
    add_row(made, sets, mode + ", failed steps", [&](const auto& set) {
      const auto found = set.failed_steps.find(mode);
      return found == set.failed_steps.end() ? "" : count_text(found->second);
    });
  }
  return made;
}

FigureTable actions(Sets sets) {
  auto made = table("actions", "Actions", "Number of occurrences in all demonstrations of a mode.", "mode, action",
                    sets, "times");
  for (const auto& mode : modes_of(sets)) {
    const auto of = [&](const DatasetStatistics& set) {
      const auto found = set.actions.find(mode);
      return found == set.actions.end() ? Tally() : found->second;
    };
    for (const auto& name : names_in(sets, of))
      add_row(made, sets, mode + ", " + name, [&](const auto& set) { return count_text(count_in(of(set), name)); });
  }
  return made;
}

Tally causes_of(const DatasetStatistics& set) {
  Tally causes;
  for (const FunnelRow& row : set.funnel) {
    for (const auto& [cause, count] : row.causes) causes[cause] += count;
  }
  return causes;
}

FigureTable causes(Sets sets) {
  auto made = table("causes", "Results of the candidates", "", "stage: reason", sets, "candidates");
  add_row(made, sets, "became a task", [](const auto& set) { return count_text(set.tasks); });
  return tally_table(std::move(made), sets, causes_of, false);
}

FigureTable funnel(Sets sets) {
  std::set<std::string> names;
  for (const auto& set : sets) {
    for (const FunnelRow& row : set.funnel) names.insert(row.template_name);
  }
  auto made = table("funnel", "Candidates by template", "Number of tasks per number of candidates.", "template", sets,
                    "tasks of candidates");
  if (sets.size() == 1) made.columns.emplace_back("reasons for rejections");
  for (const auto& name : names) {
    const FunnelRow* found = nullptr;
    add_row(made, sets, name, [&](const DatasetStatistics& set) {
      const auto row = std::find_if(set.funnel.begin(), set.funnel.end(),
                                    [&](const FunnelRow& one) { return one.template_name == name; });
      if (row == set.funnel.end()) return std::string("–");
      found = &*row;
      return count_text(row->accepted) + " of " + count_text(row->candidates());
    });
    if (sets.size() != 1) continue;
    std::vector<std::string> reasons;
    for (const auto& [cause, count] : found->causes) reasons.push_back(cause + " (" + count_text(count) + ")");
    made.rows.back().push_back(join(reasons, ", "));
  }
  return made;
}

FigureTable coverage(Sets sets) {
  auto made = table("categories", "Categories covered", "Handled: bound in some task. Known: in the knowledge base.",
                    "simulator", sets, "handled, in homes, known");
  std::set<std::string> simulators;
  for (const auto& set : sets) {
    for (const auto& one : set.coverage) simulators.insert(one.simulator);
  }
  for (const auto& simulator : simulators) {
    add_row(made, sets, simulator, [&](const DatasetStatistics& set) {
      for (const auto& one : set.coverage) {
        if (one.simulator == simulator)
          return count_text(one.handled) + " handled, " + count_text(one.in_homes) + " in homes, of " +
                 count_text(one.known);
      }
      return std::string("–");
    });
  }
  return made;
}

FigureTable things(Sets sets) {
  auto made = table("things", "Things of goals",
                    "Objects that the demonstrations in M1 act on and that the goal names: how many were in the home "
                    "before its start was made, and how many where they are. Movable categories that goals name, and "
                    "which is named most; of the 30 commonest in the homes, those that no goal names.",
                    "simulator", sets, "");
  std::set<std::string> simulators;
  for (const auto& set : sets) {
    for (const auto& one : set.things) simulators.insert(one.simulator);
  }
  const auto row = [&](const std::string& simulator, const std::string& what,
                       const std::function<std::string(const GoalThings&)>& value) {
    add_row(made, sets, simulator + ", " + what, [&](const DatasetStatistics& set) {
      for (const auto& one : set.things) {
        if (one.simulator == simulator) return value(one);
      }
      return std::string("–");
    });
  };
  const auto share = [](int part, int all) {
    return all == 0 ? std::string("–") : percent_text(static_cast<double>(part) / all);
  };
  for (const auto& simulator : simulators) {
    row(simulator, "objects", [](const auto& one) { return count_text(one.objects); });
    row(simulator, "in the home before", [&](const auto& one) { return share(one.objects - one.added, one.objects); });
    row(simulator, "where they were",
        [&](const auto& one) { return share(one.objects - one.added - one.moved, one.objects); });
    row(simulator, "movable categories", [](const auto& one) {
      return count_text(static_cast<int>(one.categories.size())) + " of " + count_text(one.movable);
    });
    row(simulator, "named most", [&](const auto& one) {
      const auto name = one.most_named();
      return name.empty() ? std::string("–") : share(one.categories.at(name), one.tasks) + ", " + name;
    });
    row(simulator, "common in homes, in no goal",
        [](const auto& one) { return one.common_unused.empty() ? std::string("0") : join(one.common_unused, ", "); });
  }
  return made;
}

FigureTable homes(Sets sets) {
  auto made = table("homes", "Homes", "Each home at the start of its first task.", "", sets, "");
  add_row(made, sets, "homes", [](const auto& set) { return count_text(set.homes); });
  add_histogram(made, sets, "rooms", [](const auto& set) { return set.rooms; });
  add_histogram(made, sets, "objects", [](const auto& set) { return set.objects; });
  return made;
}

FigureTable balance(Sets sets) {
  constexpr const char* kNote =
      "Number of values, and effective number of values: 1 / sum of squared shares, and exp of "
      "the entropy.";
  auto made = table("balance", "Balance", kNote, "dimension", sets, "values");
  if (sets.size() == 1) made.columns = {"dimension", "values", "effective", "by entropy", "variation", "most frequent"};
  std::set<std::string> dimensions;
  for (const auto& set : sets) {
    for (const Evenness& even : set.evenness) dimensions.insert(even.dimension);
  }
  for (const auto& dimension : dimensions) {
    const auto of = [&](const DatasetStatistics& set) -> const Evenness* {
      for (const Evenness& even : set.evenness) {
        if (even.dimension == dimension) return &even;
      }
      return nullptr;
    };
    if (sets.size() == 1) {
      const Evenness& even = *of(sets.front());
      const auto most = std::max_element(even.tasks.begin(), even.tasks.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      made.rows.push_back({dimension, count_text(static_cast<int>(even.tasks.size())), decimal_text(even.effective),
                           decimal_text(even.by_entropy), number_text(std::round(even.variation * 100) / 100),
                           most->first + " (" + count_text(most->second) + ")"});
      continue;
    }
    add_row(made, sets, dimension, [&](const DatasetStatistics& set) {
      const Evenness* even = of(set);
      return even == nullptr
                 ? std::string("–")
                 : decimal_text(even->effective) + " of " + count_text(static_cast<int>(even->tasks.size()));
    });
  }
  return made;
}

}  // namespace

std::vector<FigureTable> tables_of(Sets sets) {
  std::vector<FigureTable> all{overview(sets), by_simulator_and_split(sets)};
  all.push_back(tally_table(
      table("purposes", "Purposes", "What the tasks are for.", "purpose", sets, "tasks"), sets,
      [](const auto& set) { return set.purposes; }, true));
  all.push_back(instructions(sets));
  all.push_back(tally_table(
      table("words", "Most frequent words", "Without function words such as \"a\" and \"the\".", "word", sets, "times"),
      sets, [](const auto& set) { return set.words; }, false));
  all.push_back(tally_table(
      table("styles", "Styles of instructions", "", "style", sets, "tasks"), sets,
      [](const auto& set) { return set.styles; }, true));
  all.push_back(tally_table(
      table("phenomena", "Phenomena of language", "A text may show several.", "phenomenon", sets, "tasks"), sets,
      [](const auto& set) { return set.phenomena; }, true));
  all.push_back(tally_table(
      table("operators", "Operators", "Number of tasks whose goal contains it.", "operator", sets, "tasks"), sets,
      [](const auto& set) { return set.operators; }, true));
  all.push_back(tally_table(
      table("predicates", "Predicates", "Number of tasks whose goal contains it.", "predicate", sets, "tasks"), sets,
      [](const auto& set) { return set.predicates; }, true));
  all.push_back(tally_table(
      table("alternatives", "Goals by function and kind",
            "Parts of goals for which any of several categories serves, by what these are called.", "phrase", sets,
            "tasks"),
      sets, [](const auto& set) { return set.alternatives; }, true));
  all.push_back(tally_table(
      table("kinds", "Kinds of these", "The same parts of goals by the kinds of what serves.", "kinds", sets, "tasks"),
      sets, [](const auto& set) { return set.kinds_asked_for; }, true));
  for (auto make : {plan_lengths, actions, causes, funnel, coverage, things, homes, balance}) all.push_back(make(sets));
  return all;
}

}  // namespace unietp
