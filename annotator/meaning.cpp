#include "annotator/meaning.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace unietp {
namespace {

using Op = Formula::Op;
using Renaming = std::vector<std::pair<std::string, std::string>>;

std::string renamed(const Renaming& names, const std::string& name) {
  for (auto i = names.rbegin(); i != names.rend(); ++i)
    if (i->first == name) return i->second;
  return name;
}

Formula wrapped(Op op, Formula child) {
  Formula f;
  f.op = op;
  f.children.push_back(std::move(child));
  return f;
}

/// And or Or of the parts, flat and without repeats.
Formula joined(Op op, std::vector<Formula> parts) {
  std::vector<Formula> flat;
  for (Formula& part : parts) {
    if (part.op == op)
      for (Formula& child : part.children) flat.push_back(std::move(child));
    else
      flat.push_back(std::move(part));
  }
  std::vector<Formula> kept;
  for (Formula& part : flat)
    if (std::find(kept.begin(), kept.end(), part) == kept.end()) kept.push_back(std::move(part));
  if (kept.size() == 1) return std::move(kept.front());
  Formula f;
  f.op = op;
  f.children = std::move(kept);
  return f;
}

/// A conjunction whose existential variables stand in front of it; the variables are already named apart.
Formula conjoined(std::vector<Formula> parts) {
  std::vector<std::pair<std::string, Domain>> prefix;
  for (Formula& part : parts)
    while (part.op == Op::Exists) {
      prefix.emplace_back(part.variable, part.domain);
      Formula body = std::move(part.children.front());
      part = std::move(body);
    }
  Formula f = joined(Op::And, std::move(parts));
  for (auto i = prefix.rbegin(); i != prefix.rend(); ++i) f = exists(i->first, i->second, std::move(f));
  return f;
}

class Expansion {
 public:
  Formula expand(const Formula& f, bool negate, bool last) {
    switch (f.op) {
      case Op::Atom:
      case Op::Equal:
        return literal(f, negate, last);
      case Op::And:
      case Op::Or:
        return connective(f, negate, last);
      case Op::Not:
        return expand(f.children[0], !negate, last);
      case Op::Imply: {
        Formula either;
        either.op = Op::Or;
        either.children = {negation(f.children[0]), f.children[1]};
        return expand(either, negate, last);
      }
      case Op::Forall:
      case Op::Exists:
        return quantified(f, (f.op == Op::Forall) != negate ? Op::Forall : Op::Exists, negate, last);
      case Op::Count:
        return count(f, negate, last);
      case Op::CountCompare:
        return comparison(f, negate, last);
      case Op::Number:
        return bound(f, false, last);
      case Op::AtEnd:
        return expand(f.children[0], negate, true);
      case Op::Sometime:
      case Op::Always:
        return over_time(f, negate, last);
      case Op::Until:
      case Op::Before:
        break;
    }
    if (last && f.op == Op::Until) return expand(f.children[1], negate, true);
    Formula result;
    result.op = f.op;
    for (const Formula& child : f.children) result.children.push_back(expand(child, false, false));
    if (last) result = at_end(std::move(result));
    return negate ? negation(std::move(result)) : result;
  }

 private:
  Formula literal(Formula f, bool negate, bool last) const {
    for (Term& term : f.terms)
      if (term.kind == Term::Kind::Variable) term.name = renamed(names_, term.name);
    if (last && f.op == Op::Atom) f = at_end(std::move(f));  // equality does not change with time
    return negate ? negation(std::move(f)) : f;
  }

  Formula connective(const Formula& f, bool negate, bool last) {
    std::vector<Formula> parts;
    for (const Formula& child : f.children) parts.push_back(expand(child, negate, last));
    return (f.op == Op::And) != negate ? conjoined(std::move(parts)) : joined(Op::Or, std::move(parts));
  }

  /// The binder with its variable renamed and its body expanded.
  Formula bound(const Formula& f, bool negate, bool last) {
    Formula result = f;
    result.variable = std::string("v").append(std::to_string(next_++));
    names_.emplace_back(f.variable, result.variable);
    for (Formula& where : result.domain.where) where = expand(where, false, false);
    std::sort(result.domain.members.begin(), result.domain.members.end(), [](const auto& a, const auto& b) {
      return std::tie(a.category, a.slice) < std::tie(b.category, b.slice);
    });
    result.children = {expand(f.children[0], negate, last)};
    names_.pop_back();
    return result;
  }

