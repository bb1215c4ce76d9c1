#pragma once

#include <string>
#include <vector>

#include "akb/csv.h"

namespace unietp {

/// The text of a table: a line of its columns, then one of the fields of each row, in order.
template <class Row>
std::string csv_of(const std::vector<std::string>& columns, const std::vector<Row>& rows,
                   std::vector<std::string> (*fields)(const Row&)) {
  std::string text = csv_line(columns);
  for (const Row& row : rows) text += csv_line(fields(row));
  return text;
}

}  // namespace unietp
