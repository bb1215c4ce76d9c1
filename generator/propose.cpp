#include "generator/propose.h"

#include <algorithm>

#include "core/text.h"
#include "generator/consistency.h"
#include "generator/domain_constraints.h"
#include "templates/init_shape.h"
#include "templates/refinement_kinds.h"

namespace unietp {
namespace {

/// Starts drawn to see whether the goal may hold from the beginning.
constexpr int kStartsTried = 6;

bool is_demanded(const std::vector<Formula>& init, const std::string& category) {
  return std::any_of(init.begin(), init.end(), [&](const Formula& start) {
    return demanded_count(start) >= 1 && start.domain == of_category(category);
  });
}

/// The start must have something of every category that the binding names: what the goal is about and its tools.
void demand_existence(Specification& specification, const Template& source) {
  for (const auto& parameter : source.parameters) {
    const auto& category = *bound_to(specification.binding, parameter.name);
    if (is_value(parameter) || is_demanded(specification.init, category)) continue;
    specification.init.push_back(exists(lower(parameter.name), of_category(category), Formula{}));
  }
}

std::string names_of(const std::vector<Simulator>& simulators) {
  std::vector<std::string> names;
  for (const auto simulator : simulators) names.emplace_back(name_of(simulator));
  return join(names, ", ");
}

std::optional<GateRefusal> wrong_simulator(const Template& source, Simulator simulator) {
  const auto& supported = source.simulators;
  if (std::find(supported.begin(), supported.end(), simulator) != supported.end()) return std::nullopt;
  const std::string name(name_of(simulator));
  return GateRefusal{Gate::Simulator, name, "the template is not meant for " + name,
                     "choose one of " + names_of(supported) + ", or add it to the template's simulators"};
}

std::optional<GateRefusal> wrong_category(const Parameter& parameter, const Binding& binding,
                                          const Knowledge& knowledge) {
  const auto* category = bound_to(binding, parameter.name);
  if (category == nullptr) {
    return GateRefusal{Gate::Placeholder, parameter.name,
                       "the binding says nothing about placeholder " + parameter.name,
                       "bind " + parameter.name + " to what is: " + join(parameter.affordances, " ")};
  }
  if (affords(parameter, *category, knowledge)) return std::nullopt;
  const std::string simulator(name_of(knowledge.simulator()));
  if (is_room(parameter)) {
    return GateRefusal{Gate::Placeholder, parameter.name, "'" + *category + "' is not a room type of " + simulator,
                       "choose one of " + join(room_types(knowledge), ", ")};
  }
  if (is_value(parameter)) {
    const auto& word = parameter.affordances.front();
    return GateRefusal{Gate::Placeholder, parameter.name,
                       "'" + *category + "' is no " + word + " that the knowledge base of " + simulator + " names",
                       "choose a " + word + " of some category (unietp knowledge show CATEGORY)"};
  }
  if (knowledge.find(*category) == nullptr) {
    return GateRefusal{Gate::Placeholder, parameter.name, "'" + *category + "' is not a category of " + simulator,
                       "choose a category that is: " + join(parameter.affordances, " ")};
  }
  std::vector<std::string> missing;
  for (const auto& affordance : parameter.affordances) {
    if (!affords({parameter.name, {affordance}, {}}, *category, knowledge)) missing.push_back(affordance);
  }
  return GateRefusal{Gate::Affordance, parameter.name + " - " + join(parameter.affordances, " "),
                     "'" + *category + "' cannot be " + parameter.name +
                         ", which asks for: " + join(parameter.affordances, " ") + "; it is not " + join(missing, ", "),
                     "another category for " + parameter.name + ", or an override that makes " + *category + " " +
                         join(missing, ", ")};
}

std::optional<GateRefusal> broken_constraint(const Template& source, const Binding& binding,
                                             const Knowledge& knowledge) {
  for (const auto& constraint : source.constraints) {
    if (satisfies(constraint, binding, knowledge)) continue;
    const auto text = to_text(constraint, binding);
    const auto remedy = constraint.type == ConstraintType::Distinct
                            ? "different categories for " + join(constraint.arguments, ", ")
                            : "other categories, or a row of the knowledge base that says it";
    return GateRefusal{Gate::Constraint, text, "the binding breaks the constraint " + text, remedy};
  }
  return std::nullopt;
}

}  // namespace

std::variant<Specification, GateRefusal> fill_in(const Template& source, const Knowledge& knowledge,
                                                 const Binding& binding) {
  if (auto refusal = wrong_simulator(source, knowledge.simulator())) return *refusal;
  std::vector<NameBinding> names;
  for (const auto& parameter : source.parameters) {
    if (auto refusal = wrong_category(parameter, binding, knowledge)) return *refusal;
    names.push_back({parameter.name, {*bound_to(binding, parameter.name)}});
  }
  if (auto refusal = broken_constraint(source, binding, knowledge)) return *refusal;
  Specification specification;
  specification.template_name = source.name;
  specification.split = source.split;
  specification.simulator = knowledge.simulator();
  specification.binding = binding;
  specification.goal = substitute_names(source.goal, names);
  for (const auto& start : source.init) specification.init.push_back(substitute_names(start, names));
  if (const auto* kind = refinement_kind(source.refinement); kind != nullptr && kind->written) {
    specification.split = kind->split;
    specification.style = style_named(source.refinement).value_or(Style::Direct);
    specification.refinement = referring_named(source.refinement).value_or(Referring::None);
  }
  demand_existence(specification, source);
  return specification;
}

std::variant<Specification, GateRefusal> propose(const Template& source, const Knowledge& knowledge,
                                                 const Binding& binding) {
  auto filled = fill_in(source, knowledge, binding);
  if (const auto* specification = std::get_if<Specification>(&filled)) {
    if (auto refusal = refused_by(*specification, knowledge)) return *refusal;
  }
  return filled;
}

std::optional<GateRefusal> refused_by(const Specification& specification, const Knowledge& knowledge) {
  if (auto refusal = contradiction(specification, knowledge)) return refusal;
  return bad_start(specification, knowledge, kStartsTried);
}

}  // namespace unietp
