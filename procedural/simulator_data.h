#pragma once

#include <memory>

#include "core/result.h"
#include "environment/task.h"
#include "resources/resources.h"

namespace unietp {

/// What environments need of the resources, which stay alive as long as something of it is used.
AllSimulatorData simulator_data(const std::shared_ptr<const Resources>& resources);

}  // namespace unietp
