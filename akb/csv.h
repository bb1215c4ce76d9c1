#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace unietp {

/// A field and where it stands.
struct CsvCell {
  std::string text;  // quotes resolved
  SourcePos pos;     // of the field's first byte, the opening quote of a quoted one
};
using CsvRow = std::vector<CsvCell>;

/// A table as text, with everything that is wrong with it.
struct CsvFile {
  CsvRow header;
  std::vector<CsvRow> rows;   // each as long as the header
  std::vector<Error> errors;  // empty when the text is sound; rows with an error are left out
};

/// Strict RFC 4180 with a header; lines end in LF or CRLF, the last may lack it.
/// Errors (Parse): a quote inside an unquoted field, text after a closing quote, a quoted field without end, a bare
/// carriage return, an empty line, a row that is not as long as the header, an empty or repeated column name, no
/// header.
CsvFile read_csv(std::string_view where, std::string_view text);

/// A field as it must stand in a CSV line: quoted when it holds a comma, a quote or a line end, or begins
/// with a byte order mark, which no file may begin with.
std::string csv_field(std::string_view text);
/// One line, LF at its end.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace unietp
