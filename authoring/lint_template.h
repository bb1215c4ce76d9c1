#pragma once

#include <string>
#include <vector>

#include "authoring/phrasing_reading.h"
#include "authoring/problem_text.h"
#include "resources/resources.h"

namespace unietp {

/// One template file and its problems.
struct LintedFile {
  std::string path, text;
  std::string name;                   // of the template; "" when the file has errors
  std::vector<LintProblem> problems;  // errors in order of position, then warnings
  struct Phrasing {
    int line = 0;
    PhrasingReading reading;
  };
  std::vector<Phrasing> phrasings = {};  // of a file without errors, in their order
};

/// Reads a template's text and checks what it asks for. Errors: those of parse_template and unknown_categories.
/// Warnings, for a file without errors: a phrasing that lacks a count or an "all" of the goal (phrasing_counts.h); a
/// purpose that is missing or does not fit (purpose_fit.h); a
/// claimed simulator that has no categories for the placeholders, with the constraint that rules out the last ones; one
/// on which the goals of all sampled bindings are impossible, with the reason. Of each phrasing it is found out whether
/// texts in it are read back. Deterministic.
LintedFile lint_template(const std::string& path, std::string text, const std::vector<Backend>& backends);

}  // namespace unietp
