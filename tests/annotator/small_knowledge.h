#pragma once

#include "annotator/instruction.h"

namespace unietp::testing_support {

/// Mugs, apples, bread, knives and furniture, with one synonym, function and context each where tests need them.
Knowledge small_knowledge();
Specification asking(const std::string& goal, const std::string& style = "direct");

}  // namespace unietp::testing_support
