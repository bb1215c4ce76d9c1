#pragma once

#include <string>

namespace unietp {

/// The text of data/schemas/names.schema.json: the names of actions, states and edge relations, which other schemas
/// refer to. `unietp schemas --names` prints it.
std::string schema_names();

}  // namespace unietp
