#include "run/fit_of_home.h"

#include <utility>

#include "generator/fixed_start.h"
#include "generator/specification.h"

namespace unietp {

BindingCheck fits_home(const Template& source, const Knowledge& knowledge, const SceneOffer& offer) {
  return [&](const Binding& bound, const Parameter& parameter, const std::string& category) {
    if (bound.size() + 1 < source.parameters.size()) return true;
    Binding all = bound;
    all.emplace_back(parameter.name, category);
    const auto specification = instantiate(source, knowledge, all);
    return specification && misfit(specification->init, knowledge, offer.now) == nullptr;
  };
}

BindingCheck both(BindingCheck first, BindingCheck second) {
  if (!first) return second;
  if (!second) return first;
  return [first = std::move(first), second = std::move(second)](const Binding& bound, const Parameter& parameter,
                                                                const std::string& category) {
    return first(bound, parameter, category) && second(bound, parameter, category);
  };
}

}  // namespace unietp
