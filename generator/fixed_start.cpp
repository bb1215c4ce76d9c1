#include "generator/fixed_start.h"

#include <algorithm>

#include "logic/evaluate.h"
#include "templates/init_shape.h"

namespace unietp {
namespace {

using Op = Formula::Op;

/// Of furniture or rooms only.
bool is_fixed(const Domain& domain, const Knowledge& knowledge) {
  return std::all_of(domain.members.begin(), domain.members.end(), [&](const Domain::Member& member) {
    const auto* category = knowledge.find(member.category);
    return !member.slice && (category == nullptr || !category->movable);
  });
}

bool is_fixed(const StartLiteral& literal, const Knowledge& knowledge) {
  return literal.relation && is_fixed(literal.other, knowledge);
}

/// Whether the agent would have to be in none of the rooms that there are.
bool shuts_out(const Formula& start, const Trace& now) {
  const Formula& body = start.children.front();
  if (start.op != Op::Forall || body.op != Op::Not || body.children.front().op != Op::Atom ||
      body.children.front().predicate != Predicate::InRoom ||
      body.children.front().terms.front().kind != Term::Kind::Agent)
    return false;
  const auto& all = now.entities;
  std::size_t rooms = 0;
  for (std::size_t i = 0; i < all.size(); ++i) rooms += all[i].kind == Entity::Kind::Room ? 1 : 0;
  return members_of(start.domain, start.variable, now).size() == rooms;
}

bool met(const Formula& start, const Knowledge& knowledge, const Trace& now) {
  if (start.domain.members.empty() || !is_fixed(start.domain, knowledge)) return true;
  if (shuts_out(start, now)) return false;
  const auto literals = start_literals(start);
  const auto& body = start.children.front();
  std::vector<Formula> kept;  // what no edit changes
  for (std::size_t i = 0; i < literals.size(); ++i) {
    if (is_fixed(literals[i], knowledge)) kept.push_back(body.op == Op::And ? body.children[i] : body);
  }
  auto wanted = start;
  // Whatever else is asked of them, there have to be enough.
  if (kept.size() < literals.size() && start.op == Op::Count) wanted.comparison = Comparison::AtLeast;
  wanted.children = {conjunction(std::move(kept))};
  if (holds_in(wanted, now, 0)) return true;
  const bool may_come = start.op == Op::Exists || start.comparison != Comparison::AtMost;
  return may_come && start.op != Op::Forall && members_of(start.domain, start.variable, now).empty() &&
         std::all_of(start.domain.members.begin(), start.domain.members.end(),
                     [&](const Domain::Member& member) { return knowledge.find(member.category) != nullptr; });
}

/// Whether no thing can be counted by both: one asks for what the other rules out.
bool exclude_one_another(const Formula& a, const Formula& b) {
  if (a.domain != b.domain) return false;
  const auto of_b = start_literals(b);
  for (StartLiteral literal : start_literals(a)) {
    literal.positive = !literal.positive;
    if (std::find(of_b.begin(), of_b.end(), literal) != of_b.end()) return true;
  }
  return false;
}

/// Furniture of which there is some, but too little for two constraints of which none meets both: "the table made of
/// glass" takes two tables.
bool enough_for_both(const Formula& a, const Formula& b, const Knowledge& knowledge, const Trace& now) {
  const int asked = demanded_count(a) + demanded_count(b);
  if (asked < 2 || a.domain.members.empty() || !is_fixed(a.domain, knowledge) || !exclude_one_another(a, b))
    return true;
  const auto there = static_cast<int>(members_of(a.domain, a.variable, now).size());
  return there == 0 || there >= asked;
}

}  // namespace

const Formula* misfit(const std::vector<Formula>& init, const Knowledge& knowledge, const Trace& now) {
  const auto found =
      std::find_if(init.begin(), init.end(), [&](const Formula& start) { return !met(start, knowledge, now); });
  if (found != init.end()) return &*found;
  for (auto a = init.begin(); a != init.end(); ++a) {
    for (auto b = a + 1; b != init.end(); ++b) {
      if (!enough_for_both(*a, *b, knowledge, now)) return &*b;
    }
  }
  return nullptr;
}

RejectionReason lack_of(const std::string& name, const Knowledge& knowledge) {
  if (knowledge.find(name) != nullptr) return RejectionReason::LacksFurniture;
  const bool room = std::all_of(name.begin(), name.end(), [](char c) { return c == '_' || (c >= 'a' && c <= 'z'); });
  return room ? RejectionReason::LacksRoom : RejectionReason::UnknownCategory;
}

}  // namespace unietp
