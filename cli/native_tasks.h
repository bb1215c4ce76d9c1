#pragma once

#include "cli/commands.h"
#include "core/result.h"
#include "resources/resources.h"
#include "run/not_native.h"

namespace unietp {

/// The check of `unietp generate --native`. `resources` must outlive it. Errors: those of native_check.
Result<NotNative> refuse_not_native(const Resources& resources, const CommandLine& program);

}  // namespace unietp
