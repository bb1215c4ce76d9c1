#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "resources/resources.h"

namespace unietp {

/// `--bind`, and which other options of the run were given.
struct BindingRequest {
  std::vector<std::string> categories;  // "A=Mug"
  bool count_given = false, splits_given = false, simulators_given = false;
};

/// Puts the binding of its one template into a configuration. Defaults for options that were not given: the simulators
/// that have the categories and whose gates accept the binding, the split of the template's tasks, and one task per
/// simulator. Returns the message of the gates when they reject the binding (on any simulator that was named, or on
/// all), and "" when the run can start. Errors: those of read_binding; Usage when not exactly one template is named.
Result<std::string> apply_binding_request(const BindingRequest& request, const Resources& resources,
                                          RunConfiguration& configuration);

}  // namespace unietp
