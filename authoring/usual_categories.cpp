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

/// The placeholders for categories that the goal is about, with their templates, of what supports the simulator.
struct Placeholder {
  const Template& source;
  const Parameter& parameter;
};
std::vector<Placeholder> placeholders_on(const Resources& resources, Simulator simulator) {
  std::vector<Placeholder> placeholders;
  for (const auto& source : resources.templates) {
    const auto& supported = source.simulators;
    if (std::find(supported.begin(), supported.end(), simulator) == supported.end()) continue;
    for (const auto& parameter : source.parameters) {
      if (!is_value(parameter) && !is_room(parameter) && speaks_of(source.goal, parameter.name))
        placeholders.push_back({source, parameter});
    }
  }
  return placeholders;
}

bool is_usual(const Placeholder& placeholder, const std::string& category, const Resources& resources,
              Simulator simulator) {
  const BindingWishes wishes{
      {{placeholder.parameter.name, category}}, {}, at_least(Grade::Usual, placeholder.source, resources, simulator)};
  return sample_binding(placeholder.source, resources.backend(simulator).knowledge, {}, wishes, Rng(0)).has_value();
}

std::vector<std::string> candidates_of(const Placeholder& placeholder, const Knowledge& knowledge) {
  return candidates_for(placeholder.parameter, placeholder.source.constraints, {}, knowledge, nullptr);
}

}  // namespace

std::vector<std::string> categories_with_usual_goals(const Resources& resources, Simulator simulator) {
  const auto& knowledge = resources.backend(simulator).knowledge;
  std::set<std::string> usual;
  for (const Placeholder& placeholder : placeholders_on(resources, simulator)) {
    for (const auto& name : candidates_of(placeholder, knowledge)) {
      if (!usual.contains(name) && is_usual(placeholder, name, resources, simulator)) usual.insert(name);
    }
  }
  std::vector<std::string> all;
  for (const auto& category : knowledge.categories()) {
    if (usual.contains(category.name)) all.push_back(category.name);
  }
  return all;
}

std::map<std::string, std::vector<std::string>> templates_of_one_category(const Resources& resources,
                                                                          Simulator simulator) {
  const auto& knowledge = resources.backend(simulator).knowledge;
  std::map<std::string, std::vector<std::string>> of_one;
  for (const Placeholder& placeholder : placeholders_on(resources, simulator)) {
    std::vector<std::string> usual;
    for (const auto& name : candidates_of(placeholder, knowledge)) {
      if (usual.size() < 2 && is_usual(placeholder, name, resources, simulator)) usual.push_back(name);
    }
    if (usual.size() != 1 || !knowledge.find(usual.front())->movable) continue;
    auto& names = of_one[usual.front()];
    if (names.empty() || names.back() != placeholder.source.name) names.push_back(placeholder.source.name);
  }
  return of_one;
}

std::vector<std::string> templates_with_usual_goals(const std::string& category, const Resources& resources,
                                                    Simulator simulator) {
  std::vector<std::string> names;
  for (const Placeholder& placeholder : placeholders_on(resources, simulator)) {
    if (!names.empty() && names.back() == placeholder.source.name) continue;
    const auto candidates = candidates_of(placeholder, resources.backend(simulator).knowledge);
    if (std::find(candidates.begin(), candidates.end(), category) == candidates.end()) continue;
    if (is_usual(placeholder, category, resources, simulator)) names.push_back(placeholder.source.name);
  }
  return names;
}

}  // namespace unietp
