#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace unietp {

/// A `Usage` error for a name that is not among `accepted`: lists those, and suggests the nearest. `option` is where
/// the name was given.
Error unknown_name_error(std::string_view option, std::string_view name, const std::vector<std::string>& accepted);

}  // namespace unietp
