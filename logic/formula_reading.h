#pragma once

#include <optional>

#include "logic/formula.h"

namespace unietp {

/// A formula, or everything that is wrong with it.
struct FormulaReading {
  std::optional<Formula> formula;  // empty when there are errors
  std::vector<Error> errors;       // in order of position
};

/// As parse_formula, but goes on after an error: with the next part of the same brackets, with an operator's parts when
/// only their number is wrong, with a quantifier's body when only its domain is. What depends on the faulty part (the
/// arguments of an unknown predicate) is skipped, so that no error merely follows from another.
FormulaReading read_formula(std::string_view where, const Sexpr& expression, FormulaUse use,
                            const std::vector<std::string>& bound = {});

}  // namespace unietp
