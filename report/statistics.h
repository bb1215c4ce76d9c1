#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "report/data_set.h"
#include "report/task_figures.h"

namespace unietp {

/// How often each integer occurred.
struct Histogram {
  std::map<int, int> counts;
  void add(int value) { ++counts[value]; }  // counts one more
  /// How many integers were added.
  int total() const;
  double mean() const;  // 0 when empty, as those below
  /// Of an even number the mean of the two in the middle.
  double median() const;
  int least() const;
  int most() const;
};

/// The candidates of one template: accepted ones, and causes of rejection.
struct FunnelRow {
  std::string template_name;
  int accepted = 0;
  Tally causes;            // "expert: action-failed" → candidates
  int candidates() const;  // tasks and rejected candidates
};

/// How evenly the tasks are distributed over the values of a dimension.
struct Evenness {
  std::string dimension;
  Tally tasks;            // by value
  double effective = 0;   // 1 / sum of squared shares, as in the manifest
  double by_entropy = 0;  // exp of the entropy: the number of equally frequent values with that entropy
  double variation = 0;   // standard deviation of the counts over their mean
};

/// How many categories of a simulator's knowledge base occur.
struct CategoryCoverage {
  std::string simulator;
  int known = 0;     // categories of the knowledge base
  int handled = 0;   // that some task's template is bound to
  int in_homes = 0;  // that are in some home, handled ones included
};

/// Figures of a finished data set. Counts are of tasks unless stated otherwise.
struct DatasetStatistics {
  std::string name;
  int tasks = 0;
  std::map<std::pair<std::string, std::string>, int> by_simulator_and_split;
  Tally templates, styles, phenomena, writers;
  Tally purposes;               // those of tasks that have one
  Histogram instruction_words;  // words of an instruction
  Tally words;                  // occurrences, lower case; function words (a, the, of, …) are left out
  int distinct_words = 0;       // with function words
  /// Parts of goals for which any of several categories serves, by what these are called: "something to drink from", as
  /// the text says. Sets without such a phrase by their names, with "or" between them.
  Tally alternatives;
  Tally kinds_asked_for;                          // the same by the narrowest kinds of these categories: "cup, glass"
  Tally operators, predicates;                    // tasks whose goal has it; operators by their name in docs/logic.md
  std::map<std::string, Histogram> plan_lengths;  // by mode: actions of a demonstration, `stop` too
  std::map<std::string, Tally> actions;           // by mode: occurrences of each action
  std::map<std::string, int> failed_steps;        // by mode
  std::vector<FunnelRow> funnel;                  // templates with candidates, in order of name
  std::vector<CategoryCoverage> coverage;         // simulators that have tasks, in the order of kSimulators
  std::vector<GoalThings> things;                 // likewise
  int homes = 0;
  Histogram rooms, objects;        // per home, in the start of its first task; movable and fixed objects
  std::vector<Evenness> evenness;  // in order of dimension's name

  int candidates() const;  // of all templates
};

/// Reads the tasks one at a time: apart from the figures, only the name of each home and of its first task stays in
/// memory. Deterministic for any number of threads. `knowledge`: in the order of kSimulators. Errors: Io; Parse and
/// Schema with file and line.
Result<DatasetStatistics> statistics_of_set(const FinishedSet& set, const std::vector<const Knowledge*>& knowledge,
                                            int threads);

/// A category that is common in the homes of a data set and in none of its goals.
struct CommonUnused {
  std::string category;
  std::vector<std::string> templates;  // those that could be about it with a usual goal
  int tasks = 0;                       // of these templates on this simulator, which are about other things
};
/// A movable category that is the only one that some templates can be about, so that goals must name it often.
struct SoleCategory {
  std::string category;
  std::vector<std::string> templates;
  int tasks = 0, named = 0, all = 0;  // of these templates, whose goal names it, and all of the simulator
};
/// Of the categories of a simulator that some usual goal could be about, those that the goals of a data set do not
/// name.
struct UsualCoverage {
  std::string simulator;
  std::size_t usual = 0;             // how many categories there are
  std::vector<std::string> missing;  // sorted
  std::vector<CommonUnused> common;  // of the movable categories commonest in the homes, those that no goal names
  std::vector<SoleCategory> sole;    // sorted by category
};
/// By name of the data set. `unietp-usual-coverage/1`: data/schemas/usual-coverage.schema.json.
std::string usual_coverage_json(const std::vector<std::pair<std::string, std::vector<UsualCoverage>>>& sets);

/// `unietp-statistics/1`: data/schemas/statistics.schema.json.
std::string statistics_json(const std::vector<DatasetStatistics>& sets);

}  // namespace unietp
