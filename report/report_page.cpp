#include "report/report_page.h"

#include <algorithm>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "report/asset.h"
#include "report/charts.h"
#include "report/figure_table.h"
#include "report/html.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string cell(const std::string& text, bool head) {
  const bool number = !head && !text.empty() && text.find_first_not_of("0123456789,.") == std::string::npos;
  return std::string(number ? "<td class=\"number\">" : "<td>") + escaped_html(text) + "</td>";
}

std::string html_of(const FigureTable& table) {
  std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped_html(table.title) +
                     "\"><table><caption class=\"visually-hidden\">" + escaped_html(table.title) + "</caption>";
  html += "<thead><tr>";
  for (const auto& column : table.columns) html += "<th scope=\"col\">" + escaped_html(column) + "</th>";
  html += "</tr></thead><tbody>";
  for (const auto& row : table.rows) {
    html += "<tr><th scope=\"row\">" + escaped_html(row[0]) + "</th>";
    for (std::size_t i = 1; i < row.size(); ++i) html += cell(row[i], false);
    html += "</tr>";
  }
  return html + "</tbody></table></div>";
}

/// Description of a chart for screen readers.
std::string aria_label(const BarChart& chart) {
  std::string text = "Bar chart: " + chart.title + ".";
  for (const auto& series : chart.series) {
    if (series.values.empty()) continue;
    const auto most = std::max_element(series.values.begin(), series.values.end());
    text += " " + series.name + ": most at " + chart.labels[static_cast<std::size_t>(most - series.values.begin())] +
            " with " + number_text(*most) + ".";
  }
  return text + " The table below has all values.";
}

std::string html_of(const BarChart& chart, const FigureTable& table) {
  std::string html = "<figure class=\"figure card" + std::string(chart.wide ? " wide" : "") + "\"><figcaption>" +
                     escaped_html(chart.title);
  if (!chart.note.empty()) html += "<span class=\"small\">" + escaped_html(chart.note) + "</span>";
  html += "</figcaption><div class=\"plot\" style=\"height:" + std::to_string(height_of(chart)) +
          "px\"><canvas id=\"chart-" + chart.id + "\" role=\"img\" aria-label=\"" + escaped_html(aria_label(chart)) +
          "\"></canvas></div>";
  return html + "<details><summary>Table</summary>" + html_of(table) + "</details></figure>";
}

std::string top_of(const DatasetStatistics& statistics, const FigureTable& overview) {
  std::string html =
      "<a class=\"skip\" href=\"#tasks-section\">Skip to the charts</a><header class=\"top\">"
      "<div class=\"inner\"><div class=\"line\"><div><h1>" +
      escaped_html(statistics.name) +
      "</h1><p class=\"soft\">Embodied-planning tasks, each verified by a replay in physics</p></div>"
      "<button id=\"theme\" class=\"theme\" type=\"button\">Light/dark</button></div>"
      "<dl class=\"key-figures\">";
  for (const auto& row : overview.rows)
    html += "<div><dt>" + escaped_html(row[0]) + "</dt><dd>" + escaped_html(row[1]) + "</dd></div>";
  return html + "</dl></div></header>";
}

std::string examples_section(std::size_t count) {
  return "<section id=\"examples-section\"><h2>Examples</h2><p>" + std::to_string(count) +
         " tasks from all simulators and splits. Use the arrow keys to move between them while the card has the "
         "focus.</p>"
         "<div class=\"card\" id=\"examples\" tabindex=\"0\" aria-label=\"Examples\"><div class=\"pager\">"
         "<button type=\"button\" id=\"previous\" aria-label=\"Previous example\">‹ Previous</button>"
         "<button type=\"button\" id=\"next\" aria-label=\"Next example\">Next ›</button>"
         "<label class=\"visually-hidden\" for=\"example\">Example</label><select id=\"example\"></select>"
         "<span id=\"example-count\" class=\"soft small\" aria-live=\"polite\"></span></div><div class=\"task\">" +
         std::string(asset("task.html")) + "</div></div></section>";
}

Json example_json(const ReportExample& example) {
  const TaskRecord& task = example.task.record;
  Json json{{"id", task.id},
            {"simulator", task.simulator},
            {"split", task.split},
            {"template", task.template_name},
            {"layout", task.layout},
            {"instruction", task.instruction},
            {"svg", example.pictures.svg}};
  json.update(card_json(example.task, example.pictures.png));
  return json;
}

}  // namespace