  Formula quantified(const Formula& f, Op op, bool negate, bool last) {
    Formula result = bound(f, negate, last);
    result.op = op;
    if (op == Op::Exists) return result;
    Formula body = std::move(result.children.front());
    if (body.op == Op::Always) {  // for all x always f: always for all x f
      result.children = {std::move(body.children.front())};
      return wrapped(Op::Always, std::move(result));
    }
    if (body.op != Op::And) {
      result.children = {std::move(body)};
      return result;
    }
    std::vector<Formula> parts;
    for (Formula& child : body.children) {
      Formula part = result;
      part.children = {std::move(child)};
      parts.push_back(std::move(part));
    }
    return joined(Op::And, std::move(parts));
  }

  Formula count(const Formula& f, bool negate, bool last) {
    Comparison comparison = f.comparison;
    int number = f.number;
    if (comparison == Comparison::Greater) comparison = Comparison::AtLeast, ++number;
    if (comparison == Comparison::Less) comparison = Comparison::AtMost, --number;
    if (comparison == Comparison::Equal && number == 0) comparison = Comparison::AtMost;
    if (negate && comparison == Comparison::AtLeast) {
      comparison = Comparison::AtMost, --number, negate = false;
    } else if (negate && comparison == Comparison::AtMost) {
      comparison = Comparison::AtLeast, ++number, negate = false;
    }
    if (comparison == Comparison::AtLeast && number <= 0) return joined(Op::And, {});  // of any domain
    if (comparison == Comparison::AtMost && number < 0) return joined(Op::Or, {});
    if (comparison == Comparison::AtLeast && number == 1) return quantified(f, Op::Exists, false, last);
    if (comparison == Comparison::AtMost && number == 0) return quantified(f, Op::Forall, true, last);
    Formula result = bound(f, false, last);
    result.comparison = comparison;
    result.number = number;
    return negate ? negation(std::move(result)) : result;
  }

  Formula comparison(const Formula& f, bool negate, bool last) {
    Comparison sign = f.comparison;
    std::vector<Formula> sides{bound(f.children[0], false, last), bound(f.children[1], false, last)};
    if (sign == Comparison::Less || sign == Comparison::AtMost) {
      std::swap(sides[0], sides[1]);
      sign = sign == Comparison::Less ? Comparison::Greater : Comparison::AtLeast;
    }
    if (negate && sign != Comparison::Equal) {
      std::swap(sides[0], sides[1]);
      sign = sign == Comparison::Greater ? Comparison::AtLeast : Comparison::Greater;
      negate = false;
    }
    Formula result;
    result.op = Op::CountCompare;
    result.comparison = sign;
    result.children = std::move(sides);
    return negate ? negation(std::move(result)) : result;
  }

  Formula over_time(const Formula& f, bool negate, bool last) {
    if (last) return expand(f.children[0], negate, true);
    const Op op = (f.op == Op::Always) != negate ? Op::Always : Op::Sometime;
    Formula body = expand(f.children[0], negate, false);
    if (op == Op::Sometime) {  // sometime exists x f: exists x sometime f
      if (body.op != Op::Exists) return wrapped(op, std::move(body));
      Formula* inner = &body;
      while (inner->children[0].op == Op::Exists) inner = &inner->children[0];
      inner->children[0] = wrapped(op, std::move(inner->children[0]));
      return body;
    }
    if (body.op != Op::And) return wrapped(op, std::move(body));
    for (Formula& child : body.children) child = wrapped(op, std::move(child));
    return body;
  }

  Renaming names_;
  int next_ = 0;
};

}  // namespace

Formula expanded(const Formula& formula) { return Expansion().expand(formula, false, false); }

Formula without_at_end(const Formula& formula) {
  if (formula.op == Op::AtEnd) return without_at_end(formula.children[0]);
  Formula result = formula;
  for (Formula& child : result.children) child = without_at_end(child);
  return result;
}

bool only_at_end(const Formula& formula) {
  if (formula.op == Op::AtEnd) return true;
  if (formula.op == Op::Atom || is_temporal(formula.op)) return false;
  return std::all_of(formula.children.begin(), formula.children.end(), only_at_end);
}

bool mentions(const Formula& formula, const std::string& variable) {
  for (const Term& term : formula.terms)
    if (term.kind == Term::Kind::Variable && term.name == variable) return true;
  if (formula.variable == variable) return false;
  const auto inside = [&](const Formula& f) { return mentions(f, variable); };
  return std::any_of(formula.domain.where.begin(), formula.domain.where.end(), inside) ||
         std::any_of(formula.children.begin(), formula.children.end(), inside);
}

}  // namespace unietp
