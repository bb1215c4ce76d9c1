#pragma once

#include <filesystem>
#include <vector>

#include "akb/tables.h"

namespace unietp {

/// The tables of data/sense that say what kind of thing each category is and what things are for, beside a folder of
/// tables: kinds.csv, categories.csv, functions.csv. A folder of one's own may lack them; then nothing is laid over it.
std::vector<std::filesystem::path> kind_files(const std::filesystem::path& tables);

/// Gives each category its kinds, narrowest first, and each member of a function its phrases, as aliases. The members
/// of a function are the categories of its kinds and those that it names by their display names, less those that it
/// excludes. `all`: the tables of the simulators in the order of kSimulators. Errors are appended: Io, Parse; Schema
/// for a function of an unknown kind, one without a member, or two functions with one phrase.
void lay_kinds(const std::filesystem::path& tables, std::vector<Tables>& all, std::vector<Error>& errors);

}  // namespace unietp
