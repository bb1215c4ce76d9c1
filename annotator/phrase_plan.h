#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "annotator/clause.h"
#include "annotator/home_counts.h"
#include "core/result.h"

namespace unietp {

/// Plans how a text refers to the objects of a goal, by noun and description in the start, and what it says about them.
/// The first part of the goal without words is the error.
class PhrasePlanner {
 public:
  using Scope = std::map<std::string, Domain>;

  /// Where the home or `start` has exactly two of something, a phrase may say "both".
  explicit PhrasePlanner(const std::vector<Formula>& start, HomeCounts home = {});

  /// Variables that denote one object throughout the current clause.
  Scope& scope() { return scope_; }
  const Scope& scope() const { return scope_; }

  const std::optional<Error>& error() const { return error_; }  // the first failure
  void fail(const Formula& part);                               // keeps the first: no sentence says this part
  /// Clears the error; returns whether there was one.
  bool clear_error();

  /// The phrase for a free variable, described by what `context` says of it.
  NounPhrase reference(const std::string& variable, const Formula& context);
  /// What a quantifier binds.
  NounPhrase quantified(const Formula& binder, Determiner determiner);
  /// What `f` says of the variable, when that is one state or relation. `local`: how an object bound inside is named.
  std::optional<Complement> complement(const Formula& f, const std::string& variable, Determiner local);
  /// All that `f` says of the variable, joined by and or by or.
  bool complements(const Formula& f, const std::string& variable, Clause& into);
  static Determiner counted(const Formula& f);
  /// Of how many of what `binder` binds `said` is so at the start of the home; 0 also where that is not known.
  std::size_t there_now(const Formula& binder, Formula said) const;
  /// What is said of the variable, one by one: `expanded` has pulled the quantifiers to the front.
  static std::vector<Formula> scattered(const Formula& f, const std::string& variable);

 private:
  void describe(NounPhrase& phrase, const Domain& domain, const std::string& variable);
  std::optional<Complement> converse(const Formula& f, const std::string& variable);

  HomeCounts home_;
  std::set<std::string> pairs_;  // of what the start has exactly two of
  Scope scope_;
  std::optional<Error> error_;
};

}  // namespace unietp
