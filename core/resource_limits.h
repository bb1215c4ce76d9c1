#pragma once

#include <cstddef>

/// Limits on what one home or one row of a database may take, as in core/limits.h.
namespace unietp::limits {

// Of physics for a home, as SettleOptions::most_work counts it: some twenty times what 300 movable objects take that
// stand apart. A heap of thousands would take hours.
inline constexpr std::size_t kMostWork = 30'000'000;
// Of a text or a row. The longest that is stored is a task with its demonstrations, a line of each mode.
inline constexpr int kDatabaseBytes = 64 << 20;

}  // namespace unietp::limits
