#pragma once

#include <iosfwd>
#include <set>
#include <string>

#include "authoring/template_draft.h"

namespace unietp {

/// Asks for the sections that are not in `given`, one question at a time, and again for those with errors, which it
/// prints. An empty line ends a question that takes several answers and skips an optional one. Reads lines from `in`,
/// writes questions to `out`. Errors: Usage when `in` ends before the template is valid.
Result<TemplateDraft> ask_template(TemplateDraft draft, const std::set<std::string>& given, std::istream& in,
                                   std::ostream& out);

}  // namespace unietp
