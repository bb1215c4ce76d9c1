#pragma once

#include <string>
#include <string_view>

#include "core/error.h"

namespace unietp {

/// Something that lint has to say of a file: an error, or a warning about what is accepted and yet doubtful.
struct LintProblem {
  Error error;
  bool warning = false;
  bool operator==(const LintProblem&) const = default;
};

/// The message, and below it the line of the source with a caret under the place:
///
///   mug.template:4:10: parse error: unknown operator or predicate 'opn'; did you mean 'open'?
///      4 |   (goal (opn ?a))
///        |          ^
///
/// Only the message when the place is not in `source`. A long line is cut around the place; what cannot be printed
/// becomes a dot. With `colour` the severity and the caret are coloured for a terminal.
std::string problem_text(const LintProblem& problem, std::string_view source, bool colour);

/// Line `number` (from 1) of a text without its end; "" when there is none.
std::string_view line_of(std::string_view text, int number);

}  // namespace unietp
