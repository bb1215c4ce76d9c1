#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace unietp {

/// One value or row of a database changed, as SQL.
struct TableChange {
  std::string field, how;  // field: "step.action", "step" for a row
  std::string sql;
};

/// For some rows of each table: each number plus one and twice, each text as another one of its column and with a
/// letter more; rows dropped, doubled and swapped; and a table, a column and an index more.
std::vector<TableChange> changes_of_database(const std::filesystem::path& file, int rows_of_a_table);

}  // namespace unietp
