#include "scores/table_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/text.h"

namespace unietp {
namespace {

std::string whole_percent(double share) { return std::to_string(static_cast<int>(std::floor(share * 100 + 0.5))); }

}  // namespace

ResultCell success_cell(const Figures& figures) {
  if (figures.episodes == 0) return {"–", "", "", false};
  ResultCell cell;
  cell.text = figures.finished() == 0 ? "–" : std::to_string(percent_of(figures.successes, figures.finished()));
  if (figures.finished() > 0)
    cell.aside = "[" + whole_percent(figures.interval.low) + ", " + whole_percent(figures.interval.high) + "]";
  if (figures.errored > 0) {
    cell.aside += (cell.aside.empty() ? "" : " ") + std::string("{") + whole_percent(figures.bounds.low) + "–" +
                  whole_percent(figures.bounds.high) + "; " + std::to_string(figures.errored) + " errored}";
  }
  return cell;
}

std::string share_text(int count, int of) {
  if (of == 0) return "–";
  const auto tenths = (std::int64_t{2000} * count + of) / (std::int64_t{2} * of);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

std::string fixed_text(double value, int decimals) {
  char text[64];
  (void)std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string filter_text(std::size_t run, const std::vector<Condition>& conditions) {
  std::string text = "run=" + std::to_string(run);
  for (const auto& [field, value] : conditions) text += "&" + field + "=" + in_url(value);
  return text;
}

std::size_t run_of(const std::string& filter) { return std::stoul(filter.substr(std::string_view("run=").size())); }

std::string in_url(const std::string& text) {
  constexpr std::string_view kHex = "0123456789ABCDEF", kPlain = "-_./";
  std::string encoded;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain || kPlain.find(c) != std::string_view::npos) {
      encoded += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      encoded += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return encoded;
}

void mark_best(ResultTable& table, std::size_t first) {
  if (table.rows.size() < 2) return;
  for (std::size_t column = first; column < table.columns.size(); ++column) {
    int best = 0;
    const auto value = [&](const std::vector<ResultCell>& row) {
      const std::string& text = row[column].text;
      return text.empty() || text.find_first_not_of("0123456789") != std::string::npos ? -1 : std::stoi(text);
    };
    for (const auto& row : table.rows) best = std::max(best, value(row));
    for (auto& row : table.rows) row[column].best = best > 0 && value(row) == best;
  }
}

}  // namespace unietp
