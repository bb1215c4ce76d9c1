#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "report/statistics.h"

namespace unietp {

/// Bars that assets/report.js draws with Chart.js; the table of figure_table.h that has the same figures stands behind.
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

struct ChartSection {
  std::string id, title, lead;
  std::vector<BarChart> charts;
};
std::vector<ChartSection> chart_sections(const DatasetStatistics& statistics);

nlohmann::ordered_json to_json(const BarChart& chart);
/// Pixels.
int height_of(const BarChart& chart);

}  // namespace unietp
