#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "cli/commands.h"

namespace unietp {

/// Calls `work(i)` once for each i below `count` on up to `threads` threads, in any order, until a call returns false.
/// Draws a progress line; `unit` names what is counted. Returns false when Ctrl-C ended it. Rethrows what `work`
/// throws.
bool for_each_home(std::size_t count, int threads, const CommandLine& program,
                   const std::function<bool(std::size_t)>& work, std::string_view unit = "homes");

}  // namespace unietp
