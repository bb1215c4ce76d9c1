#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "akb/csv.h"
#include "akb/name_table.h"
#include "akb/rows.h"
#include "core/files.h"

namespace unietp {

/// One CSV file whose cells are read by column name; every cell that does not read is an error at its place.
class RowReader {
 public:
  /// Errors: those of read_csv; a column missing or unknown.
  RowReader(std::string where, std::string_view text, const std::vector<std::string>& columns,
            std::vector<Error>& errors);

  /// Rows of the right length, in order; none when a column is missing.
  const std::vector<CsvRow>& rows() const { return file_.rows; }
  /// Starts a row: `sound()` tells afterwards whether all its cells read well.
  void at(const CsvRow& row);
  bool sound() const { return sound_; }

  /// The cell as it stands; may be empty.
  const std::string& text(std::string_view column) const;
  /// An error when the cell is empty.
  std::string required(std::string_view column);
  bool flag(std::string_view column);  // true or false
  /// A number up to `high`, and at least or above `low`.
  double number(std::string_view column, double low, double high, bool low_allowed);
  int integer(std::string_view column, int low);           // >= low
  std::vector<std::string> list(std::string_view column);  // joined by |
  /// One of the names; the error lists them and suggests the nearest. `noun` says what they name: "archetype".
  std::string one_of(std::string_view column, const std::vector<std::string>& names, std::string_view noun);
  /// The same as a value of an enum, which `named` reads; its first value after an error.
  template <class Value>
  Value value_of(std::string_view column, const std::vector<std::string>& names, std::string_view noun,
                 std::optional<Value> (*named)(std::string_view)) {
    return named(one_of(column, names, noun)).value_or(Value());
  }
  /// The same for many names: of the category table.
  std::string one_of(std::string_view column, const NameTable& names, std::string_view noun);
  /// A list, joined by |, of such names.
  std::vector<std::string> all_of(std::string_view column, const std::vector<std::string>& names,
                                  std::string_view noun);
  /// A well-formed source with a confidence in (0, 1].
  Source source(std::string_view source_column, std::string_view confidence_column);
  /// Adds a Schema error at a cell of the row.
  void fail(std::string_view column, std::string message);
  SourcePos place(std::string_view column) const { return cell(column).pos; }

 private:
  const CsvCell& cell(std::string_view column) const;

  std::string where_;
  CsvFile file_;
  std::vector<std::string> header_;
  mutable std::size_t next_ = 0;  // the column after the one read last: mostly the one that is asked for
  std::vector<Error>& errors_;
  const CsvRow* row_ = nullptr;
  bool sound_ = true;
};

/// Calls `read` with a reader at each row of a file. Errors, also of a file that cannot be read, are appended.
template <class Read>
void each_row(const std::filesystem::path& path, const std::vector<std::string>& columns, std::vector<Error>& errors,
              const Read& read) {
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return;
  }
  RowReader row(path.string(), *text, columns, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    read(row);
  }
}

}  // namespace unietp
