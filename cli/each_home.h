#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "cli/commands.h"

namespace unietp {

/// Calls `work(i)` once for each i below `count`, from `threads` threads at a time in any order; `work` ends it early
/// by returning false. Draws a line with what is done, the rate and the time left. False when Ctrl-C ended it between
/// two calls. What `work` throws is thrown again here. `unit` is what is counted, for the line.
bool for_each_home(std::size_t count, int threads, const CommandLine& program,
                   const std::function<bool(std::size_t)>& work, std::string_view unit = "homes");

}  // namespace unietp
