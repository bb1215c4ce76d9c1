#include "scores/evaluation_page.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "report/asset.h"
#include "report/charts.h"
#include "report/html.h"
#include "scores/comparison.h"
#include "scores/failure_class.h"
#include "scores/figures.h"
#include "scores/report_pages.h"
#include "scores/result_tables.h"
#include "scores/scores_asset.h"
#include "scores/table_cells.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// Where the episodes of a filter are: in this page, or in the report of their run.
using LinkTo = std::function<std::string(const std::string& filter)>;

std::string link_in_page(const std::string& filter) {
  return "<a href=\"#episodes\" data-filter=\"" + escaped_html(filter) + "\">";
}

std::string cell_html(const ResultCell& cell, bool head, const LinkTo& link_to) {
  std::string text = escaped_html(cell.text);
  const std::string link = cell.filter.empty() ? "" : link_to(cell.filter);
  if (!link.empty()) text = link + text + "</a>";
  if (cell.best) text = "<strong>" + text + "</strong>";
  if (!cell.aside.empty()) text += " <span class=\"aside\">" + escaped_html(cell.aside) + "</span>";
  return head ? "<th scope=\"row\">" + text + "</th>" : "<td class=\"number\">" + text + "</td>";
}

std::string html_of(const ResultTable& table, const LinkTo& link_to) {
  std::string html = "<h3>" + escaped_html(table.title) + "</h3><p class=\"soft small\">" + escaped_html(table.note) +
                     "</p><div class=\"scroll card\" tabindex=\"0\" role=\"region\" aria-label=\"" +
                     escaped_html(table.title) + "\"><table id=\"table-" + escaped_html(table.id) + "\"><thead>";
  const bool grouped =
      std::any_of(table.groups.begin(), table.groups.end(), [](const auto& g) { return !g.name.empty(); });
  if (grouped) {
    html += "<tr>";
    for (const ResultTable::Group& group : table.groups)
      html +=
          "<th class=\"group\" colspan=\"" + std::to_string(group.columns) + "\">" + escaped_html(group.name) + "</th>";
    html += "</tr>";
  }
  html += "<tr>";
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    html += std::string("<th scope=\"col\"") + (i > 0 ? " class=\"number\">" : ">") + escaped_html(table.columns[i]) +
            "</th>";
  html += "</tr></thead><tbody>";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) html += cell_html(row[i], i == 0, link_to);
    html += "</tr>";
  }
  return html + "</tbody></table></div>";
}

std::string top_of(const std::string& title, const std::string& conditions,
                   const std::vector<std::pair<std::string, std::string>>& figures) {
  std::string html =
      "<a class=\"skip\" href=\"#tables\">Skip to the tables</a><header class=\"top\"><div class=\"inner\">"
      "<div class=\"line\"><div><h1>" +
      escaped_html(title) + "</h1><p class=\"soft\">" + escaped_html(conditions) +
      "</p></div><button id=\"theme\" class=\"theme\" type=\"button\">Light/dark</button></div>"
      "<dl class=\"key-figures\">";
  for (const auto& [name, value] : figures)
    html += "<div><dt>" + escaped_html(name) + "</dt><dd>" + escaped_html(value) + "</dd></div>";
  return html + "</dl></div></header>";
}

/// The classes of failure of a mode's episodes by split, one stacked bar a split.
BarChart failure_chart(const ScoredRun& run, Mode mode) {
  BarChart chart;
  chart.id = "failures-" + std::string(name_of(mode));
  chart.title = "Why episodes in " + std::string(name_of(mode)) + " did not succeed";
  chart.note = "Share of the episodes of each split, in percent. Click a bar for its episodes.";
  chart.axis = "";
  chart.measure = "percent of episodes";
  chart.stacked = true;
  std::map<std::string, int> episodes;
  std::map<std::pair<FailureGroup, std::string>, int> failures;
  for (const EpisodeScore& one : run.scores) {
    if (one.key.mode != mode) continue;
    ++episodes[one.split];
    if (one.classes.empty()) continue;
    if (const auto failure = failure_class_of(one.classes.front())) ++failures[{failure->group, one.split}];
  }
  std::vector<std::string> splits;
  for (const SplitColumn& column : split_columns()) {
    if (episodes.contains(std::string(column.split))) splits.emplace_back(column.split);
  }
  chart.labels = splits;
  for (int group = 0; group <= static_cast<int>(FailureGroup::Goal); ++group) {
    BarChart::Series series{std::string(name_of(static_cast<FailureGroup>(group))), {}};
    int all = 0;
    for (const std::string& split : splits) {
      const auto found = failures.find({static_cast<FailureGroup>(group), split});
      const int count = found == failures.end() ? 0 : found->second;
      all += count;
      series.values.push_back(std::round(1000.0 * count / episodes[split]) / 10);
    }
    if (all > 0) chart.series.push_back(std::move(series));
  }
  return chart;
}

BarChart steps_chart(const ScoredRun& run, Mode mode, int limit) {
  BarChart chart;
  chart.id = "steps-" + std::string(name_of(mode));
  chart.title = "Steps of episodes in " + std::string(name_of(mode));
  chart.axis = "steps";
  chart.measure = "episodes";
  chart.stacked = true;
  chart.series = {{"succeeded", {}}, {"did not", {}}};
  for (const StepRange& range :
       step_ranges(episodes_where(run, [&](const EpisodeScore& one) { return one.key.mode == mode; }), limit)) {
    chart.labels.push_back(std::to_string(range.first) + "–" + std::to_string(range.last));
    chart.series[0].values.push_back(range.successes);
    chart.series[1].values.push_back(range.episodes - range.successes);
  }
  return chart;
}

