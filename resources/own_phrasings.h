#pragma once

#include <span>
#include <string>
#include <string_view>

#include "resources/resources.h"

namespace unietp {

/// The phrasings of a template's `(instruction …)`; none of one that is not known here, such as a user's.
std::span<const std::string> phrasings_of_template(const Resources& resources, std::string_view name);
bool is_known_template(const Resources& resources, std::string_view name);

}  // namespace unietp
