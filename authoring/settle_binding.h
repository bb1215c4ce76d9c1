#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "resources/resources.h"

namespace unietp {

/// `--bind`, and what else the command said of the run.
struct BindingRequest {
  std::vector<std::string> categories;  // "A=Mug"
  bool count_given = false, splits_given = false, simulators_given = false;
};

/// Makes a configuration ask for a binding of its one template. What the command left open becomes: the simulators that
/// know the categories and whose gates let the binding pass, the split of the template's tasks, one task on each.
/// Gives what the gates said when they refuse the binding (on any of the simulators that the command named, or on all),
/// and "" when the run can begin. Errors: those of read_binding; Usage when not exactly one template is named.
Result<std::string> settle_binding(const BindingRequest& request, const Resources& resources,
                                   RunConfiguration& configuration);

}  // namespace unietp
