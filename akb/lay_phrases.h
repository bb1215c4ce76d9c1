#pragma once

#include <filesystem>
#include <vector>

#include "akb/tables.h"

namespace unietp {

/// Gives categories the phrases of data/sense/phrases.csv, beside a folder of tables, as aliases: wider names,
/// descriptions by use or part, sentences that give an occasion, and sentences that ask for a state without naming
/// anything. A phrase is of the categories of its kinds (lay_kinds.h comes first) and those that it lists by their
/// names or display names, less those that it excludes. A sentence that asks for a state has the state in front. `all`:
/// the tables of the simulators in the order of kSimulators. Without the file nothing is done. Errors are appended: Io,
/// Parse; Schema for an unknown use, state or kind, and a phrase that stands twice.
void lay_phrases(const std::filesystem::path& tables, std::vector<Tables>& all, std::vector<Error>& errors);

}  // namespace unietp
