#pragma once

#include <nanobind/nanobind.h>

#include "environment/observation.h"
#include "environment/settings.h"

namespace unietp::python {

/// An observation as dicts, lists, str, int, float, bool and None: what json.loads of observation_to_json would give,
/// in objects that nothing else holds. Needs the interpreter's lock.
nanobind::object readable(const Observation& observation, const Settings& settings);

}  // namespace unietp::python
