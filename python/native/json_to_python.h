#pragma once

#include <nanobind/nanobind.h>
#include <nlohmann/json_fwd.hpp>

namespace unietp::python {

/// None, bool, int, float, str, list and dict, as json.loads of the text would give them. Needs the interpreter's lock.
nanobind::object to_python(const nlohmann::ordered_json& json);

}  // namespace unietp::python
