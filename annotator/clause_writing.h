#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "annotator/clause.h"
#include "annotator/naming.h"
#include "core/rng.h"

namespace unietp {

/// "a, b and c"
std::string listed(const std::vector<std::string>& parts, const char* word);

/// Words clauses, without frame or full stop: as statements ("every fridge is closed") and as commands ("put a mug on a
/// table"). Objects are named as the text goes. `nullopt`: the drawn words would be ambiguous.
class ClauseWriter {
 public:
  ClauseWriter(Naming& naming, Rng& rng) : naming_(naming), rng_(rng) {}

  /// `be`: "is", "should be", …
  std::optional<std::string> statement(const Clause& clause, const std::string& be);
  /// An imperative.
  std::optional<std::string> command(const Clause& clause);
  /// "keep every fridge closed"
  std::optional<std::string> keeping(const Clause& clause);
  /// " if a fridge is open", or nothing.
  std::optional<std::string> given(const Clause& part);

 private:
  std::optional<std::string> worded(const Clause& clause);
  const std::string& chosen(const std::vector<std::string>& patterns);
  std::string pick(std::initializer_list<const char*> choices);
  std::optional<Words> subjects_of(const Clause& clause, Place place = {});
  std::optional<std::string> denial(const Clause& clause, const std::string& be);
  /// Each part by `statement` with `be`, or, without it, by `command`.
  std::optional<std::string> joined_parts(const Clause& clause, const std::string* be);
  std::optional<std::string> comparison(const Clause& clause, const std::string& be);
  std::optional<std::string> special_command(const Clause& clause, bool& special);
  std::optional<std::string> taken_first(const Clause& clause);
  static std::string taken_exception(const Clause& clause, std::string& subject);
  bool described_by_place(const Clause& clause) const;
  std::optional<std::string> cut_first(const Clause& clause);
  std::optional<std::string> filled(const std::string& pattern, const Clause& clause);

  /// "in there, too", of the place that the command before put something at; nullopt for any other.
  std::optional<std::string> there_too(const Complement& goes) const;

  Naming& naming_;
  Rng& rng_;
  std::optional<Complement> put_last_;  // where the command before put something
};

}  // namespace unietp
