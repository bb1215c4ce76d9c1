#pragma once

#include <string>
#include <vector>

namespace unietp {

/// A cell of a table of results.
struct ResultCell {
  std::string text;    // "72"
  std::string aside;   // smaller, after it: "[68, 76]"; "" for none
  std::string filter;  // which episodes it counts, for the report: "run=0&mode=M1&split=atomic"; "" for none
  bool best = false;   // of its column
};

/// A table of results, which is written as Markdown, LaTeX, CSV and HTML.
struct ResultTable {
  std::string id;     // "main"
  std::string title;  // a line without full stop
  std::string note;   // what it counts and on what: backend, preset, version
  struct Group {
    std::string name;  // "M1"; "" above columns that need none
    std::size_t columns = 0;
  };
  std::vector<Group> groups;         // together as many columns as below
  std::vector<std::string> columns;  // the first names the rows
  std::vector<std::vector<ResultCell>> rows;
};

/// Tables as GitHub's Markdown, one after the other under headings. Names of groups stand in the heads of columns.
std::string to_markdown(const std::vector<ResultTable>& tables);
/// Tables as LaTeX (booktabs, multirow not needed), each a table environment with caption and label `tab:ID`.
std::string to_latex(const std::vector<ResultTable>& tables);
/// Tables as CSV (RFC 4180), one after the other with an empty line between, each below a line with its id and note.
/// What stands aside has a column of its own.
std::string to_csv(const std::vector<ResultTable>& tables);
/// As columns of plain text, for a terminal.
std::string to_plain_text(const std::vector<ResultTable>& tables);

}  // namespace unietp
