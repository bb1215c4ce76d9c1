#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generator/specification.h"

namespace unietp {

/// How much a category is wanted for a placeholder, > 0.
using CategoryWeight = std::function<double(const Parameter& parameter, const std::string& category)>;

/// Whether a category may fill a placeholder when others are bound as in `bound`, which may be all before it or fewer.
/// What is refused stays refused however many more are bound.
using BindingCheck = std::function<bool(const Binding& bound, const Parameter& parameter, const std::string& category)>;

/// What a drawn binding has to heed beside the template's constraints.
struct BindingWishes {
  Binding fixed;          // placeholders that keep these, whether or not they are offered
  CategoryWeight weight;  // none: all categories are wanted equally
  BindingCheck accepts;   // none: all are accepted
};

/// As sample_binding, but each placeholder takes a category in proportion to its weight among those with which the rest
/// can still be filled. Gives up after a number of categories that depends on nothing else.
std::optional<Binding> sample_binding(const Template& source, const Knowledge& knowledge,
                                      const std::vector<std::string>& offered, const BindingWishes& wishes, Rng rng);

}  // namespace unietp
