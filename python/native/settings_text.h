#pragma once

#include <string>

#include "environment/settings.h"

namespace unietp::python {

/// The settings that a JSON text asks for. Throws PythonError for text that is not so.
Settings settings_of(const std::string& json);

}  // namespace unietp::python
