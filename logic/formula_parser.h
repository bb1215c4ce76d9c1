#pragma once

#include <optional>
#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// Parses one formula and collects all errors in it. A member that returns nullopt has added at least one error.
class FormulaParser {
 public:
  /// What a variable may stand for, as far as its domain says; a category may be of objects or of rooms.
  enum class Sort { Unknown, Object, Room, Agent };

  /// What is accepted at a position of a formula.
  struct Place {
    bool predicates = true;
    bool temporal = true;
    bool where = true;          // a `:where` may be written here
    bool inside_where = false;  // named in error messages
  };

  FormulaParser(std::string_view where, const std::vector<std::string>& bound);

  /// The formula that an expression says; nullopt after an error, which is kept in the list.
  std::optional<Formula> formula(const Sexpr& expression, const Place& place);
  /// All errors so far, in the order in which they were met.
  std::vector<Error> take_errors() { return std::move(errors_); }

 private:
  struct Variable {
    std::string name;
    Sort sort = Sort::Unknown;
  };

  std::nullopt_t note(const Sexpr& at, std::string message);
  bool has_parts(const Sexpr& expression, std::size_t count, std::string_view form);
  const Variable* find(std::string_view name) const;
  std::string unbound(const std::string& name) const;

  std::optional<Formula> operation(Formula::Op op, const Sexpr& expression, const Place& place);
  std::optional<Formula> with_parts(Formula::Op op, const Sexpr& expression, const Place& place);
  std::optional<Formula> fixed_parts(Formula::Op op, std::size_t count, std::string_view form, const Sexpr& expression,
                                     const Place& place);
  std::optional<Formula> equality(const Sexpr& expression);
  std::optional<Formula> predicate_atom(const PredicateInfo& predicate, const Sexpr& expression, const Place& place);
  std::optional<Term> argument(const PredicateInfo& predicate, std::size_t index, const Sexpr& expression);
  std::optional<Term> variable_term(const Sexpr& expression, std::string_view place_name, std::string_view example);

  std::optional<Formula> quantifier(Formula::Op op, const Sexpr& expression, const Place& place);
  std::optional<Formula> number(const Sexpr& expression, const Place& place);
  std::optional<Formula> count(const Sexpr& expression, const Place& place);
  std::optional<Formula> count_with_number(Comparison comparison, const Sexpr& expression, const Place& place);
  /// `(?x - D)` is read, then the body with ?x in scope; `body` may be null when there is none to read.
  std::optional<Formula> with_binder(Formula::Op op, const Sexpr& binder, const Sexpr* body, const Place& place);

  std::optional<Domain> domain(const Sexpr& expression, const std::string& variable, const Place& place);
  std::optional<Domain> domain_with_where(const Sexpr& expression, const std::string& variable, const Place& place);
  std::optional<Domain> either(const Sexpr& expression);
  std::optional<Domain::Member> category(const Sexpr& expression);

  std::string where_;
  std::vector<Variable> scope_;
  std::vector<Error> errors_;
};

// Helpers for error messages.
std::string quoted(std::string_view word);
/// The source in short: "'(open …)'".
std::string shown(const Sexpr& expression);
/// Whether an expression is a word that begins with `?`.
bool is_variable(const Sexpr& expression);
/// "(inside ?x ?y)"
std::string example_of(const PredicateInfo& predicate);

}  // namespace unietp
