#include "exports/moments_of_step.h"

#include <algorithm>

namespace unietp {

void write_what_holds(nlohmann::ordered_json& step, const std::vector<std::vector<std::string>>& holding,
                      std::size_t& at, std::size_t moments) {
  auto each = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < moments; ++i) each.push_back(holding[at + 1 + i]);
  at += std::max<std::size_t>(1, moments);
  step["holds"] = holding[at];
  if (!each.empty()) step["moments"] = std::move(each);
}

}  // namespace unietp
