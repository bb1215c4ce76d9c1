#pragma once

#include <string>
#include <string_view>

#include "core/error.h"

namespace unietp {

/// An error in a file, or a warning about something that is accepted but likely a mistake.
struct LintProblem {
  Error error;
  bool warning = false;
  bool operator==(const LintProblem&) const = default;
};

/// The message, and below it the line of the source with a caret under the position:
///
///   mug.template:4:10: parse error: unknown operator or predicate 'opn'; did you mean 'open'?
///      4 |   (goal (opn ?a))
///        |          ^
///
/// Only the message when the position is not in `source`. A long line is cut around the position; unprintable bytes
/// become dots. With `color` the severity and the caret are colored for a terminal.
std::string problem_text(const LintProblem& problem, std::string_view source, bool color);

/// Line `number` (from 1) of a text without its end; "" when there is none.
std::string_view line_of(std::string_view text, int number);

}  // namespace unietp
