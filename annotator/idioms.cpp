#include "annotator/idioms.h"

#include <algorithm>
#include <optional>
#include <string>

namespace unietp {
namespace {

bool is_simple(const Clause& clause) {
  return clause.kind == Clause::Kind::Simple && clause.subjects.size() == 1 && clause.subjects[0].done.empty();
}

bool is_where_things_are(Predicate predicate) {
  return predicate == Predicate::On || predicate == Predicate::Inside || predicate == Predicate::OnFloor;
}

/// "None of the mugs is in your hand."
bool holds_none(const Clause& clause) {
  return is_simple(clause) && clause.subjects[0].determiner == Determiner::No && clause.subjects[0].modifiers.empty() &&
         clause.complements.size() == 1 && clause.complements[0].predicate == Predicate::Held &&
         !clause.complements[0].negated;
}

/// "No mug is on the table", "exactly one mug is on the table".
bool leaves_some_to_put_down(const Clause& clause, const Domain& noun) {
  if (!is_simple(clause) || clause.complements.size() != 1 || clause.subjects[0].noun != noun) return false;
  const Determiner determiner = clause.subjects[0].determiner;
  return (determiner == Determiner::No || determiner == Determiner::Exactly) && clause.subjects[0].modifiers.empty() &&
         is_where_things_are(clause.complements[0].predicate) && !clause.complements[0].negated;
}

/// "One of the mugs is on the table."
bool says_one_is(const Clause& clause, const Domain& noun, const Complement& place) {
  if (!is_simple(clause) || clause.complements.size() != 1 || clause.subjects[0].noun != noun) return false;
  const NounPhrase& subject = clause.subjects[0];
  const bool one = subject.determiner == Determiner::Any || subject.determiner == Determiner::New ||
                   (subject.determiner == Determiner::AtLeast && subject.number == 1);
  const Complement& said = clause.complements[0];
  return one && subject.modifiers.empty() && said.predicate == place.predicate && !said.negated &&
         !said.object.empty() && !said.object[0].variable.empty() &&
         said.object[0].variable == place.object[0].variable;
}

bool speaks_of(const Clause& clause, const std::string& variable) {
  return any_phrase(clause, [&](const NounPhrase& phrase) { return phrase.variable == variable; });
}

bool shares_out(const Clause& clause) {
  const bool all = clause.kind == Clause::Kind::Simple && clause.any_complement && clause.subjects.size() == 1 &&
                   clause.subjects[0].determiner == Determiner::Every && clause.subjects[0].modifiers.empty();
  const bool even = clause.kind == Clause::Kind::Compare && clause.comparison == Comparison::Equal &&
                    clause.subjects[0].noun == clause.subjects[1].noun;
  if ((!all && !even) || clause.complements.size() != 2) return false;
  return std::all_of(clause.complements.begin(), clause.complements.end(), [](const Complement& place) {
    return place.predicate == Predicate::On && !place.negated && !place.object[0].variable.empty();
  });
}

/// Erases, for each place, the clause that says that one is there; one such clause is enough where the numbers are
/// equal. False, without changes, when one is missing.
bool take_ones(std::vector<Clause>& clauses, Clause& shared) {
  std::vector<Clause> rest = clauses;
  std::size_t taken = 0;
  std::optional<Complement> first;
  for (const Complement& place : shared.complements) {
    const auto found = std::find_if(rest.begin(), rest.end(), [&](const Clause& clause) {
      return says_one_is(clause, shared.subjects[0].noun, place);
    });
    if (found == rest.end()) continue;
    const std::string one = found->subjects[0].variable;
    rest.erase(found);
    const auto speaks = [&](const Clause& clause) { return speaks_of(clause, one); };
    if (!one.empty() && std::any_of(rest.begin(), rest.end(), speaks)) return false;
    if (!first) first = place;
    ++taken;
  }
  if (taken != (shared.kind == Clause::Kind::Compare ? 1U : 2U)) return false;
  clauses = std::move(rest);
  // Of equal numbers the place that is named last has the one.
  if (taken == 1 && first->object[0].variable == shared.complements[0].object[0].variable)
    std::swap(shared.complements[0], shared.complements[1]);
  return true;
}

}  // namespace

void join_idioms(std::vector<Clause>& clauses) {
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    if (!holds_none(clauses[i])) continue;
    const Domain noun = clauses[i].subjects[0].noun;
    const auto placed = std::find_if(clauses.begin(), clauses.end(),
                                     [&](const Clause& clause) { return leaves_some_to_put_down(clause, noun); });
    if (placed == clauses.end()) continue;
    placed->put_down = true;
    clauses.erase(clauses.begin() + static_cast<std::ptrdiff_t>(i--));
  }
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    if (!shares_out(clauses[i])) continue;
    Clause shared = clauses[i];
    shared.each_has_one = true;
    std::vector<Clause> rest = clauses;
    if (!take_ones(rest, shared)) continue;
    const auto own = std::find_if(rest.begin(), rest.end(), shares_out);
    *own = std::move(shared);
    clauses = std::move(rest);
    return;
  }
}

}  // namespace unietp
