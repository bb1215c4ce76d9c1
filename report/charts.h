#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "report/statistics.h"

namespace unietp {

/// Bars that assets/report.js draws with Chart.js; the table of figure_table.h with the same figures is shown on
/// request.
struct BarChart {
  std::string id, title, note;
  std::string table;  // id of the table
  std::vector<std::string> labels;
  struct Series {
    std::string name;
    std::vector<double> values;  // as many as labels
  };
  std::vector<Series> series;
  std::string axis, measure;  // titles of the two axes
  bool horizontal = false, stacked = false, wide = false;
};

/// Charts under one heading of the page.
struct ChartSection {
  std::string id, title, lead;
  std::vector<BarChart> charts;
};
/// All charts of a data set, in the order of the page.
std::vector<ChartSection> chart_sections(const DatasetStatistics& statistics);

/// As assets/report.js reads it.
nlohmann::ordered_json to_json(const BarChart& chart);
/// Height on the page, pixels.
int height_of(const BarChart& chart);

}  // namespace unietp
