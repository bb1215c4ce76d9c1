#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "report/figure_table.h"

namespace unietp {
namespace {

/// Columns that a text takes on a terminal.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

bool is_number(const std::string& text) {
  return text.empty() || text == "–" || (text.front() >= '0' && text.front() <= '9');
}

}  // namespace

std::string count_text(int count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string decimal_text(double value) {
  std::string text = number_text(std::round(value * 10) / 10);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}

std::string percent_text(double share) { return decimal_text(share * 100) + " %"; }

std::string table_text(const std::vector<FigureTable>& tables, std::size_t most_rows) {
  std::string text;
  for (const FigureTable& one : tables) {
    text += (text.empty() ? "" : "\n") + one.title + "\n";
    std::vector<std::vector<std::string>> lines{one.columns};
    lines.insert(lines.end(), one.rows.begin(),
                 one.rows.begin() + static_cast<std::ptrdiff_t>(std::min(most_rows, one.rows.size())));
    const bool headless = std::all_of(one.columns.begin(), one.columns.end(), [](const auto& c) { return c.empty(); });
    if (headless) lines.erase(lines.begin());
    std::vector<std::size_t> widths(one.columns.size());
    std::vector<bool> numbers(one.columns.size(), true);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t k = 0; k < widths.size(); ++k) {
        widths[k] = std::max(widths[k], width_of(lines[i][k]));
        if (i > 0 || headless) numbers[k] = numbers[k] && is_number(lines[i][k]);
      }
    }
    for (const auto& line : lines) {
      std::string row = " ";
      for (std::size_t k = 0; k < line.size(); ++k) {
        const std::string pad(widths[k] - width_of(line[k]), ' ');
        row += " " + (numbers[k] && k > 0 ? pad + line[k] : line[k] + pad) + " ";
      }
      text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
    }
    if (one.rows.size() > most_rows)
      text += "  … and " + std::to_string(one.rows.size() - most_rows) + " more; --json prints all\n";
  }
  return text;
}

}  // namespace unietp
