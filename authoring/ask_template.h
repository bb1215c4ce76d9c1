#pragma once

#include <iosfwd>
#include <set>
#include <string>

#include "authoring/template_draft.h"

namespace unietp {

/// Asks for the sections that are not in `given`, one question at a time, and again for those whose answers are wrong,
/// with what is wrong. A question that takes several answers ends with an empty line; one that may be left out is left
/// out by it. Reads lines from `in`, writes questions to `out`.
/// Errors: Usage when `in` ends before the template is sound.
Result<TemplateDraft> ask_template(TemplateDraft draft, const std::set<std::string>& given, std::istream& in,
                                   std::ostream& out);

}  // namespace unietp
