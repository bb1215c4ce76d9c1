#include <algorithm>

#include "annotator/idioms.h"
#include "annotator/words_for_writing.h"

namespace unietp {
namespace {

bool is_put(const Complement& said) {
  const bool place = said.predicate == Predicate::On || said.predicate == Predicate::Inside;
  return place && !said.negated && !said.converse && said.object.size() == 1;
}

bool says_one_thing(const Clause& clause) {
  return clause.kind == Clause::Kind::Simple && clause.subjects.size() == 1 && clause.complements.size() == 1 &&
         clause.given.empty() && !clause.put_down && !clause.poured;
}

/// "Put a mug and a plate on the table."
bool puts(const Clause& clause) {
  return clause.kind == Clause::Kind::Simple && !clause.any_subject && clause.complements.size() == 1 &&
         is_put(clause.complements[0]) && clause.given.empty() && !clause.put_down && !clause.each_has_one;
}

bool is_one(const NounPhrase& phrase) { return phrase.determiner == Determiner::New && !phrase.variable.empty(); }

/// "The egg is hot."
bool is_state_of(const Clause& clause, const std::string& variable) {
  return says_one_thing(clause) && clause.subjects[0].variable == variable && clause.complements[0].object.empty() &&
         clause.complements[0].symbol.empty() && !clause.complements[0].negated;
}

/// Takes out of the clauses one that makes the thing hot or the like, into its name.
void take_state(std::vector<Clause>& clauses, NounPhrase& thing) {
  const auto made = std::find_if(clauses.begin(), clauses.end(), [&](const Clause& clause) {
    return is_state_of(clause, thing.variable) && !made_so(clause.complements[0].predicate).empty();
  });
  if (made == clauses.end()) return;
  thing.done.push_back({made->complements[0].predicate, false, "", {}});
  clauses.erase(made);
}

/// The same of one that puts something into it.
void take_content(std::vector<Clause>& clauses, NounPhrase& thing) {
  const auto held = std::find_if(clauses.begin(), clauses.end(), [&](const Clause& clause) {
    return says_one_thing(clause) && is_put(clause.complements[0]) && is_one(clause.subjects[0]) &&
           clause.complements[0].object[0].variable == thing.variable;
  });
  if (held == clauses.end() || !thing.modifiers.empty()) return;
  NounPhrase content = held->subjects[0];
  const Predicate where = held->complements[0].predicate;
  clauses.erase(held);
  take_state(clauses, content);
  thing.done.push_back({where, false, "", {std::move(content)}, true});
}

}  // namespace

void join_results(std::vector<Clause>& clauses) {
  for (std::size_t i = clauses.size(); i-- > 0;) {  // what something is put in is put somewhere later
    if (!puts(clauses[i])) continue;
    Clause placed = clauses[i];
    std::vector<Clause> rest = clauses;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    for (NounPhrase& thing : placed.subjects) {
      if (!is_one(thing)) continue;
      take_content(rest, thing);
      take_state(rest, thing);
    }
    if (rest.size() + 1 == clauses.size()) continue;
    rest.insert(rest.begin() + static_cast<std::ptrdiff_t>(std::min(i, rest.size())), std::move(placed));
    clauses = std::move(rest);
    return;
  }
}

void order_as_done(std::vector<Clause>& clauses) {
  for (std::size_t i = 1; i < clauses.size(); ++i) {
    const std::string thing = clauses[i].subjects.empty() ? "" : clauses[i].subjects[0].variable;
    if (thing.empty() || !is_state_of(clauses[i], thing)) continue;
    const auto until = clauses.begin() + static_cast<std::ptrdiff_t>(i);
    const auto placed = std::find_if(clauses.begin(), until, [&](const Clause& clause) {
      return puts(clause) && clause.subjects.size() == 1 && clause.subjects[0].variable == thing;
    });
    std::rotate(placed, until, until + 1);
  }
}

}  // namespace unietp
