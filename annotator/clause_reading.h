#pragma once

#include "annotator/clause.h"
#include "annotator/noun_table.h"
#include "annotator/reading.h"

namespace unietp {

/// Reads clauses at the cursor of `words`: statements ("every fridge is closed") and commands ("put a mug on a table"),
/// joined by "and" or, after "either", by "or". The first word that does not fit is the error of `words`.
class ClauseReader {
 public:
  ClauseReader(PhraseReader& words, const NounTable& lexicon) : words_(words), lexicon_(lexicon) {}

  /// From here on "and a bowl in a box" goes on with nothing.
  void begin_sentence() { moving_ = false; }
  /// Takes "make sure that" or the like.
  bool assurance_comes();
  /// Statements joined by "and", or alternatives after "either".
  Clause statements();
  /// One imperative, or several after "either".
  Clause command();
  Clause command_list();
  /// What is so the whole time: "do not open any fridge", "leave all the plates on the table"; false, with nothing
  /// read, when none comes. What "leave" asks for at the end is a command.
  bool left_alone(Clause& clause);
  /// "a fridge is open", of the start.
  NounPhrase condition();

 private:
  Clause given(Clause part);
  Clause statement_list();
  bool be(bool forbids);
  Clause statement();
  Clause comparison();
  Clause reached();
  Clause moved();
  Clause moved_to();
  bool goes_to(Clause& clause);
  void placed(Clause& clause);
  Clause taken();
  bool is_room(const Domain& noun) const;
  Clause with_symbol(Predicate predicate);
  Clause with_state(Predicate predicate, bool negated, std::string symbol);
  Clause symbol_first(Predicate predicate, std::string_view link, bool negated);
  Clause changed();
  Clause shared_out();
  Clause swapped();
  Clause one_on_each();
  Clause split_evenly();
  Clause same_number();
  Clause outnumbering();
  void at_the_same_place(Clause& clause);
  Clause poured(std::string symbol);
  Clause remaining();
  Clause none_left(bool any);
  Clause few_left();
  bool put_down();
  bool taken_from(Clause& clause);

  PhraseReader& words_;
  const NounTable& lexicon_;
  bool moving_ = false;  // the last command was to put something somewhere
};

}  // namespace unietp
