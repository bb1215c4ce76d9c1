#include <algorithm>

#include "logic/formula.h"
#include "logic/formula_parser.h"
#include "logic/formula_reading.h"
#include "logic/formula_size.h"

namespace unietp {

FormulaReading read_formula(std::string_view where, const Sexpr& expression, FormulaUse use,
                            const std::vector<std::string>& bound) {
  const bool goal = use == FormulaUse::Goal;
  FormulaParser parser(where, bound);
  auto formula = parser.formula(expression, {!goal, goal, goal, false});
  auto errors = parser.take_errors();
  if (const auto excess = formula ? excess_of(*formula) : ""; !excess.empty())
    errors.push_back({Error::Kind::Parse, std::string(where), expression.pos, "the formula " + excess});
  if (!errors.empty()) formula.reset();
  std::stable_sort(errors.begin(), errors.end(), [](const Error& a, const Error& b) {
    return a.pos.line != b.pos.line ? a.pos.line < b.pos.line : a.pos.column < b.pos.column;
  });
  return {std::move(formula), std::move(errors)};
}

Result<Formula> parse_formula(std::string_view where, const Sexpr& expression, FormulaUse use,
                              const std::vector<std::string>& bound) {
  auto reading = read_formula(where, expression, use, bound);
  if (!reading.formula) return std::move(reading.errors.front());
  return std::move(*reading.formula);
}

Result<Formula> parse_formula(std::string_view where, std::string_view text, FormulaUse use) {
  const auto expression = read_sexpr(where, text);
  if (!expression) return expression.error();
  return parse_formula(where, *expression, use);
}

}  // namespace unietp
