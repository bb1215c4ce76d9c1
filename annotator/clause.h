#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// The meaning of a sentence of the controlled English, independent of its wording: the writer makes these from a goal
/// and words them, the reader makes them from text and composes a goal.

/// How a noun phrase picks its objects.
enum class Determiner {
  New,      // a mug: some mug, the same throughout the text
  Single,   // one mug, a single mug: as New; used next to a quantifier
  Another,  // another mug: New, and not any mug named before
  Known,    // that mug: the one named before
  The,      // the mug: Known when one mug was named before, else New
  It,       // it: the only one named before
  Ordinal,  // the second mug: the mug named second (number)
  Any,      // any mug, some mug or other: one that may differ with what stands before
  Every,
  No,
  Exactly,
  AtLeast,
  AtMost,  // number: of the last three
  Agent,   // you
};

struct Complement;

/// A reference to objects.
struct NounPhrase {
  Determiner determiner = Determiner::New;
  int number = 0;
  Domain noun;                        // without `where`
  bool by_function = false;           // "something to drink from"; named again as "that object"
  bool except = false;                // "every mug but the red one": all that the modifiers do not fit
  std::size_t there = 0;              // the writer's: how many such objects the start has; 0: not known
  std::size_t promised = 0;           // the reader's: how many there have to be, "both mugs"; 0: any number
  bool two = false;                   // the writer's: the start has two such objects: "both mugs", "the larger mug"
  std::vector<Complement> modifiers;  // all true in the start state ("that is dirty")
  std::vector<Complement> done;       // to be brought about ("that you put a mug into"; "one of the slices")
  std::vector<Domain> absent;         // of which the home has none: else "a slice of bread" would be one of these
  std::string variable;               // the writer's: which variable of the goal; "" when read
  int column = 0;                     // the reader's: where it stood
};

/// What is said of a subject: a state, a state with a symbol, or a relation to an object.
struct Complement {
  Predicate predicate = Predicate::Open;
  bool negated = false;
  std::string symbol;
  std::vector<NounPhrase> object;  // none or one
  bool converse = false;           // of a relation: the object comes first, "where a plate is kept"
};

/// "That is on the desk", of what is put somewhere: the hearer may take it for where it is to go.
inline bool describes_by_place(const Complement& modifier) {
  return !modifier.object.empty() && !modifier.converse && modifier.predicate != Predicate::Nearest;
}

/// A statement or command about subjects.
struct Clause {
  enum class Kind { Simple, And, Or, Compare };
  Kind kind = Kind::Simple;
  std::vector<NounPhrase> subjects;  // Simple: each, or (any_subject) one of them. Compare: two, bare nouns
  bool any_subject = false;
  std::vector<Complement> complements;  // Simple: all, or (any_complement) one of them. Compare: one for each subject
  bool any_complement = false;
  bool removal = false;       // Simple: "remove every A from B", subject No
  bool put_down = false;      // Simple: and none of that kind is in your hand: "…, and put them down"
  bool each_has_one = false;  // at each of the places is at least one: "divide all the mugs between A and B, …"
  std::size_t there_now = 0;  // the writer's, Simple: how many of its subjects are so at the start; 0: not known
  bool poured = false;        // filled with what the clause before it was filled with: "…, then pour it into B"
  Comparison comparison = Comparison::Equal;  // Compare: Equal, Greater or AtLeast
  std::vector<Clause> parts;                  // And, Or
  std::vector<NounPhrase> given;              // of a part of Or: only where such things are at the start; of the
                                              // clause of a Final: "if a fridge is open, …"
};

/// Whether a subject or object of the clause, or of its parts, meets a test of noun phrases.
template <class Test>
bool any_phrase(const Clause& clause, const Test& test) {
  return std::any_of(clause.subjects.begin(), clause.subjects.end(), test) ||
         std::any_of(
             clause.complements.begin(), clause.complements.end(),
             [&](const Complement& said) { return std::any_of(said.object.begin(), said.object.end(), test); }) ||
         std::any_of(clause.parts.begin(), clause.parts.end(),
                     [&](const Clause& part) { return any_phrase(part, test); });
}

/// One operator of a goal, worded as such where no clause can express it: "at all times, if the mug is hot, then …".
struct Proposition {
  Formula::Op op = Formula::Op::And;
  std::vector<NounPhrase> phrases;  // Atom: its subject. Equal: both sides. Quantifiers, Number: what is bound; the
                                    // determiner is Every, New (`exists`) or one with a number
  std::vector<Complement> said;     // Atom: one
  bool negated = false;             // Equal
  Comparison comparison = Comparison::Equal;  // CountCompare
  std::vector<Proposition> where;             // of what is bound, at the start: none or one; modifiers say it otherwise
  std::vector<Proposition> parts;             // the operands
};

/// A clause, or several, with a temporal relation.
struct Requirement {
  enum class Kind {
    Choose,     // introduces the subject of clause 0, asks nothing
    Final,      // clause 0 at the end
    Need,       // the same, said as what someone wants: one subject, a state and a place
    Sometime,   // clause 0 at some point
    Always,     // clause 0 all the time
    Until,      // clause 0 until clause 1
    Before,     // clause 0 before clause 1
    Then,       // Before, and clause 1 at the end
    ThenKept,   // Before, and both at the end
    Once,       // the writer's: the same, "once you've put A in B, turn it on"
    Again,      // clause 0 at some point, the others at the end: "open B, take A out of it and close it again"
    UntilThen,  // Until, and both clause 1 and clause 2 at the end: "keep B closed until A is on C, then open it"
    OnlyThen,   // clause 0 before any of what clause 1 says, and both at the end: "…, and only then all the mugs"
    Fact,       // clause 0 is so at the start; asks nothing
    Contrast,   // the same of what is not meant: "…, not the blue one"
    Stated,     // `stated`, which speaks of the subjects of clause 0 and of what it binds itself
  };
  Kind kind = Kind::Final;
  std::vector<Clause> clauses;
  bool inverted = false;            // Then, ThenKept: clause 1 stands first, "…, but … first"
  std::vector<Proposition> stated;  // Stated: one
};

/// A whole text.
using Message = std::vector<Requirement>;

}  // namespace unietp
