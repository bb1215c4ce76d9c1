#pragma once

#include <string>

#include "authoring/trial.h"
#include "authoring/why_not.h"

namespace unietp {

/// The gates, one per line, each with its result, and after a rejection the reason, the fact behind it and what would
/// have to change.
std::string verdict_text(const Template& source, Simulator simulator, const BindingVerdict& verdict);

/// "1 of 3 candidates became tasks", why the others did not, and what most likely has to change when none did.
std::string trial_text(const TemplateTrial& trial);

}  // namespace unietp
