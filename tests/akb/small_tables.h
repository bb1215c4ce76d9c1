#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "akb/knowledge.h"
#include "akb/tables.h"
#include "tests/support/scratch_folder.h"

namespace unietp::test {

/// The texts of five small sound tables (a mug, a plate, a fridge, an apple, half of one, a knife), by table name.
std::map<std::string, std::string> small_tables();
/// Writes them for all four simulators.
void write_small_tables(const std::filesystem::path& tables, const std::map<std::string, std::string>& texts);

Knowledge knowledge_of(Simulator simulator, Tables tables);
/// What the small tables say.
Knowledge small_knowledge();

std::filesystem::path committed_tables();  // data/akb
Tables committed(Simulator simulator);     // fails the test when they do not read
const Category& category(const Tables& tables, const std::string& name);

}  // namespace unietp::test
