#include <algorithm>

#include "annotator/idioms.h"

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

/// "The egg is hot."
bool is_state_of(const Clause& clause, const std::string& variable) {
  return says_one_thing(clause) && clause.subjects[0].variable == variable && clause.complements[0].object.empty() &&
         clause.complements[0].symbol.empty() && !clause.complements[0].negated;
}

/// A lamp is put on the desk and then turned on, a book put there and then opened.
bool is_done_last(Predicate predicate) { return predicate == Predicate::PowerOn; }

}  // namespace

void order_as_done(std::vector<Clause>& clauses) {
  const auto puts_it = [](const Clause& clause, const std::string& thing) {
    return puts(clause) && clause.subjects.size() == 1 && clause.subjects[0].variable == thing;
  };
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    const std::string thing = clauses[i].subjects.empty() ? "" : clauses[i].subjects[0].variable;
    if (thing.empty() || !is_state_of(clauses[i], thing) || !is_done_last(clauses[i].complements[0].predicate))
      continue;
    const auto at = clauses.begin() + static_cast<std::ptrdiff_t>(i);
    const auto placed = std::find_if(at, clauses.end(), [&](const Clause& clause) { return puts_it(clause, thing); });
    if (placed != clauses.end()) std::rotate(at, at + 1, placed + 1);
  }
  for (std::size_t i = 1; i < clauses.size(); ++i) {
    const std::string thing = clauses[i].subjects.empty() ? "" : clauses[i].subjects[0].variable;
    if (thing.empty() || !is_state_of(clauses[i], thing) || is_done_last(clauses[i].complements[0].predicate)) continue;
    const auto until = clauses.begin() + static_cast<std::ptrdiff_t>(i);
    const auto placed =
        std::find_if(clauses.begin(), until, [&](const Clause& clause) { return puts_it(clause, thing); });
    std::rotate(placed, until, until + 1);
  }
}

}  // namespace unietp
