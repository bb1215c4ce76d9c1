#include "annotator/goal_words.h"

#include "annotator/meaning.h"

namespace unietp {
namespace {

using Op = Formula::Op;

bool is_negative(const Formula& formula) {
  if (formula.op == Op::Not) return true;
  if (formula.op == Op::Or || formula.op == Op::And)
    for (const Formula& child : formula.children)
      if (is_negative(child)) return true;
  if (formula.op == Op::Forall || formula.op == Op::Exists || formula.op == Op::AtEnd || formula.op == Op::Always)
    return is_negative(formula.children[0]);
  return false;
}

void collect(const Formula& f, GoalWords& words) {
  if (f.op == Op::Atom) {
    words.predicates.insert(f.predicate);
    for (const Term& term : f.terms)
      if (term.kind == Term::Kind::Symbol) words.symbols.insert(term.name);
  }
  for (const Domain::Member& member : f.domain.members) words.categories.insert(member.category);
  if (f.op == Op::Forall) (is_negative(f.children[0]) ? words.none : words.every) = true;
  if (f.op == Op::Count) {
    if (f.number > 1) words.numbers.insert(f.number);
    if (f.comparison == Comparison::Equal) words.exactly = true;
    if (f.comparison == Comparison::AtLeast) words.at_least = true;
    if (f.comparison == Comparison::AtMost) words.at_most = true;
  }
  if (f.op == Op::CountCompare) words.at_least = words.exactly = true;  // "as many as", "more than"
  if (f.op == Op::Before || f.op == Op::Until) words.order = true;
  if (f.op == Op::Always) words.throughout = true;
  if (f.op == Op::Sometime) words.sometime = true;
  for (const Formula& where : f.domain.where) collect(where, words);
  for (const Formula& child : f.children) collect(child, words);
}

}  // namespace

GoalWords words_of_goal(const Formula& goal) {
  GoalWords words;
  collect(expanded(goal), words);
  return words;
}

}  // namespace unietp
