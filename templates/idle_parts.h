#pragma once

#include <vector>

#include "templates/template_checks.h"

namespace unietp {

/// Parts of a template that say nothing or the same again, which nobody writes on purpose: a word, constraint, start
/// constraint, part of a formula or phrasing that stands twice; a variable of the goal that its quantifier's body does
/// not use; `any` beside other words; a number written with leading zeros; a text without words or over several lines.
/// Errors: Schema, all of them, in order of sections.
std::vector<Error> idle_parts(const TemplateSource& source);

}  // namespace unietp
