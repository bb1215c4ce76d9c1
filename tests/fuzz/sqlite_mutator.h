#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/rng.h"

namespace unietp::fuzz {

/// The bytes of a SQLite database with one to three changes: through SQLite, of cells, rows, columns, tables and the
/// text of the schema, so that it stays a database; or of the bytes of its pages behind the header. `donor`: a database
/// whose cells may come in. nullopt when the bytes are no database. Equal arguments give equal bytes.
std::optional<std::string> mutate_sqlite(std::string_view bytes, std::string_view donor, Rng rng);

}  // namespace unietp::fuzz
