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

bool met(const Formula& start, const Knowledge& knowledge, const Trace& now) {
  if (start.domain.members.empty() || !is_fixed(start.domain, knowledge)) return true;
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

}  // namespace

const Formula* misfit(const std::vector<Formula>& init, const Knowledge& knowledge, const Trace& now) {
  const auto found =
      std::find_if(init.begin(), init.end(), [&](const Formula& start) { return !met(start, knowledge, now); });
  return found == init.end() ? nullptr : &*found;
}

RejectionReason lack_of(const std::string& name, const Knowledge& knowledge) {
  if (knowledge.find(name) != nullptr) return RejectionReason::LacksFurniture;
  const bool room = std::all_of(name.begin(), name.end(), [](char c) { return c == '_' || (c >= 'a' && c <= 'z'); });
  return room ? RejectionReason::LacksRoom : RejectionReason::UnknownCategory;
}

}  // namespace unietp