std::vector<ExamplePlace> example_places(const DatasetStatistics& statistics, std::size_t count) {
  std::map<std::pair<std::string, std::string>, std::size_t> groups;  // by split, then simulator
  for (const auto& [key, tasks] : statistics.by_simulator_and_split)
    groups[{key.second, key.first}] = static_cast<std::size_t>(tasks);
  std::vector<ExamplePlace> places;
  count = std::min(count, static_cast<std::size_t>(statistics.tasks));
  for (std::size_t round = 0; places.size() < count; ++round) {
    std::size_t number = 0;
    for (const auto& [key, tasks] : groups) {
      // Groups start at different offsets, so that their first examples differ in home and template.
      const std::size_t offset = tasks * number++ / groups.size();
      if (round < tasks && places.size() < count)
        places.push_back({key.first, key.second, static_cast<int>((offset + round) % tasks)});
    }
  }
  return places;
}

Result<std::vector<ShownTask>> read_examples(const FinishedSet& set, const std::vector<ExamplePlace>& places,
                                             int threads) {
  std::map<ExamplePlace, ShownTask> found;
  const std::set<ExamplePlace> wanted(places.begin(), places.end());
  std::map<std::pair<std::string, std::string>, int> ranks;
  auto reader = DatasetReader::open(set.folder, {.modes = set.modes});
  if (!reader) return reader.error();
  const auto read = for_each_task<ShownTask>(
      std::move(*reader), threads, [](const FinishedTask& task) -> Result<ShownTask> { return shown_task(task); },
      [&](ShownTask&& task) -> Result<Done> {
        const auto &split = task.record.split, &simulator = task.record.simulator;
        ExamplePlace place{split, simulator, ranks[{split, simulator}]++};
        if (wanted.contains(place)) found.emplace(std::move(place), std::move(task));
        return Done{};
      });
  if (!read) return read.error();
  std::vector<ShownTask> examples;
  for (const ExamplePlace& place : places) {
    const auto one = found.find(place);
    if (one == found.end()) return changed_while_read(set);
    examples.push_back(std::move(one->second));
  }
  return examples;
}

std::string report_page(const DatasetStatistics& statistics, const std::vector<ReportExample>& examples) {
  const auto tables = tables_of(std::span(&statistics, 1));
  const auto table_named = [&](const std::string& id) -> const FigureTable& {
    return *std::find_if(tables.begin(), tables.end(), [&](const FigureTable& one) { return one.id == id; });
  };
  const auto sections = chart_sections(statistics);
  HtmlPage page;
  page.title = statistics.name + ": report";
  page.body = top_of(statistics, table_named("overview")) + "<nav class=\"contents\" aria-label=\"Contents\"><ul>";
  for (const auto& section : sections)
    page.body += "<li><a href=\"#" + section.id + "\">" + escaped_html(section.title) + "</a></li>";
  if (!examples.empty()) page.body += "<li><a href=\"#examples-section\">Examples</a></li>";
  page.body += "</ul></nav><main>";
  Json data{{"charts", Json::array()}, {"examples", Json::array()}};
  for (const auto& section : sections) {
    page.body += "<section id=\"" + section.id + "\"><h2>" + escaped_html(section.title) + "</h2><p>" +
                 escaped_html(section.lead) + "</p><div class=\"figures\">";
    for (const BarChart& chart : section.charts) {
      page.body += html_of(chart, table_named(chart.table));
      data["charts"].push_back(to_json(chart));
    }
    page.body += "</div></section>";
  }
  for (const auto& example : examples) data["examples"].push_back(example_json(example));
  if (!examples.empty()) page.body += examples_section(examples.size());
  page.body +=
      "</main><footer>Generated by unietp from the files of the data set. Charts: Chart.js 3.9.1, "
      "© 2022 Chart.js Contributors, MIT license.</footer>\n";
  page.data = {{"data", json_in_html(data.dump(-1, ' ', false, Json::error_handler_t::replace))}};
  page.styles = {asset("page.css"), asset("report.css")};
  page.scripts = {asset("chart.min.js"), asset("page.js"), asset("task.js"), asset("report.js")};
  return to_html(std::move(page));
}

}  // namespace unietp
