#include "akb/csv.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

std::vector<std::string> texts(const CsvRow& row) {
  std::vector<std::string> texts;
  for (const CsvCell& cell : row) {
    require(cell.pos.line >= 1 && cell.pos.column >= 1);
    texts.push_back(cell.text);
  }
  return texts;
}

}  // namespace

bool csv_body(std::string_view text) {
  const CsvFile file = read_csv("fuzz", text);
  for (const Error& error : file.errors) {
    check_error(error);
    require(error.pos.line >= 1 && error.pos.column >= 1);
  }
  for (const CsvRow& row : file.rows) require(row.size() == file.header.size());
  if (!file.errors.empty()) return false;
  std::string written = csv_line(texts(file.header));
  for (const CsvRow& row : file.rows) written += csv_line(texts(row));
  const CsvFile again = read_csv("fuzz", written);
  require(again.errors.empty());
  require(texts(again.header) == texts(file.header) && again.rows.size() == file.rows.size());
  for (std::size_t i = 0; i < file.rows.size(); ++i) require(texts(again.rows[i]) == texts(file.rows[i]));
  return true;
}

}  // namespace unietp::fuzz
