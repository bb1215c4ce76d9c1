#include "generator/binding_summary.h"

#include <algorithm>
#include <set>

#include "generator/domain_constraints.h"

namespace unietp {
namespace {

/// Whether what is bound so far can be completed; parameters that are bound are passed over.
bool completable(const Template& source, const Knowledge& knowledge, Binding& binding) {
  for (const auto& parameter : source.parameters) {
    if (bound_to(binding, parameter.name) != nullptr) continue;
    for (const auto& choice : candidates_for(parameter, source.constraints, binding, knowledge)) {
      binding.emplace_back(parameter.name, choice);
      const bool completed = completable(source, knowledge, binding);
      binding.pop_back();
      if (completed) return true;
    }
    return false;
  }
  return true;
}

}  // namespace

BindingSummary summarize_bindings(const Template& source, const Knowledge& knowledge, std::size_t limit) {
  BindingSummary summary;
  for (const auto& parameter : source.parameters)
    summary.fills.emplace_back(parameter.name, std::vector<std::string>{});
  const bool claimed =
      std::find(source.simulators.begin(), source.simulators.end(), knowledge.simulator()) != source.simulators.end();
  if (!claimed) return summary;
  auto bindings = enumerate_bindings(source, knowledge, limit + 1);
  summary.more = bindings.size() > limit;
  if (summary.more) bindings.resize(limit);
  summary.count = bindings.size();
  std::vector<std::set<std::string>> seen(source.parameters.size());
  for (const auto& binding : bindings) {
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i].insert(binding[i].second);
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto& parameter = source.parameters[i];
    if (summary.more) {
      for (const auto& choice : candidates_for(parameter, source.constraints, {}, knowledge)) {
        Binding binding = {{parameter.name, choice}};
        if (!seen[i].contains(choice) && completable(source, knowledge, binding)) seen[i].insert(choice);
      }
    }
    summary.fills[i].second.assign(seen[i].begin(), seen[i].end());
  }
  if (bindings.size() > 3) bindings.resize(3);
  summary.examples = std::move(bindings);
  return summary;
}

}  // namespace unietp
