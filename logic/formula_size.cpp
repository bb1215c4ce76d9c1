#include "logic/formula_size.h"

#include <algorithm>

#include "core/limits.h"

namespace unietp {
namespace {

struct FormulaSize {
  int parts = 0, quantifiers = 0, temporal = 0;  // the last two: in one another
};

FormulaSize size_of(const Formula& formula) {
  FormulaSize size;
  const auto add = [&](const Formula& part) {
    const FormulaSize own = size_of(part);
    size.parts += own.parts;
    size.quantifiers = std::max(size.quantifiers, own.quantifiers);
    size.temporal = std::max(size.temporal, own.temporal);
  };
  for (const Formula& child : formula.children) add(child);
  for (const Formula& where : formula.domain.where) add(where);
  size.parts += 1 + static_cast<int>(formula.terms.size() + formula.domain.members.size());
  size.quantifiers += formula.variable.empty() ? 0 : 1;
  size.temporal += is_temporal(formula.op) ? 1 : 0;
  return size;
}

}  // namespace

std::string excess_of(const Formula& formula) {
  const FormulaSize size = size_of(formula);
  const auto excess = [](int count, const char* what, int most) {
    return "has " + std::to_string(count) + " " + what + "; accepted are at most " + std::to_string(most);
  };
  if (size.parts > limits::kFormulaParts) return excess(size.parts, "parts", limits::kFormulaParts);
  if (size.quantifiers > limits::kQuantifiers)
    return excess(size.quantifiers, "quantifiers in one another", limits::kQuantifiers);
  if (size.temporal > limits::kTemporal)
    return excess(size.temporal, "temporal operators in one another", limits::kTemporal);
  return "";
}

double combinations_of(const Formula& formula, const std::function<double(const Domain&)>& members) {
  double inner = 1;
  for (const Formula& child : formula.children) inner += combinations_of(child, members);
  for (const Formula& where : formula.domain.where) inner += combinations_of(where, members);
  return formula.variable.empty() ? inner : inner * std::max(1.0, members(formula.domain));
}

}  // namespace unietp
