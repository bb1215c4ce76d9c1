#pragma once

#include <string>
#include <vector>

#include "authoring/problem_text.h"
#include "resources/resources.h"

namespace unietp {

/// What is to say of one template file.
struct LintedFile {
  std::string path, text;
  std::string name;                   // of the template; "" when the file is refused
  std::vector<LintProblem> problems;  // errors in order of position, then warnings
};

/// Reads a template's text and looks at what it asks for. Errors: those of parse_template and unknown_categories.
/// Warnings, for a file without errors: a phrasing that does not say a count or "all" that the goal has
/// (phrasing_counts.h); a claimed simulator that has no categories for the placeholders, with the constraint that takes
/// the last away; one on which no goal of some bindings can be asked for, with the reason. Deterministic.
LintedFile lint_template(const std::string& path, std::string text, const std::vector<Backend>& backends);

}  // namespace unietp