std::string figure_html(const BarChart& chart) {
  return "<figure class=\"figure card" + std::string(chart.wide ? " wide" : "") + "\"><figcaption>" +
         escaped_html(chart.title) + "<span class=\"small\">" + escaped_html(chart.note) +
         "</span></figcaption><div class=\"plot\" style=\"height:" + std::to_string(height_of(chart)) +
         "px\"><canvas id=\"chart-" + chart.id + "\" role=\"img\" aria-label=\"" + escaped_html(chart.title) +
         "; the tables have all values\"></canvas></div></figure>";
}

std::string nav(const std::vector<std::pair<std::string, std::string>>& places) {
  std::string html = "<nav class=\"contents\" aria-label=\"Contents\"><ul>";
  for (const auto& [id, title] : places) html += "<li><a href=\"#" + id + "\">" + escaped_html(title) + "</a></li>";
  return html + "</ul></nav>";
}

/// An episode in the list of a report.
Json listed(const EpisodeScore& score) {
  Json json{{"task", score.key.task},     {"mode", name_of(score.key.mode)},
            {"repeat", score.key.repeat}, {"simulator", score.simulator},
            {"split", score.split},       {"template", score.template_name},
            {"held_out", score.held_out}, {"home", score.layout},
            {"end", name_of(score.end)},  {"success", score.success},
            {"count", score.steps},       {"failures", score.failures},
            {"classes", score.classes}};
  if (score.shortest) json["shortest"] = *score.shortest;
  const std::pair<const char*, bool> marks[] = {{"premature_stop", score.premature_stop},
                                                {"missed_stop", score.missed_stop},
                                                {"no_json", score.no_json > 0},
                                                {"unknown_action", score.unknown_action > 0},
                                                {"bad_argument", score.bad_argument > 0},
                                                {"truncated", score.truncated > 0},
                                                {"box", score.boxes > 0},
                                                {"hit", score.hits > 0}};
  for (const auto& [mark, has] : marks) {
    if (has && !score.errored()) json["marks"].push_back(mark);
  }
  return json;
}

HtmlPage page_with(std::string title, std::string body, const Json& data) {
  HtmlPage page;
  page.title = std::move(title);
  page.body = std::move(body);
  page.styles = {asset("page.css"), asset("report.css"), scores_asset("evaluation.css")};
  page.data = {{"data", json_in_html(data.dump(-1, ' ', false, Json::error_handler_t::replace))}};
  page.scripts = {asset("chart.min.js"), asset("page.js"), asset("report.js"), scores_asset("evaluation.js")};
  return page;
}

}  // namespace

std::string evaluation_page(const ScoredRun& run) {
  const std::span runs(&run, 1);
  std::vector<std::pair<std::string, std::string>> figures;
  Json data{{"charts", Json::array()}, {"examples", Json::array()}};
  std::string charts;
  for (const Mode mode : modes_of(run)) {
    const auto of_mode = episodes_where(run, [&](const EpisodeScore& one) { return one.key.mode == mode; });
    const ResultCell rate = success_cell(figures_of(of_mode, is_repeated(run)));
    figures.emplace_back("Success in " + std::string(name_of(mode)), rate.text + " %");
    figures.emplace_back("95 % interval in " + std::string(name_of(mode)), rate.aside);
    const auto settings = run.manifest.setup.settings.find(mode);
    const int limit = settings == run.manifest.setup.settings.end() ? 50 : settings->second.rules.limits.steps;
    for (const BarChart& chart : {failure_chart(run, mode), steps_chart(run, mode, limit)}) {
      if (chart.series.empty()) continue;
      charts += figure_html(chart);
      data["charts"].push_back(to_json(chart));
    }
  }
  figures.emplace_back("Episodes", std::to_string(run.scores.size()));
  std::string body = top_of(labels_of(runs).front(), conditions_of(runs), figures) +
                     nav({{"tables", "Tables"}, {"charts", "Charts"}, {"episodes", "Episodes"}}) +
                     "<main><section id=\"tables\"><h2>Tables</h2>";
  for (const ResultTable& table : result_tables(runs)) body += html_of(table, link_in_page);
  body += "</section><section id=\"charts\"><h2>Charts</h2><div class=\"figures\">" + charts + "</div></section>" +
          std::string(scores_asset("episodes.html")) + "</main>";
  data["episodes"] = Json::array();
  for (const EpisodeScore& one : run.scores) data["episodes"].push_back(listed(one));
  data["in_page"] = kEpisodesInPage;
  HtmlPage page = page_with(labels_of(runs).front() + ": evaluation", std::move(body), data);
  page.frames = true;
  return to_html(std::move(page));
}

std::string leaderboard_page(std::span<const ScoredRun> runs, std::span<const std::string> reports) {
  const LinkTo link_to = [&](const std::string& filter) -> std::string {
    const std::string& report = reports[run_of(filter)];
    return report.empty() ? "" : "<a href=\"" + escaped_html(report + "#" + filter) + "\">";
  };

  std::string body = top_of("Leaderboard", conditions_of(runs), {{"Runs", std::to_string(runs.size())}}) +
                     nav({{"ranks", "Ranks"}, {"tables", "Tables"}}) + "<main><section id=\"ranks\"><h2>Ranks</h2>";
  for (const ResultTable& table : comparison_tables(runs)) body += html_of(table, link_to);
  body += "</section><section id=\"tables\"><h2>Tables</h2>";
  for (const ResultTable& table : result_tables(runs)) body += html_of(table, link_to);
  body += "</section></main>";
  const Json data{{"charts", Json::array()}, {"examples", Json::array()}, {"episodes", Json::array()}};
  return to_html(page_with("Leaderboard", std::move(body), data));
}

}  // namespace unietp
