#pragma once

#include <string_view>

#include "logic/vocabulary.h"

namespace unietp {

/// What bringing a state about is called in roles (docs/sense.md): "wash" for clean; "" for states that nobody asks for
/// as such.
std::string_view action_of(Predicate predicate);

}  // namespace unietp
