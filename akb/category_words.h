#pragma once

#include <string>
#include <vector>

#include "akb/tables.h"

namespace unietp {

/// Whether one of the words of a table of kinds names the category: its name in lower case, "cutleryfork", or its
/// display name, "water_bottle" for "water bottle".
bool names_category(const std::vector<std::string>& words, const Category& category);

/// Whether a category of any simulator is named by the word.
bool names_any_category(const std::string& word, const std::vector<Tables>& all);

}  // namespace unietp
