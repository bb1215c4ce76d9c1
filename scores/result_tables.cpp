#include "scores/result_tables.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "core/text.h"
#include "scene/simulator.h"
#include "scene/simulator_info.h"
#include "scores/failure_class.h"
#include "scores/figures.h"
#include "scores/table_cells.h"

namespace unietp {
namespace {

constexpr std::array kSplitColumns{SplitColumn{"atomic", "At."}, SplitColumn{"compositional", "Co."},
                                   SplitColumn{"logical", "Lo."}, SplitColumn{"instance_grounding", "In."},
                                   SplitColumn{"linguistic", "Li."}};
constexpr const char* kRates = "Success rates in percent, each with its 95 % interval.";

/// The runs with what all tables need.
struct Shown {
  std::span<const ScoredRun> runs;
  std::vector<std::string> labels;
  std::string conditions;

  bool has(Mode mode) const {
    return std::any_of(runs.begin(), runs.end(), [&](const ScoredRun& run) {
      const auto modes = modes_of(run);
      return std::find(modes.begin(), modes.end(), mode) != modes.end();
    });
  }
  std::vector<Mode> modes(std::initializer_list<Mode> wanted) const {
    std::vector<Mode> found;
    for (const Mode mode : wanted) {
      if (has(mode)) found.push_back(mode);
    }
    return found;
  }
};

/// A column of success rates: its head and which episodes it counts.
struct RateColumn {
  std::string head;
  std::vector<Condition> filter;
};

bool keeps(const EpisodeScore& one, const Condition& condition) {
  const auto& [field, value] = condition;
  if (field == "mode") return name_of(one.key.mode) == value;
  if (field == "split") return one.split == value;
  if (field == "simulator") return one.simulator == value;
  return one.held_out == (value == "yes");  // "held_out"
}

ResultCell rate_cell(const Shown& shown, std::size_t run, Mode mode, const RateColumn& column) {
  auto filter = column.filter;
  filter.insert(filter.begin(), {"mode", std::string(name_of(mode))});
  const auto episodes = episodes_where(shown.runs[run], [&](const EpisodeScore& one) {
    return std::all_of(filter.begin(), filter.end(), [&](const auto& condition) { return keeps(one, condition); });
  });
  ResultCell cell = success_cell(figures_of(episodes, is_repeated(shown.runs[run])));
  if (!episodes.empty()) cell.filter = filter_text(run, filter);
  return cell;
}

/// Runs in rows; for each mode the same columns of success rates.
ResultTable rate_table(const Shown& shown, std::string id, std::string title, const std::vector<Mode>& modes,
                       const std::vector<RateColumn>& columns) {
  ResultTable table{std::move(id), std::move(title), shown.conditions + " " + kRates, {{"", 1}}, {""}, {}};
  for (const Mode mode : modes) {
    table.groups.push_back({std::string(name_of(mode)), columns.size()});
    for (const RateColumn& column : columns) table.columns.push_back(column.head);
  }
  for (std::size_t run = 0; run < shown.runs.size(); ++run) {
    std::vector<ResultCell> row{{shown.labels[run], "", "", false}};
    for (const Mode mode : modes) {
      for (const RateColumn& column : columns) row.push_back(rate_cell(shown, run, mode, column));
    }
    table.rows.push_back(std::move(row));
  }
  mark_best(table, 1);
  return table;
}

std::vector<RateColumn> columns_by_split() {
  std::vector<RateColumn> columns;
  for (const auto& [split, head] : kSplitColumns)
    columns.push_back({std::string(head), {{"split", std::string(split)}}});
  columns.push_back({"Avg.", {}});
  return columns;
}

std::vector<RateColumn> columns_by_simulator() {
  std::vector<RateColumn> columns;
  for (const Simulator simulator : kSimulators)
    columns.push_back({std::string(info(simulator).title), {{"simulator", std::string(name_of(simulator))}}});
  columns.push_back({"Avg.", {}});
  return columns;
}

std::vector<RateColumn> columns_by_template() {
  std::vector<RateColumn> columns;
  for (const Simulator simulator : kSimulators) {
    const std::string name(name_of(simulator)), title(info(simulator).title);
    columns.push_back({title + " seen", {{"simulator", name}, {"held_out", "no"}}});
    columns.push_back({title + " unseen", {{"simulator", name}, {"held_out", "yes"}}});
  }
  columns.push_back({"Avg.", {}});
  return columns;
}

/// One row for each run, with marks for what the agent is told of its actions.
ResultTable feedback_table(const Shown& shown, const std::vector<Mode>& modes) {
  ResultTable table = rate_table(shown, "feedback", "Feedback on actions", modes, columns_by_split());
  table.note += " Su.: the agent is told whether an action succeeded; Fe.: and why not.";
  table.groups.front().columns = 3;
  table.columns.insert(table.columns.begin() + 1, {"Su.", "Fe."});
  for (std::size_t run = 0; run < shown.runs.size(); ++run) {
    const auto& settings = shown.runs[run].manifest.setup.settings;
    const auto of = settings.find(modes.front());
    const Feedback feedback = of == settings.end() ? Feedback::Full : of->second.feedback;
    const auto mark = [](bool yes) { return ResultCell{yes ? "✓" : "✗", "", "", false}; };
    table.rows[run].insert(table.rows[run].begin() + 1,
                           {mark(feedback != Feedback::None), mark(feedback == Feedback::Full)});
  }
  return table;
}

ResultTable steps_table(const Shown& shown, Mode mode) {
  const std::string name(name_of(mode));
  ResultTable table{"steps-" + name,
                    "Steps of episodes in " + name,
                    shown.conditions + " Episodes by their number of steps, and how many of them succeeded.",
                    {{"", 1}},
                    {"Steps"},
                    {}};
  for (std::size_t run = 0; run < shown.runs.size(); ++run) {
    table.groups.push_back({shown.runs.size() == 1 ? "" : shown.labels[run], 3});
    table.columns.insert(table.columns.end(), {"Episodes", "Successes", "Success rate"});
    const auto& settings = shown.runs[run].manifest.setup.settings;
    const auto of = settings.find(mode);
    const int limit = of == settings.end() ? 50 : of->second.rules.limits.steps;
    const auto ranges = step_ranges(
        episodes_where(shown.runs[run], [&](const EpisodeScore& one) { return one.key.mode == mode; }), limit);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const StepRange& range = ranges[i];
      const std::string steps = std::to_string(range.first) + "–" + std::to_string(range.last);
      if (table.rows.size() <= i) table.rows.push_back({{steps, "", "", false}});
      const Condition in_range{"steps", std::to_string(range.first) + "-" + std::to_string(range.last)};
      const std::string filter = filter_text(run, {{"mode", name}, in_range});
      const std::string succeeded = filter_text(run, {{"mode", name}, in_range, {"success", "true"}});
      table.rows[i].push_back({std::to_string(range.episodes), "", range.episodes > 0 ? filter : "", false});
      table.rows[i].push_back({std::to_string(range.successes), "", range.successes > 0 ? succeeded : "", false});
      table.rows[i].push_back({share_text(range.successes, range.episodes), "", "", false});
    }
  }
  return table;
}

/// Classes in rows, in the order of the rules; splits in columns, for each run and mode.
ResultTable failure_table(const Shown& shown) {
  ResultTable table{"failures",
                    "Why episodes did not succeed",
                    shown.conditions + " Episodes by the first class of failure that fits (docs/results.md).",
                    {{"", 1}},
                    {"Class"},
                    {}};
  std::set<std::pair<FailureGroup, std::string>> classes;
  for (const ScoredRun& run : shown.runs) {
    for (const EpisodeScore& one : run.scores) {
      if (one.classes.empty()) continue;
      if (const auto failure = failure_class_of(one.classes.front())) classes.insert({failure->group, failure->kind});
    }
  }
  for (const auto& [group, kind] : classes) table.rows.push_back({{to_text(FailureClass{group, kind}), "", "", false}});
  for (std::size_t run = 0; run < shown.runs.size(); ++run) {
    for (const Mode mode : modes_of(shown.runs[run])) {
      const std::string name(name_of(mode));
      const auto columns = columns_by_split();
      table.groups.push_back({shown.runs.size() == 1 ? name : shown.labels[run] + " " + name, columns.size()});
      for (const RateColumn& column : columns) {
        table.columns.push_back(column.filter.empty() ? "All" : column.head);
        for (auto& row : table.rows) {
          const std::string wanted = row.front().text;
          const auto count = episodes_where(shown.runs[run], [&](const EpisodeScore& one) {
                               return one.key.mode == mode && !one.classes.empty() && one.classes.front() == wanted &&
                                      (column.filter.empty() || keeps(one, column.filter.front()));
                             }).size();
          auto filter = column.filter;
          filter.insert(filter.begin(), {{"mode", name}, {"class", wanted}});
          row.push_back({std::to_string(count), "", count > 0 ? filter_text(run, filter) : "", false});
        }
      }
    }
  }
  return table;
}

/// What a table says of the episodes of a run in a mode.
struct Said {
  std::string text;
  std::optional<std::vector<Condition>> of = {};  // beside the mode, which episodes it counts; none: no count of them
};
/// A share of episodes or of their actions: what it counts, and where to find it.
Said share_said(int count, int all, std::vector<Condition> of) {
  return {share_text(count, all), count > 0 ? std::optional(std::move(of)) : std::nullopt};
}

/// Rows of runs and modes.
template <class Row>
ResultTable table_by_mode(const Shown& shown, ResultTable table, const Row& cells_of) {
  for (std::size_t run = 0; run < shown.runs.size(); ++run) {
    for (const Mode mode : modes_of(shown.runs[run])) {
      const auto episodes = episodes_where(shown.runs[run], [&](const auto& one) { return one.key.mode == mode; });
      auto cells = cells_of(shown.runs[run], mode, episodes);
      if (cells.empty()) continue;
      const auto filter = [&](std::vector<Condition> of) {
        of.insert(of.begin(), {"mode", std::string(name_of(mode))});
        return filter_text(run, of);
      };
      std::vector<ResultCell> row{{shown.labels[run], "", "", false},
                                  {std::string(name_of(mode)), "", filter({}), false}};
      for (Said& cell : cells)
        row.push_back({std::move(cell.text), "", cell.of ? filter(std::move(*cell.of)) : "", false});
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

ResultTable behavior_table(const Shown& shown) {
  ResultTable table{
      "behaviour",
      "What the agent did",
      shown.conditions +
          " Shares in percent: of finished episodes, or of actions. Efficiency: steps of the shortest known "
          "plan by steps taken, over successes.",
      {{"", 2}, {"Success", 3}, {"Means", 4}, {"Stops", 3}, {"Actions that are none", 4}},
      {"", "Mode", "Episodes", "Success rate", "with stop", "Progress", "Steps", "Failures", "Efficiency", "Wrong",
       "Premature", "Missed", "No JSON", "Unknown", "Argument", "Truncated"},
      {}};
  return table_by_mode(shown, std::move(table), [](const ScoredRun& run, Mode, const Episodes& episodes) {
    const Figures f = figures_of(episodes, is_repeated(run));
    const auto of_episodes = [&](int count, std::vector<Condition> of) {
      return share_said(count, f.finished(), std::move(of));
    };
    const auto of_actions = [&](int count, const char* mark) { return share_said(count, f.actions, {{"mark", mark}}); };
    return std::vector<Said>{{std::to_string(f.episodes), std::vector<Condition>()},
                             of_episodes(f.successes, {{"success", "true"}}),
                             of_episodes(f.stopped_successes, {{"success", "true"}, {"end", "stop"}}),
                             {fixed_text(100 * f.progress, 1)},
                             {fixed_text(f.steps, 1)},
                             {fixed_text(f.failures, 1)},
                             {f.with_plan == 0 ? "–" : fixed_text(f.efficiency, 2)},
                             of_episodes(f.wrong_stops, {{"success", "false"}, {"end", "stop"}}),
                             of_episodes(f.premature_stops, {{"mark", "premature_stop"}}),
                             of_episodes(f.missed_stops, {{"mark", "missed_stop"}}),
                             of_actions(f.no_json, "no_json"),
                             of_actions(f.unknown_action, "unknown_action"),
                             of_actions(f.bad_argument, "bad_argument"),
                             of_actions(f.truncated, "truncated")};
  });
}

ResultTable box_table(const Shown& shown) {
  ResultTable table{
      "boxes",
      "Things named by boxes",
      shown.conditions +
          " A box hits when it overlaps a thing in the picture by more than 0.1 (intersection over union). "
          "Overlap: mean over the hits.",
      {{"", 5}},
      {"", "Mode", "Boxes", "Hit rate", "Overlap"},
      {}};
  return table_by_mode(shown, std::move(table), [](const ScoredRun&, Mode, const Episodes& episodes) {
    const Figures f = figures_of(episodes, false);
    if (f.boxes == 0) return std::vector<Said>{};
    return std::vector<Said>{{std::to_string(f.boxes), std::vector<Condition>{{"mark", "box"}}},
                             share_said(f.hits, f.boxes, {{"mark", "hit"}}),
                             {f.hits == 0 ? "–" : fixed_text(f.overlap, 2)}};
  });
}

ResultTable cost_table(const Shown& shown) {
  ResultTable table{"cost",
                    "Tokens, cost and time",
                    shown.conditions + " Cost by the prices of the manifest. Time of a reply in seconds, with retries.",
                    {{"", 2}, {"Tokens", 3}, {"Cost", 2}, {"Time of a reply", 3}},
                    {"", "Mode", "Prompts", "Replies", "per episode", "all", "per success", "Mean", "Median", "95 %"},
                    {}};
  return table_by_mode(shown, std::move(table), [](const ScoredRun& run, Mode mode, const Episodes& episodes) {
    const Figures f = figures_of(episodes, false);
    const auto latency = run.latency.find(mode);
    const bool timed = latency != run.latency.end();
    if (f.prompt_tokens + f.completion_tokens == 0 && f.cost == 0 && !timed) return std::vector<Said>{};
    const auto tokens = static_cast<double>(f.prompt_tokens + f.completion_tokens);
    const auto seconds = [&](double value) { return Said{timed ? fixed_text(value, 2) : "–"}; };
    return std::vector<Said>{{std::to_string(f.prompt_tokens)},
                             {std::to_string(f.completion_tokens)},
                             {f.finished() == 0 ? "–" : fixed_text(tokens / f.finished(), 0)},
                             {fixed_text(f.cost, 4)},
                             {f.successes == 0 ? "–" : fixed_text(f.cost / f.successes, 4)},
                             seconds(timed ? latency->second.mean : 0),
                             seconds(timed ? latency->second.median : 0),
                             seconds(timed ? latency->second.percentile_95 : 0)};
  });
}

ResultTable repeat_table(const Shown& shown) {
  ResultTable table{"repeats",
                    "Repeats",
                    shown.conditions + " pass@k: one of k repeats succeeds; pass^k: all of them do; in percent.",
                    {{"", 5}},
                    {"", "k", "Tasks", "pass@k", "pass^k"},
                    {}};
  for (std::size_t run = 0; run < shown.runs.size(); ++run) {
    if (!is_repeated(shown.runs[run])) continue;
    for (const Mode mode : modes_of(shown.runs[run])) {
      const std::string filter = filter_text(run, {{"mode", std::string(name_of(mode))}});
      for (const PassFigures& one :
           pass_figures(episodes_where(shown.runs[run], [&](const auto& score) { return score.key.mode == mode; }))) {
        table.rows.push_back({{shown.labels[run] + " " + std::string(name_of(mode)), "", "", false},
                              {std::to_string(one.k), "", "", false},
                              {std::to_string(one.tasks), "", filter, false},
                              {fixed_text(100 * one.at, 1), "", "", false},
                              {fixed_text(100 * one.all, 1), "", "", false}});
      }
    }
  }
  return table;
}

}  // namespace

std::span<const SplitColumn> split_columns() { return kSplitColumns; }

std::vector<ResultTable> result_tables(std::span<const ScoredRun> runs) {
  const Shown shown{runs, labels_of(runs), conditions_of(runs)};
  std::vector<ResultTable> tables;
  const auto known = shown.modes({Mode::M1, Mode::M2}), all = shown.modes({Mode::M1, Mode::M2, Mode::M3});
  if (!known.empty()) tables.push_back(rate_table(shown, "main", "Success by split", known, columns_by_split()));
  if (shown.has(Mode::M3))
    tables.push_back(rate_table(shown, "m3", "Success by split in M3", {Mode::M3}, columns_by_split()));
  if (!all.empty()) {
    tables.push_back(rate_table(shown, "simulators", "Success by simulator", all, columns_by_simulator()));
    tables.push_back(feedback_table(shown, all));
    tables.push_back(
        rate_table(shown, "templates", "Success on templates that training can leave out", all, columns_by_template()));
  }
  for (ResultTable table : {behavior_table(shown), box_table(shown), cost_table(shown), repeat_table(shown)}) {
    if (!table.rows.empty()) tables.push_back(std::move(table));
  }
  for (const Mode mode : all) tables.push_back(steps_table(shown, mode));
  if (ResultTable failures = failure_table(shown); !failures.rows.empty()) tables.push_back(std::move(failures));
  return tables;
}

}  // namespace unietp
