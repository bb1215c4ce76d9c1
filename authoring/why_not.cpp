#include "authoring/why_not.h"

#include <algorithm>

#include "core/text.h"
#include "generator/domain_constraints.h"
#include "generator/propose.h"
#include "generator/weighted_binding.h"
#include "templates/constraint_kinds.h"

namespace unietp {
namespace {

constexpr std::size_t kMostChecked = 200;  // alternative categories that are checked for one placeholder

bool passes(const Template& source, const Knowledge& knowledge, const Binding& binding) {
  return std::holds_alternative<Specification>(propose(source, knowledge, binding));
}

std::optional<Binding> completed(const Template& source, const Knowledge& knowledge, const Binding& given) {
  return sample_binding(source, knowledge, {}, {given, [](const Parameter&, const std::string&) { return 1.0; }, {}},
                        Rng(0));
}

/// "relation has no row (inside, Fridge, Mug)" for a placement constraint that does not hold, and the like.
std::string fact_of(const DomainConstraint& constraint, const Binding& binding, const Knowledge& knowledge) {
  const ConstraintKind& kind = info(constraint.type);
  if (kind.meaning == ConstraintKind::Meaning::Distinct || constraint.arguments.size() < 2) return "";
  std::vector<std::string> bound;
  for (const auto& use : placeholders_of(constraint)) {
    const auto* category = bound_to(binding, use.name);
    bound.push_back(category == nullptr ? use.name : *category + (use.slice ? "/slice" : ""));
  }
  if (bound.size() < 2) return "";
  if (kind.treatment)
    return "effect has no row (" + bound[0] + ", " + std::string(name_of(*kind.treatment)) + ", " + bound[1] + ")";
  if (!kind.relation) return "";
  const std::string word(info(*kind.relation).name);
  const auto* row = knowledge.placement(bound[0], *kind.relation, bound[1]);
  if (row == nullptr) return "relation has no row (" + word + ", " + bound[0] + ", " + bound[1] + ")";
  return "relation allows " + std::to_string(row->capacity) + " " + bound[0] + " fit " + word + " " + bound[1] +
         "; the template requires " + std::to_string(capacity_of(constraint));
}

std::string nearest_category(const std::string& name, const Knowledge& knowledge) {
  std::vector<std::string> names = room_types(knowledge);
  for (const auto& category : knowledge.categories()) names.push_back(category.name);
  return nearest_name(name, names);
}

std::string fact_behind(const GateRefusal& refusal, const Template& source, const Knowledge& knowledge,
                        const Binding& binding) {
  if (refusal.gate == Gate::Placeholder) {
    const auto* category = bound_to(binding, refusal.about);
    const auto near = category == nullptr ? std::string() : nearest_category(*category, knowledge);
    return near.empty() ? "" : "did you mean \"" + near + "\"";
  }
  if (refusal.gate != Gate::Constraint) return "";
  for (const auto& constraint : source.constraints) {
    if (to_text(constraint, binding) == refusal.about && !satisfies(constraint, binding, knowledge))
      return fact_of(constraint, binding, knowledge);
  }
  return "";
}

/// Categories that, bound to one placeholder, make the binding pass all gates.
OtherCategories alternative_for(const Parameter& parameter, const Template& source, const Knowledge& knowledge,
                                const Binding& binding) {
  auto others = binding;
  std::erase_if(others, [&](const auto& one) { return one.first == parameter.name; });
  OtherCategories found{parameter.name, {}};
  std::size_t checked = 0;
  for (const auto& category : candidates_for(parameter, source.constraints, others, knowledge)) {
    if (checked++ == kMostChecked) break;
    Binding trial;
    for (const auto& each : source.parameters) {
      const auto* kept = each.name == parameter.name ? &category : bound_to(others, each.name);
      if (kept != nullptr) trial.emplace_back(each.name, *kept);
    }
    if (passes(source, knowledge, trial)) found.categories.push_back(category);
  }
  return found;
}

}  // namespace

BindingVerdict why_not(const Template& source, const Knowledge& knowledge, const Binding& given) {
  BindingVerdict verdict{given, std::nullopt, "", {}};
  if (given.size() < source.parameters.size()) {
    if (auto whole = completed(source, knowledge, given)) verdict.binding = std::move(*whole);
  }
  auto proposed = propose(source, knowledge, verdict.binding);
  auto* refusal = std::get_if<GateRefusal>(&proposed);
  if (refusal == nullptr) return verdict;
  verdict.refusal = std::move(*refusal);
  verdict.fact = fact_behind(*verdict.refusal, source, knowledge, verdict.binding);
  if (verdict.refusal->gate == Gate::Simulator) return verdict;  // no category helps
  for (const auto& parameter : source.parameters) {
    auto alternative = alternative_for(parameter, source, knowledge, verdict.binding);
    if (!alternative.categories.empty()) verdict.alternatives.push_back(std::move(alternative));
  }
  return verdict;
}

}  // namespace unietp
