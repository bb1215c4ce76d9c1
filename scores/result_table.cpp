#include "scores/result_table.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

/// The head of a column with the name of its group: "M1 At.".
std::vector<std::string> whole_heads(const ResultTable& table) {
  std::vector<std::string> heads;
  std::size_t column = 0;
  for (const ResultTable::Group& group : table.groups) {
    for (std::size_t i = 0; i < group.columns && column < table.columns.size(); ++i, ++column)
      heads.push_back(group.name.empty() ? table.columns[column] : group.name + " " + table.columns[column]);
  }
  for (; column < table.columns.size(); ++column) heads.push_back(table.columns[column]);
  return heads;
}

std::string with_aside(const ResultCell& cell) { return cell.aside.empty() ? cell.text : cell.text + " " + cell.aside; }

std::string markdown_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("|\\`*_<>[]").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

std::string latex_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      escaped += std::string("\\") + c + "{}";
    } else if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) {
      escaped += std::string("\\") + c;
    } else {
      escaped += c == '\n' ? ' ' : c;
    }
  }
  escaped = replace_all(std::move(escaped), "–", "--");
  escaped = replace_all(std::move(escaped), "✓", "\\checkmark{}");
  return replace_all(std::move(escaped), "✗", "$\\times$");
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  return "\"" + replace_all(text, "\"", "\"\"") + "\"";
}

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string pad(width - std::min(width, width_of(text)), ' ');
  return right ? pad + text : text + pad;
}

std::string latex_of(const ResultTable& table) {
  std::string columns = "l", groups, rules;
  std::size_t column = 0;
  for (const ResultTable::Group& group : table.groups) {
    if (column > 0) {
      columns += "|" + std::string(group.columns, 'c');
      groups += " & ";
    } else {
      columns += std::string(group.columns - 1, 'c');
    }
    if (column == 0 && group.columns == 1) {
      groups += latex_text(group.name);
    } else {
      groups += "\\multicolumn{" + std::to_string(group.columns) + "}{c}{" + latex_text(group.name) + "}";
    }
    column += group.columns;
  }
  std::string text = "\\begin{table*}\n\\caption{" + latex_text(table.title) + ". " + latex_text(table.note) +
                     "}\n\\label{tab:" + table.id + "}\n\\centering\n\\begin{tabular}{" + columns + "}\n\\toprule\n";
  if (table.groups.size() > 1) text += groups + " \\\\\n";
  std::vector<std::string> heads;
  for (const std::string& head : table.columns) heads.push_back(latex_text(head));
  text += join(heads, " & ") + " \\\\\n\\midrule\n";
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const ResultCell& cell : row) {
      std::string one = latex_text(cell.text);
      if (cell.best) one = "\\textbf{" + one + "}";
      if (!cell.aside.empty()) one += " {\\tiny " + latex_text(cell.aside) + "}";
      cells.push_back(std::move(one));
    }
    text += join(cells, " & ") + " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n\\end{table*}\n";
}

}  // namespace

std::string to_markdown(const std::vector<ResultTable>& tables) {
  std::string text;
  for (const ResultTable& table : tables) {
    text += (text.empty() ? "" : "\n") + std::string("## ") + markdown_text(table.title) + "\n\n";
    if (!table.note.empty()) text += markdown_text(table.note) + "\n\n";
    std::vector<std::string> heads, rule;
    for (const std::string& head : whole_heads(table)) {
      heads.push_back(markdown_text(head));
      rule.emplace_back(rule.empty() ? "---" : "---:");
    }
    text += "| " + join(heads, " | ") + " |\n| " + join(rule, " | ") + " |\n";
    for (const auto& row : table.rows) {
      std::vector<std::string> cells;
      for (const ResultCell& cell : row) {
        const std::string main = cell.best ? "**" + markdown_text(cell.text) + "**" : markdown_text(cell.text);
        cells.push_back(cell.aside.empty() ? main : main + " " + markdown_text(cell.aside));
      }
      text += "| " + join(cells, " | ") + " |\n";
    }
  }
  return text;
}

std::string to_latex(const std::vector<ResultTable>& tables) {
  std::string text = "% Needs \\usepackage{booktabs} and \\usepackage{amssymb}.\n";
  for (const ResultTable& table : tables) text += "\n" + latex_of(table);
  return text;
}

std::string to_csv(const std::vector<ResultTable>& tables) {
  std::string text;
  for (const ResultTable& table : tables) {
    text += (text.empty() ? "" : "\n") + csv_text(table.id) + "," + csv_text(table.note) + "\n";
    std::vector<bool> has_aside(table.columns.size(), false);
    for (const auto& row : table.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) has_aside[i] = has_aside[i] || !row[i].aside.empty();
    }
    std::vector<std::string> line;
    const auto heads = whole_heads(table);
    for (std::size_t i = 0; i < heads.size(); ++i) {
      line.push_back(csv_text(heads[i]));
      if (has_aside[i]) line.push_back(csv_text(heads[i] + " (aside)"));
    }
    text += join(line, ",") + "\n";
    for (const auto& row : table.rows) {
      line.clear();
      for (std::size_t i = 0; i < row.size(); ++i) {
        line.push_back(csv_text(row[i].text));
        if (has_aside[i]) line.push_back(csv_text(row[i].aside));
      }
      text += join(line, ",") + "\n";
    }
  }
  return text;
}

std::string to_plain_text(const std::vector<ResultTable>& tables) {
  std::string text;
  for (const ResultTable& table : tables) {
    text += (text.empty() ? "" : "\n") + table.title + "\n";
    if (!table.note.empty()) text += "  " + table.note + "\n";
    std::vector<std::vector<std::string>> lines{whole_heads(table)};
    for (const auto& row : table.rows) {
      lines.emplace_back();
      for (const ResultCell& cell : row) lines.back().push_back(with_aside(cell));
    }
    std::vector<std::size_t> widths(table.columns.size(), 0);
    for (const auto& line : lines) {
      for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width_of(line[i]));
    }
    for (const auto& line : lines) {
      std::string row = " ";
      for (std::size_t i = 0; i < line.size(); ++i) row += " " + padded(line[i], widths[i], i > 0) + " ";
      text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
    }
  }
  return text;
}

}  // namespace unietp
