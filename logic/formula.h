#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "core/sexpr.h"
#include "logic/vocabulary.h"

namespace unietp {

/// What stands in a place of a predicate: a variable (`?x`), the constant `agent`, or a symbol (`water`, `red`).
struct Term {
  enum class Kind { Variable, Agent, Symbol };
  Kind kind = Kind::Variable;
  std::string name;  // "x" for ?x (without the mark); the symbol; "agent"
  bool operator==(const Term&) const = default;
};

struct Formula;

/// The objects a variable ranges over: those of the trace's whole length, or, with `where`, those of its first state
/// that satisfy `where` there.
struct Domain {
  enum class Kind { Categories, Object, Room, Agent };
  struct Member {
    std::string category;  // or a template's placeholder, before binding
    bool slice = false;    // `A/slice`: what slicing an A makes
    bool operator==(const Member&) const = default;
  };
  Kind kind = Kind::Categories;
  std::vector<Member> members;  // Kind::Categories: one, or several for `(either A B)`
  std::vector<Formula> where;   // none or one: `(A :where f)`, read in the first state with the bound variable itself
  bool operator==(const Domain&) const;
};

enum class Comparison { Equal, AtLeast, AtMost, Greater, Less };  // how two counts of a goal compare

/// A goal or constraint as a tree. One struct for all forms: which fields are used is said at each operator; the
/// builders below keep that. Text form: S-expressions, `parse_formula` and `to_text` are inverse.
struct Formula {
  enum class Op {
    Atom,          // predicate, terms
    Equal,         // terms: two
    And,           // children: any number; empty is true
    Or,            // children: any number; empty is false
    Not,           // children: one
    Imply,         // children: premise, conclusion
    Forall,        // variable, domain, children: body
    Exists,        // variable, domain, children: body
    Count,         // comparison, variable, domain, children: body; compared with `number`
    CountCompare,  // comparison, children: two Number formulas
    Number,        // variable, domain, children: body; only as a child of CountCompare
    AtEnd,         // children: one
    Sometime,      // children: one
    Always,        // children: one
    Until,         // children: f, g
    Before,        // children: f, g
  };
  Op op = Op::And;
  Predicate predicate = Predicate::Open;
  std::vector<Term> terms;
  std::string variable;
  Domain domain;
  Comparison comparison = Comparison::Equal;
  int number = 0;
  std::vector<Formula> children;
  bool operator==(const Formula&) const;
};

/// True for at-end, sometime, always, until and before.
bool is_temporal(Formula::Op op);

// Builders.
Formula atom(Predicate predicate, std::vector<std::string> variables);  // names of variables; for symbols see below
/// An atom whose last place is a symbol: (filled ?x water).
Formula atom_with_symbol(Predicate predicate, std::string variable, std::string symbol);
Formula conjunction(std::vector<Formula> parts);  // one part stays itself
Formula negation(Formula part);
Formula exists(std::string variable, Domain domain, Formula body);
Formula forall(std::string variable, Domain domain, Formula body);
Formula at_end(Formula part);
/// The objects of one category.
Domain of_category(std::string category);

/// Where a formula is going to be used decides what is accepted.
enum class FormulaUse {
  Goal,   // read on a trace: every predicate stands under a temporal operator (or inside a :where)
  State,  // read in one state: no temporal operator at all; `:where` is refused too
};

/// Parses the text form (the table in docs/logic.md).
/// Errors: Parse with file, line, column, what is accepted and the nearest known name: unknown operator or predicate,
/// wrong number or kind of arguments, unbound variable, a variable bound twice in one scope, a bad comparison or
/// number, a state formula outside any temporal operator (Goal), a temporal operator (State).
Result<Formula> parse_formula(std::string_view where, std::string_view text, FormulaUse use);
/// The same from an expression that is part of a larger file (a template). `bound` are variables bound outside.
Result<Formula> parse_formula(std::string_view where, const Sexpr& expression, FormulaUse use,
                              const std::vector<std::string>& bound = {});

/// Canonical one-line text; parse_formula(to_text(f)) == f.
std::string to_text(const Formula& formula);
/// A domain as it stands in a quantifier: "Mug", "(either Mug Cup)", "(Mug :where (dirty ?x))".
std::string to_text(const Domain& domain);
std::string_view symbol_of(Comparison comparison);  // ">="

/// Every category (or placeholder) that a domain of the formula names, sorted, without repeats; `A/slice` counts as A.
std::vector<std::string> categories_of(const Formula& formula);
/// Free variables in order of first use.
std::vector<std::string> free_variables(const Formula& formula);
/// The first quantifier of a variable, also within a `:where`; nullptr when the formula binds none of that name. It
/// points into the formula.
const Formula* binder_of(const Formula& formula, const std::string& variable);

/// Replaces domain names and symbols (a template's placeholders) by what they are bound to; several categories make an
/// `either`. Names without an entry stay.
struct NameBinding {
  std::string name;
  std::vector<std::string> values;
};
/// Also in nested domains.
Formula substitute_names(const Formula& formula, const std::vector<NameBinding>& bindings);
/// Renames a free variable.
Formula rename_variable(const Formula& formula, const std::string& from, const std::string& to);

/// A form that is equal for formulas that differ only in the names of bound variables, the order and nesting of
/// and/or, double negation, and the order of neighboring quantifiers of one kind. Equal normal forms mean the same;
/// the converse is not claimed.
Formula normal_form(const Formula& formula);

}  // namespace unietp
