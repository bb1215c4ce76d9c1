#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "akb/tables.h"

namespace unietp {

// The form of a compiled file, shared by its writer and its reader. Names, sources and lists stand once a simulator in
// `text` and are named by number, in sorted order: rows are small, and the order of numbers is the order of names. What
// only one row says (an alias, the name of an asset) stands in the row. For people there is a view of each table with
// the columns of its CSV file and `simulator` before them.

/// Stored in the file; a file of another format is refused.
inline constexpr std::string_view kDatabaseFormat = "unietp-knowledge/5";

/// Statements that make all tables and views in an empty file.
extern const char* const kDatabaseSchema;

/// Fills a new file with the sorted tables of the four simulators. Errors: Io with SQLite's message.
std::vector<Error> write_database(const std::filesystem::path& path, const std::string& digest,
                                  const std::vector<Tables>& all);

}  // namespace unietp
