#include "run/fit_of_home.h"

#include <utility>

#include "generator/fixed_start.h"
#include "generator/specification.h"
#include "run/sense_of_binding.h"

namespace unietp {

BindingCheck fits_home(const RunConfiguration& configuration, const Resources& resources, const Template& source,
                       const Layout& layout, Grade least) {
  const Simulator simulator = layout.home.scene.simulator;
  BindingCheck makes_sense = at_least(least, source, resources, simulator);
  if (!configuration.binding.empty()) return makes_sense;
  return [&source, &layout, &knowledge = resources.backend(simulator).knowledge, makes_sense = std::move(makes_sense)](
             const Binding& bound, const Parameter& parameter, const std::string& category) {
    if (makes_sense && !makes_sense(bound, parameter, category)) return false;
    if (bound.size() + 1 < source.parameters.size()) return true;
    Binding all = bound;
    all.emplace_back(parameter.name, category);
    const auto specification = instantiate(source, knowledge, all);
    return specification && misfit(specification->init, knowledge, layout.offer.now) == nullptr;
  };
}

}  // namespace unietp
