#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/rng.h"

namespace unietp::fuzz {

/// A JSON text with one to four changes of its values, so that it stays JSON and reaches what lies behind the parser:
/// values dropped, repeated, swapped, nested, given another type, renamed, lengthened, taken from elsewhere in the text
/// or from `donor`, numbers at the ends of their ranges. Of a text of several lines (JSON lines, parts between other
/// lines), one line that is JSON changes. nullopt when none is. Equal arguments give equal texts.
std::optional<std::string> mutate_json(std::string_view text, std::string_view donor, Rng rng);

}  // namespace unietp::fuzz
