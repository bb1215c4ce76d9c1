#include "authoring/usual_categories.h"

#include <algorithm>
#include <set>

#include "generator/domain_constraints.h"
#include "run/sense_of_binding.h"

namespace unietp {
namespace {

/// Whether a variable of the formula ranges over what is bound to a placeholder.
bool speaks_of(const Formula& part, const std::string& placeholder) {
  const auto& members = part.domain.members;
  const auto speaks = [&](const Formula& inner) { return speaks_of(inner, placeholder); };
  return std::any_of(members.begin(), members.end(), [&](const auto& one) { return one.category == placeholder; }) ||
         std::any_of(part.domain.where.begin(), part.domain.where.end(), speaks) ||
         std::any_of(part.children.begin(), part.children.end(), speaks);
}

/// Adds those that one placeholder of a template can be with a usual goal.
void add_usual(const Template& source, const Parameter& parameter, const Resources& resources, Simulator simulator,
               std::set<std::string>& usual) {
  const auto& knowledge = resources.backend(simulator).knowledge;
  const BindingCheck makes_sense = at_least(Grade::Usual, source, resources, simulator);
  for (const auto& name : candidates_for(parameter, source.constraints, {}, knowledge, nullptr)) {
    if (usual.contains(name)) continue;
    const BindingWishes wishes{{{parameter.name, name}}, {}, makes_sense};
    if (sample_binding(source, knowledge, {}, wishes, Rng(0))) usual.insert(name);
  }
}

}  // namespace

std::vector<std::string> categories_with_usual_goals(const Resources& resources, Simulator simulator) {
  std::set<std::string> usual;
  for (const auto& source : resources.templates) {
    const auto& supported = source.simulators;
    if (std::find(supported.begin(), supported.end(), simulator) == supported.end()) continue;
    for (const auto& parameter : source.parameters) {
      if (is_value(parameter) || is_room(parameter) || !speaks_of(source.goal, parameter.name)) continue;
      add_usual(source, parameter, resources, simulator, usual);
    }
  }
  std::vector<std::string> all;
  for (const auto& category : resources.backend(simulator).knowledge.categories()) {
    if (usual.contains(category.name)) all.push_back(category.name);
  }
  return all;
}

}  // namespace unietp
