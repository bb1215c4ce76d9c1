#include <algorithm>

#include "logic/formula.h"

namespace unietp {
namespace {

const NameBinding* find(const std::vector<NameBinding>& bindings, const std::string& name) {
  const auto at = std::find_if(bindings.begin(), bindings.end(), [&](const auto& b) { return b.name == name; });
  return at == bindings.end() || at->values.empty() ? nullptr : &*at;
}

Domain substitute_names(const Domain& domain, const std::vector<NameBinding>& bindings) {
  Domain result;
  result.kind = domain.kind;
  const auto add = [&](Domain::Member member) {
    const bool known = std::find(result.members.begin(), result.members.end(), member) != result.members.end();
    if (!known) result.members.push_back(std::move(member));
  };
  for (const auto& member : domain.members) {
    if (const auto* binding = find(bindings, member.category)) {
      for (const auto& value : binding->values) add({value, member.slice});
    } else {
      add(member);
    }
  }
  for (const auto& where : domain.where) result.where.push_back(unietp::substitute_names(where, bindings));
  return result;
}

/// One symbol with several values: one of them is enough.
Formula substitute_symbols(const Formula& atom, const std::vector<NameBinding>& bindings) {
  for (std::size_t i = 0; i < atom.terms.size(); ++i) {
    if (atom.terms[i].kind != Term::Kind::Symbol) continue;
    const auto* binding = find(bindings, atom.terms[i].name);
    if (binding == nullptr) continue;
    std::vector<Formula> choices;
    for (const auto& value : binding->values) {
      Formula choice = atom;
      choice.terms[i].name = value;
      choices.push_back(std::move(choice));
    }
    if (choices.size() == 1) return std::move(choices.front());
    Formula any;
    any.op = Formula::Op::Or;
    any.children = std::move(choices);
    return any;
  }
  return atom;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

Formula substitute_names(const Formula& formula, const std::vector<NameBinding>& bindings) {
  if (formula.op == Formula::Op::Atom) return substitute_symbols(formula, bindings);
  Formula result = formula;
  result.domain = substitute_names(formula.domain, bindings);
  for (auto& child : result.children) child = substitute_names(child, bindings);
  return result;
}

Formula rename_variable(const Formula& formula, const std::string& from, const std::string& to) {
  if (from == to || !contains(free_variables(formula), from)) return formula;
  Formula result = formula;
  for (auto& term : result.terms) {
    if (term.kind == Term::Kind::Variable && term.name == from) term.name = to;
  }
  const auto rename_below = [&result](const std::string& old_name, const std::string& new_name) {
    for (auto& where : result.domain.where) where = rename_variable(where, old_name, new_name);
    for (auto& child : result.children) child = rename_variable(child, old_name, new_name);
  };
  if (result.variable == to) {  // would capture the new name: give the bound one another
    std::string fresh = to + "_";
    while (fresh == from || contains(free_variables(formula), fresh)) fresh += '_';
    rename_below(to, fresh);
    result.variable = fresh;
  }
  rename_below(from, to);
  return result;
}

}  // namespace unietp
