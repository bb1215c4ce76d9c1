#include <algorithm>

#include "core/text.h"
#include "generator/consistency.h"
#include "generator/domain_constraints.h"
#include "generator/specification.h"
#include "templates/init_shape.h"

namespace unietp {
namespace {

/// Starts drawn to see whether the goal may hold from the beginning.
constexpr int kStarts = 6;

Error refused(const Template& source, std::string message) {
  return {Error::Kind::Unsatisfiable, source.name, {}, std::move(message)};
}

bool is_demanded(const std::vector<Formula>& init, const std::string& category) {
  return std::any_of(init.begin(), init.end(), [&](const Formula& start) {
    return demanded_count(start) >= 1 && start.domain == of_category(category);
  });
}

/// The start must have something of every category that the binding names: what the goal is about and its tools.
void demand_existence(Specification& specification) {
  for (const auto& [placeholder, category] : specification.binding) {
    if (is_demanded(specification.init, category)) continue;
    specification.init.push_back(exists(lower(placeholder), of_category(category), Formula{}));
  }
}

std::string wrong_category(const Parameter& parameter, const std::string& category) {
  return "'" + category + "' cannot be " + parameter.name + ", which asks for: " + join(parameter.affordances, " ");
}

}  // namespace

Result<Specification> instantiate(const Template& source, const Knowledge& knowledge, const Binding& binding) {
  if (std::find(source.simulators.begin(), source.simulators.end(), knowledge.simulator()) == source.simulators.end()) {
    return refused(source, "the template is not meant for " + std::string(name_of(knowledge.simulator())));
  }
  std::vector<NameBinding> names;
  for (const auto& parameter : source.parameters) {
    const auto* category = bound_to(binding, parameter.name);
    if (category == nullptr) return refused(source, "the binding says nothing about placeholder " + parameter.name);
    if (!affords(parameter, *category, knowledge)) return refused(source, wrong_category(parameter, *category));
    names.push_back({parameter.name, {*category}});
  }
  for (const auto& constraint : source.constraints) {
    if (!satisfies(constraint, binding, knowledge)) {
      return refused(source, "the binding breaks the constraint " + to_text(constraint, binding));
    }
  }
  Specification specification;
  specification.template_name = source.name;
  specification.split = source.split;
  specification.simulator = knowledge.simulator();
  specification.binding = binding;
  specification.goal = substitute_names(source.goal, names);
  for (const auto& start : source.init) specification.init.push_back(substitute_names(start, names));
  demand_existence(specification);
  if (const auto problem = contradiction(specification, knowledge)) return refused(source, *problem);
  if (const auto problem = bad_start(specification, knowledge, kStarts)) return refused(source, *problem);
  return specification;
}

}  // namespace unietp
