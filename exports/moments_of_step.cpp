#include "exports/moments_of_step.h"

#include <algorithm>

namespace unietp {

std::vector<std::vector<std::string>> moments_of_step(const std::vector<std::vector<std::string>>& holding,
                                                      std::size_t& at, std::size_t moments) {
  const auto first = holding.begin() + static_cast<std::ptrdiff_t>(at) + 1;
  const std::size_t passed = std::max<std::size_t>(1, moments);
  at += passed;
  return {first, first + static_cast<std::ptrdiff_t>(passed)};
}

}  // namespace unietp
