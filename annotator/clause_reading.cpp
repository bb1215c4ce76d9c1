#include "annotator/clause_reading.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

constexpr std::array<std::string_view, 6> kAssurances{"make sure that", "make sure", "see to it that",
                                                      "ensure that",    "ensure",    "check that"};

}  // namespace

bool ClauseReader::assurance_comes() {
  return std::any_of(kAssurances.begin(), kAssurances.end(),
                     [&](std::string_view assurance) { return words_.accept(assurance); });
}

/// Statements joined by "and", or alternatives after "either".
Clause ClauseReader::statements() {
  if (!words_.accept("either")) return statement_list();
  Clause either;
  either.kind = Clause::Kind::Or;
  do {
    either.parts.push_back(given(statement_list()));
  } while (!words_.failed() && words_.accept_one({", or", "or"}) >= 0);
  if (either.parts.size() < 2) words_.fail("expected 'or' after 'either'");
  return either;
}

/// "… if a fridge is open": the condition of an alternative, read at the start.
Clause ClauseReader::given(Clause part) {
  if (words_.accept("if")) part.given.push_back(condition());
  return part;
}

NounPhrase ClauseReader::condition() {
  NounPhrase there = words_.phrase();
  if (there.determiner != Determiner::New && there.determiner != Determiner::The && there.determiner != Determiner::Any)
    words_.fail("expected 'a …' or 'any …' before this");
  if (be(false)) words_.fail("a condition is of something that is so");
  Clause said;
  words_.complements(said);
  if (said.any_complement) words_.fail("a condition says all of its object that it asks for");
  there.modifiers = std::move(said.complements);
  return there;
}

Clause ClauseReader::statement_list() {
  Clause list;
  list.kind = Clause::Kind::And;
  list.parts.push_back(statement());
  while (!words_.failed()) {
    const std::size_t here = words_.position();
    const bool comma = words_.accept(",");
    if ((!words_.accept("and") && !comma) || (!words_.phrase_comes() && !words_.comes("there"))) {
      words_.go_back(here);
      break;
    }
    list.parts.push_back(statement());
  }
  if (list.parts.size() > 1) return list;
  Clause only = std::move(list.parts[0]);
  return only;
}

/// True for "must not be". "No mug may be there" forbids; "a mug may be there" asks for nothing.
bool ClauseReader::be(bool forbids) {
  if (words_.accept_one({"should not be", "must not be"}) >= 0) return true;
  if (forbids && words_.accept("may be")) return false;
  if (words_.accept_one({"is", "are", "should be", "must be", "has to be", "have to be"}) < 0)
    words_.fail("expected 'is' or 'are'");
  return false;
}

Clause ClauseReader::statement() {
  Clause clause;
  if (words_.accept("there")) {
    if (be(false)) words_.fail("expected how many there are to be, before 'not'");
    return comparison();
  }
  clause.subjects = words_.phrases(clause.any_subject);
  const bool forbids = std::all_of(clause.subjects.begin(), clause.subjects.end(), [](const NounPhrase& subject) {
    return subject.determiner == Determiner::No || subject.determiner == Determiner::AtMost;
  });
  const bool denied = be(forbids);
  words_.complements(clause);
  if (denied && clause.complements.size() > 1) words_.fail("expected one thing that is not so before this");
  if (denied) clause.complements[0].negated = !clause.complements[0].negated;
  return clause;
}

Clause ClauseReader::comparison() {
  Clause clause;
  clause.kind = Clause::Kind::Compare;
  std::string_view link = "as";
  if (words_.accept("more")) {
    clause.comparison = Comparison::Greater;
    link = "than";
  } else if (words_.accept("at least as many")) {
    clause.comparison = Comparison::AtLeast;
  } else {
    words_.expect("as many");
  }
  clause.subjects.push_back(words_.bare_noun());
  if (words_.accept(link)) {  // "as many forks as plates on the table"
    clause.subjects.push_back(words_.bare_noun());
    at_the_same_place(clause);
    return clause;
  }
  clause.complements.push_back(words_.complement());
  words_.expect(link);
  clause.subjects.push_back(words_.complement_comes() ? clause.subjects[0] : words_.bare_noun());
  clause.complements.push_back(words_.complement());
  return clause;
}

}  // namespace unietp
