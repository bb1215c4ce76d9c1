#pragma once

#include <vector>

#include "generator/style.h"
#include "templates/template.h"

namespace unietp {

/// The styles in which a template's tasks of the Linguistic split can be worded, by the form of its goal: the one that
/// the template names itself, or else all that refine_linguistic can give it with fitting categories in a fitting home.
/// In the order of Style.
std::vector<Style> styles_fitting(const Template& source);

}  // namespace unietp
