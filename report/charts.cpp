#include "report/charts.h"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "report/figure_table.h"

namespace unietp {
namespace {

constexpr std::size_t kMostBars = 24;

std::string in_words(std::string name) { return replace_all(std::move(name), "_", " "); }

BarChart bars(std::string id, std::string title, std::string note, std::string table) {
  BarChart chart;
  chart.id = std::move(id);
  chart.title = std::move(title);
  chart.note = std::move(note);
  chart.table = std::move(table);
  return chart;
}

/// The most frequent names of a tally, longest bar first.
BarChart ranked(BarChart chart, const Tally& tally, std::string measure) {
  std::vector<std::pair<std::string, int>> most(tally.begin(), tally.end());
  std::stable_sort(most.begin(), most.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  if (most.size() > kMostBars) {
    chart.note += (chart.note.empty() ? "" : " ") + std::string("The ") + std::to_string(kMostBars) +
                  " most frequent of " + count_text(static_cast<int>(most.size())) + ".";
    most.resize(kMostBars);
  }
  chart.horizontal = true;
  chart.series = {{measure, {}}};
  for (const auto& [name, count] : most) {
    chart.labels.push_back(in_words(name));
    chart.series[0].values.push_back(count);
  }
  chart.measure = std::move(measure);
  return chart;
}

/// Histograms on common bins, a series each.
BarChart binned(BarChart chart, const std::vector<std::pair<std::string, Histogram>>& histograms, std::string axis,
                std::string measure) {
  int least = 0, most = 0;
  bool first = true;
  for (const auto& [name, histogram] : histograms) {
    if (histogram.counts.empty()) continue;
    least = first ? histogram.least() : std::min(least, histogram.least());
    most = first ? histogram.most() : std::max(most, histogram.most());
    first = false;
  }
  constexpr int kMostBins = 24;
  int width = 1;
  for (const int step : {2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
    if ((most - least) / width + 1 > kMostBins) width = step;
  }
  const int from = least / width * width;
  const int number = (most - from) / width + 1;
  const auto bins = static_cast<std::size_t>(number);
  for (std::size_t i = 0; i < bins; ++i) {
    const int low = from + static_cast<int>(i) * width;
    chart.labels.push_back(width == 1 ? std::to_string(low)
                                      : std::to_string(low) + "–" + std::to_string(low + width - 1));
  }
  for (const auto& [name, histogram] : histograms) {
    BarChart::Series series{name, std::vector<double>(bins)};
    for (const auto& [value, count] : histogram.counts)
      series.values[static_cast<std::size_t>((value - from) / width)] += count;
    chart.series.push_back(std::move(series));
  }
  chart.axis = std::move(axis);
  chart.measure = std::move(measure);
  return chart;
}

BarChart tasks_chart(const DatasetStatistics& set) {
  auto chart = bars("tasks", "Tasks by simulator and split", "", "tasks");
  std::set<std::string> simulators, splits;
  for (const auto& [key, count] : set.by_simulator_and_split) simulators.insert(key.first), splits.insert(key.second);
  chart.labels.assign(simulators.begin(), simulators.end());
  for (const auto& split : splits) {
    BarChart::Series series{in_words(split), {}};
    for (const auto& simulator : simulators) {
      const auto found = set.by_simulator_and_split.find({simulator, split});
      series.values.push_back(found == set.by_simulator_and_split.end() ? 0 : found->second);
    }
    chart.series.push_back(std::move(series));
  }
  chart.stacked = true;
  chart.measure = "tasks";
  return chart;
}

BarChart actions_chart(const DatasetStatistics& set) {
  Tally sum;
  for (const auto& [mode, actions] : set.actions) {
    for (const auto& [name, count] : actions) sum[name] += count;
  }
  auto chart = ranked(bars("actions", "Actions", "Number of occurrences in all demonstrations of a mode.", "actions"),
                      sum, "times");
  std::vector<std::string> names;
  for (const auto& [name, count] : sum) names.push_back(name);
  chart.series.clear();
  for (const auto& [mode, actions] : set.actions) {
    BarChart::Series series{mode, {}};
    for (const auto& label : chart.labels) {
      double times = 0;
      for (const auto& [name, count] : actions) times += in_words(name) == label ? count : 0;
      series.values.push_back(times);
    }
    chart.series.push_back(std::move(series));
  }
  chart.stacked = chart.wide = true;
  return chart;
}

BarChart causes_chart(const DatasetStatistics& set) {
  Tally causes;
  for (const FunnelRow& row : set.funnel) {
    for (const auto& [cause, count] : row.causes) causes[cause] += count;
  }
  auto chart =
      ranked(bars("causes", "Reasons for rejections",
                  count_text(set.candidates()) + " candidates, " + count_text(set.tasks) + " became tasks.", "causes"),
             causes, "candidates");
  chart.wide = true;
  return chart;
}

/// The templates with the most rejected candidates: accepted ones, and the stage that rejected the others.
BarChart funnel_chart(const DatasetStatistics& set) {
  std::vector<const FunnelRow*> rows;
  for (const FunnelRow& row : set.funnel) rows.push_back(&row);
  const auto lost = [](const FunnelRow* row) { return row->candidates() - row->accepted; };
  std::erase_if(rows, [&](const auto* row) { return lost(row) == 0; });
  std::stable_sort(rows.begin(), rows.end(), [&](const auto* a, const auto* b) { return lost(a) > lost(b); });
  const std::size_t losing = rows.size();
  rows.resize(std::min(rows.size(), kMostBars));
  auto chart =
      bars("funnel", "Templates with the most rejected candidates",
           "The first " + std::to_string(rows.size()) + " of " + std::to_string(losing) + " with rejected candidates.",
           "funnel");
  std::vector<std::string> stages;
  for (const FunnelRow* row : rows) {
    for (const auto& [cause, count] : row->causes) {
      const auto stage = cause.substr(0, cause.find(':'));
      if (std::find(stages.begin(), stages.end(), stage) == stages.end()) stages.push_back(stage);
    }
  }
  std::sort(stages.begin(), stages.end());
  chart.series.push_back({"became a task", {}});
  for (const auto& stage : stages) chart.series.push_back({"rejected by the " + stage, {}});
  for (const FunnelRow* row : rows) {
    chart.labels.push_back(row->template_name);
    chart.series[0].values.push_back(row->accepted);
    for (std::size_t i = 0; i < stages.size(); ++i) {
      double given_up = 0;
      for (const auto& [cause, count] : row->causes) given_up += cause.starts_with(stages[i] + ":") ? count : 0;
      chart.series[i + 1].values.push_back(given_up);
    }
  }
  chart.horizontal = chart.stacked = chart.wide = true;
  chart.measure = "candidates";
  return chart;
}

BarChart coverage_chart(const DatasetStatistics& set) {
  auto chart =
      bars("categories", "Categories covered",
           "Handled: bound in some task. In homes only: present in some home. Known only: in no home.", "categories");
  chart.series = {{"handled", {}}, {"in homes only", {}}, {"known only", {}}};
  for (const auto& one : set.coverage) {
    chart.labels.push_back(one.simulator);
    chart.series[0].values.push_back(one.handled);
    chart.series[1].values.push_back(one.in_homes - one.handled);
    chart.series[2].values.push_back(one.known - one.in_homes);
  }
  chart.stacked = chart.wide = true;
  chart.measure = "categories";
  return chart;
}

BarChart balance_chart(const DatasetStatistics& set) {
  auto chart = bars("balance", "Balance", "Effective number of values: 1 / sum of squared shares.", "balance");
  chart.series = {{"effective number", {}}, {"number of values", {}}};
  for (const Evenness& even : set.evenness) {
    chart.labels.push_back(even.dimension);
    chart.series[0].values.push_back(even.effective);
    chart.series[1].values.push_back(static_cast<double>(even.tasks.size()));
  }
  chart.measure = "values";
  return chart;
}

}  // namespace

std::vector<ChartSection> chart_sections(const DatasetStatistics& set) {
  std::vector<std::pair<std::string, Histogram>> lengths(set.plan_lengths.begin(), set.plan_lengths.end());
  auto words = ranked(bars("words", "Most frequent words", "Without function words such as “a” and “the”.", "words"),
                      set.words, "times");
  auto plans = binned(bars("plan-lengths", "Plan lengths",
                           "Number of actions per demonstration, including the final stop.", "plan-lengths"),
                      lengths, "actions", "demonstrations");
  plans.wide = true;
  return {
      {"tasks-section",
       "Tasks",
       "The contents of the data set, and how evenly the tasks are distributed.",
       {tasks_chart(set), balance_chart(set)}},
      {"instructions-section",
       "Instructions",
       "Lengths, words, styles and phenomena of the instructions.",
       {binned(bars("lengths", "Lengths of instructions", "", "instructions"),
               {{"instructions", set.instruction_words}}, "words", "tasks"),
        ranked(bars("styles", "Styles", "", "styles"), set.styles, "tasks"),
        ranked(bars("phenomena", "Phenomena of language", "A text may show several.", "phenomena"), set.phenomena,
               "tasks"),
        std::move(words), ranked(bars("templates", "Most frequent templates", "", "funnel"), set.templates, "tasks")}},
      {"goals-section",
       "Goals",
       "Operators and predicates of the goal formulas; each goal counts once.",
       {ranked(bars("operators", "Operators", "", "operators"), set.operators, "tasks"),
        ranked(bars("predicates", "Predicates", "", "predicates"), set.predicates, "tasks")}},
      {"plans-section",
       "Plans",
       "Lengths and actions of the demonstrations, by mode.",
       {std::move(plans), actions_chart(set)}},
      {"funnel-section",
       "Results of the candidates",
       "A candidate that fails at any stage is rejected with a reason.",
       {causes_chart(set), funnel_chart(set)}},
      {"homes-section",
       "Homes and categories",
       "Each home at the start of its first task.",
       {binned(bars("rooms", "Rooms per home", "", "homes"), {{"homes", set.rooms}}, "rooms", "homes"),
        binned(bars("objects", "Objects per home", "", "homes"), {{"homes", set.objects}}, "objects", "homes"),
        coverage_chart(set)}}};
}

nlohmann::ordered_json to_json(const BarChart& chart) {
  auto series = nlohmann::ordered_json::array();
  for (const auto& one : chart.series) series.push_back({{"name", one.name}, {"values", one.values}});
  return {{"id", chart.id},          {"labels", chart.labels},   {"series", std::move(series)},
          {"axis", chart.axis},      {"measure", chart.measure}, {"horizontal", chart.horizontal},
          {"stacked", chart.stacked}};
}

int height_of(const BarChart& chart) {
  constexpr int kUpright = 300, kBar = 23, kFrame = 80;
  return chart.horizontal ? kFrame + kBar * std::max(3, static_cast<int>(chart.labels.size())) : kUpright;
}

}  // namespace unietp
