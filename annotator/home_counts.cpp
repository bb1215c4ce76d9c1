#include "annotator/home_counts.h"

#include <algorithm>
#include <string>
#include <utility>

namespace unietp {
namespace {

using Op = Formula::Op;

void name(Formula& formula, const std::string& variable, const Term& thing) {
  for (Term& term : formula.terms)
    if (term.kind == Term::Kind::Variable && term.name == variable) term = thing;
  if (formula.variable == variable) return;
  for (Formula& where : formula.domain.where) name(where, variable, thing);
  for (Formula& child : formula.children) name(child, variable, thing);
}

/// "Exactly two" or "at least two" of two.
bool asks_for_all(const Formula& f, std::size_t there) {
  const bool enough = f.comparison == Comparison::Equal || f.comparison == Comparison::AtLeast;
  return f.op == Op::Count && enough && there > 0 && f.number == static_cast<int>(there);
}

Formula of_all(Formula count) {
  count.op = Op::Forall;
  count.number = 0;
  count.comparison = Comparison::Equal;
  return count;
}

bool denies(const Formula& f) {
  return f.op == Op::Not || f.op == Op::Always || f.op == Op::Until ||
         std::any_of(f.children.begin(), f.children.end(), denies);
}

/// "Put all the bowls on the table, and only then the mug.": what is kept until then and what comes then are one.
bool has_until(const Formula& f) {
  return f.op == Op::Until || std::any_of(f.children.begin(), f.children.end(), has_until);
}

/// The states of the variable that a formula asks for.
void add_states(const Formula& f, const std::string& variable, std::vector<Formula>& into) {
  const bool state = f.op == Op::Atom && f.terms.size() == 1 && f.terms[0].name == variable;
  if (state && f.predicate != Predicate::Held) into.push_back(f);
  if (f.op == Op::Not) {  // "wipe the ketchup off the table"
    const Formula* inner = &f.children[0];
    while (inner->op == Op::AtEnd) inner = &inner->children[0];
    const bool covered = inner->op == Op::Atom && inner->predicate == Predicate::Covered;
    if (covered && inner->terms[0].name == variable) into.push_back(negation(*inner));
  }
  if (f.op == Op::Not || f.op == Op::Or || f.op == Op::Imply || f.op == Op::Until) return;
  for (const Formula& child : f.children) add_states(child, variable, into);
}

bool is_what_is_not(const Domain& domain) { return !domain.where.empty() && domain.where[0].op == Op::Not; }

}  // namespace

std::vector<EntityIndex> HomeCounts::members(const Domain& domain, const std::string& variable) const {
  const bool one_kind = domain.kind == Domain::Kind::Categories && domain.members.size() == 1;
  if (start_ == nullptr || !one_kind || domain.members[0].slice) return {};
  for (const Formula& where : domain.where)
    for (const std::string& free : free_variables(where))
      if (free != variable) return {};
  return members_of(domain, variable, *start_);
}

namespace {

/// The things of which there is one, by the variables that stand for them where a part of a goal is.
using Singles = std::vector<std::pair<std::string, Domain>>;

/// A domain that speaks of them, closed: "the magazine that is on it" where there is one desk.
Domain closed(Domain domain, const Singles& singles) {
  for (Formula& where : domain.where)
    for (auto single = singles.rbegin(); single != singles.rend(); ++single) {
      const auto free = free_variables(where);
      if (std::find(free.begin(), free.end(), single->first) != free.end())
        where = exists(single->first, single->second, std::move(where));
    }
  return domain;
}

Formula named_in_home(const Formula& goal, const HomeCounts& home, const Singles& singles) {
  const bool binds = goal.op == Op::Exists || goal.op == Op::Forall || goal.op == Op::Count;
  if (binds) {
    const Domain domain = closed(goal.domain, singles);
    const auto there = home.members(domain, goal.variable);
    if (asks_for_all(goal, there.size())) return named_in_home(of_all(goal), home, singles);
    if (there.size() == 1 && goal.op != Op::Count) {
      Singles more = singles;
      more.emplace_back(goal.variable, domain);
      Formula body = named_in_home(goal.children[0], home, more);
      // No symbol has a colon.
      name(body, goal.variable, {Term::Kind::Symbol, ":" + std::to_string(there[0].index())});
      return body;
    }
  }
  Formula result = goal;
  for (Formula& where : result.domain.where) where = named_in_home(where, home, singles);
  for (Formula& child : result.children) child = named_in_home(child, home, singles);
  return result;
}

}  // namespace

Formula as_in_home(const Formula& goal, const HomeCounts& home) { return named_in_home(goal, home, {}); }

/// "Put a couple of books on the shelf. Only one can stay on the desk.": "both" would leave none there.
bool leaves_few(const Formula& all, const Formula& part) {
  return all.op == Op::And && part.op == Op::Count &&
         std::any_of(all.children.begin(), all.children.end(), [&](const Formula& other) {
           return other.op == Op::Count && other.comparison == Comparison::AtMost && other.number > 0 &&
                  other.domain == part.domain;
         });
}

Formula plainly_in_home(const Formula& goal, const HomeCounts& home) {
  if (goal.op == Op::Always || has_until(goal)) return goal;
  Formula result = goal;
  if (goal.op == Op::Forall || goal.op == Op::Count) {
    const auto there = home.members(goal.domain, goal.variable);
    if (asks_for_all(goal, there.size())) result = of_all(result);
    if (result.op == Op::Forall && there.size() == 1 && !denies(goal.children[0]) && !is_what_is_not(goal.domain))
      result.op = Op::Exists;
  }
  for (Formula& child : result.children)
    if (!leaves_few(goal, child)) child = plainly_in_home(child, home);
  return result;
}

std::vector<std::string> unique_variables(const Formula& goal, const HomeCounts& home) {
  std::vector<std::string> unique;
  for (const Formula* f = &goal; f->op == Op::Exists; f = &f->children[0]) {
    std::vector<Formula> asked;
    add_states(f->children[0], f->variable, asked);
    if (asked.empty() || home.members(f->domain, f->variable).size() < 2) continue;
    Domain left = f->domain;
    left.where.push_back(negation(conjunction(std::move(asked))));
    left.where = {conjunction(std::move(left.where))};
    if (home.members(left, f->variable).size() == 1) unique.push_back(f->variable);
  }
  std::sort(unique.begin(), unique.end());
  return unique;
}

}  // namespace unietp
