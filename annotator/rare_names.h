#pragma once

#include <string_view>

#include "annotator/everyday_names.h"

namespace unietp {

/// Whether a text may use a synonym of the knowledge base: false for what only a dictionary, a shop or the other
/// English says.
bool is_said(std::string_view synonym, English english);

}  // namespace unietp
