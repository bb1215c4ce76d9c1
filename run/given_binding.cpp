#include "run/given_binding.h"

#include <algorithm>

#include "core/text.h"
#include "generator/domain_constraints.h"

namespace unietp {
namespace {

Error usage(std::string message) { return {Error::Kind::Usage, "--bind", {}, std::move(message)}; }

}  // namespace

Result<Binding> read_binding(const std::vector<std::string>& texts, const Template& source) {
  std::vector<std::string> placeholders;
  for (const auto& parameter : source.parameters) placeholders.push_back(parameter.name);
  Binding given;
  for (const auto& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
      return usage("\"" + text + "\" is not a binding; expected PLACEHOLDER=CATEGORY, such as " +
                   (placeholders.empty() ? "A" : placeholders.front()) + "=Mug");
    const auto name = text.substr(0, equals);
    if (std::find(placeholders.begin(), placeholders.end(), name) == placeholders.end()) {
      const auto near = nearest_name(name, placeholders);
      return usage(source.name + " has no placeholder \"" + name + "\"" +
                   (near.empty() ? "" : ", did you mean \"" + near + "\"") + "; it has " + join(placeholders, ", "));
    }
    if (bound_to(given, name) != nullptr) return usage("placeholder " + name + " is given twice");
    given.emplace_back(name, text.substr(equals + 1));
  }
  Binding ordered;
  for (const auto& name : placeholders) {
    if (const auto* category = bound_to(given, name)) ordered.emplace_back(name, *category);
  }
  return ordered;
}

std::string to_text(const Binding& binding) {
  std::vector<std::string> parts;
  for (const auto& [placeholder, category] : binding) parts.push_back(placeholder + "=" + category);
  return join(parts, ", ");
}

std::vector<Simulator> simulators_for(const Template& source, const Binding& binding,
                                      const std::vector<Backend>& backends) {
  std::vector<Simulator> found;
  for (const auto simulator : source.simulators) {
    const auto& knowledge = backends[static_cast<std::size_t>(simulator)].knowledge;
    const bool all = std::all_of(source.parameters.begin(), source.parameters.end(), [&](const Parameter& parameter) {
      const auto* given = bound_to(binding, parameter.name);
      return given == nullptr || knowledge.find(*given) != nullptr || affords(parameter, *given, knowledge);
    });
    if (all) found.push_back(simulator);
  }
  return found.empty() ? source.simulators : found;
}

}  // namespace unietp
