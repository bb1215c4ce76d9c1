#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/in_quotes.h"
#include "core/limits.h"
#include "core/result.h"

namespace unietp {

/// The text as a JSON value, strictly: one value, UTF-8, no field twice in an object, at most `max_fields` fields in an
/// object (others' files name their objects by fields and have thousands), limits::kJsonDepth levels and
/// limits::kJsonValues values, so that no input costs more time than its length or fills the memory. Never throws.
/// Errors: Parse with line and column; Schema with a JSON pointer for a repeated field or a broken limit.
Result<nlohmann::ordered_json> parse_json(std::string_view where, std::string_view text,
                                          std::size_t max_fields = limits::kJsonFields);

/// The same without the fields of these names, in whichever object: of those only the syntax is checked.
Result<nlohmann::ordered_json> parse_json_without(std::span<const std::string_view> names, std::string_view where,
                                                  std::string_view text);

}  // namespace unietp
