#include "authoring/binding_request.h"

#include <algorithm>

#include "authoring/verdict_text.h"
#include "run/given_binding.h"

namespace unietp {

Result<std::string> apply_binding_request(const BindingRequest& request, const Resources& resources,
                                          RunConfiguration& configuration) {
  if (configuration.templates.size() != 1)
    return Error{Error::Kind::Usage, "--bind", {}, "needs exactly one template: --template NAME"};
  const auto source = std::find_if(resources.templates.begin(), resources.templates.end(),
                                   [&](const Template& one) { return one.name == configuration.templates.front(); });
  if (source == resources.templates.end()) return std::string();  // plan_slots reports it, with the nearest name
  auto binding = read_binding(request.categories, *source);
  if (!binding) return binding.error();
  configuration.binding = std::move(*binding);
  if (!request.splits_given) configuration.splits = {split_of_tasks(*source)};
  if (!request.simulators_given)
    configuration.simulators = simulators_for(*source, configuration.binding, resources.backends);

  std::vector<Simulator> passing;
  std::string rejections;
  for (const auto simulator : configuration.simulators) {
    const auto verdict = why_not(*source, resources.backend(simulator).knowledge, configuration.binding);
    if (verdict.refusal) {
      rejections += verdict_text(*source, simulator, verdict);
    } else {
      passing.push_back(simulator);
    }
  }
  if (passing.empty() || (request.simulators_given && !rejections.empty())) return rejections;
  configuration.simulators = std::move(passing);
  if (!request.count_given) configuration.count = static_cast<int>(configuration.simulators.size());
  return std::string();
}

}  // namespace unietp
