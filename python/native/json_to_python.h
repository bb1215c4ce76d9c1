#pragma once

#include <nanobind/nanobind.h>
#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace unietp::python {

/// None, bool, int, float, str, list and dict, as json.loads of the text would give them. Needs the interpreter's lock.
nanobind::object to_python(const nlohmann::ordered_json& json);
/// A str. What is no UTF-8 becomes U+FFFD. Needs the interpreter's lock.
nanobind::object text_to_python(std::string_view text);

}  // namespace unietp::python
