#pragma once

#include <cstddef>

/// Limits on the tables of knowledge and sense, as in core/limits.h.
namespace unietp::limits {

inline constexpr std::size_t kKindDepth = 100;  // kinds above one another; the committed table has 5

}  // namespace unietp::limits
