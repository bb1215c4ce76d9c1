#pragma once

#include <string>
#include <vector>

namespace unietp {

/// A row of a table as text, column by column.
using TextRow = std::vector<std::string>;

}  // namespace unietp
