#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generator/specification.h"

namespace unietp {

/// How much a category is wanted for a placeholder, > 0.
using CategoryWeight = std::function<double(const Parameter& parameter, const std::string& category)>;

/// As sample_binding, but each placeholder takes a category in proportion to its weight among those with which the rest
/// can still be filled; placeholders of `fixed` keep theirs, whether or not it is offered.
std::optional<Binding> sample_binding(const Template& source, const Knowledge& knowledge,
                                      const std::vector<std::string>& offered, const Binding& fixed,
                                      const CategoryWeight& weight, Rng rng);

}  // namespace unietp
