#include "grounding/numbers.h"

#include <algorithm>
#include <limits>
#include <string>

#include "logic/evaluate.h"
#include "scene/comparisons.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr int kMostTakenOut = 20;  // of one kind; homes of usual size seldom have as many
constexpr int kAny = std::numeric_limits<int>::max();

/// Only relations are asked, so that of furniture no edit but taking it out changes the answer.
bool asks_where_it_stands(const Formula& body) {
  if (body.op == Op::Atom)
    return body.predicate == Predicate::NextTo || body.predicate == Predicate::InRoom ||
           body.predicate == Predicate::On;
  return (body.op == Op::And || body.op == Op::Exists) &&
         std::all_of(body.children.begin(), body.children.end(), asks_where_it_stands);
}

std::optional<GroundingFailure> refused_by_number(const Formula& count, const Home& home, const Knowledge& knowledge) {
  const Formula& body = count.children.front();
  if (count.domain.members.size() != 1 || count.domain.members.front().slice || !asks_where_it_stands(body))
    return std::nullopt;
  const std::string& name = count.domain.members.front().category;
  const Category* category = knowledge.find(name);
  const bool any = body.op == Op::And && body.children.empty();
  if (category != nullptr && category->movable && !any) return std::nullopt;  // it can be put elsewhere
  Compared compared;
  compared.add(count);
  if (!compared.none()) return std::nullopt;
  Domain domain = count.domain;
  if (!any) domain.where = {domain.where.empty() ? body : conjunction({domain.where.front(), body})};
  const int number = static_cast<int>(members_of(domain, count.variable, home.now).size());
  const auto [low, high] = count_range(count.comparison, count.number, true);
  const std::string said = "the home has " + std::to_string(number) + " of " + to_text(domain);
  const bool rooms = category == nullptr && std::any_of(home.scene.rooms.begin(), home.scene.rooms.end(),
                                                        [&](const Room& room) { return room.type == name; });
  if (rooms && any && (number < low || number > high))
    return GroundingFailure{RejectionReason::LacksRoom, said + ", not " + std::to_string(count.number), {}};
  if (!rooms && high != kAny && number - high > kMostTakenOut)
    return GroundingFailure{
        RejectionReason::CannotEnforce, said + ", " + std::to_string(number - high) + " too many to take out", {}};
  return std::nullopt;
}

}  // namespace

std::pair<int, int> count_range(Comparison comparison, int n, bool truth) {
  switch (comparison) {
    case Comparison::AtLeast:
      return truth ? std::pair(n, kAny) : std::pair(0, n - 1);
    case Comparison::Greater:
      return truth ? std::pair(n + 1, kAny) : std::pair(0, n);
    case Comparison::AtMost:
      return truth ? std::pair(0, n) : std::pair(n + 1, kAny);
    case Comparison::Less:
      return truth ? std::pair(0, n - 1) : std::pair(n, kAny);
    case Comparison::Equal:
      break;
  }
  return truth ? std::pair(n, n) : std::pair(n + 1, kAny);
}

std::optional<GroundingFailure> refused_by_numbers(const std::vector<Formula>& constraints, const Home& home,
                                                   const Knowledge& knowledge) {
  for (const Formula& constraint : constraints) {
    if (constraint.op != Op::Count) continue;
    if (auto why = refused_by_number(constraint, home, knowledge)) return why;
  }
  return std::nullopt;
}

}  // namespace unietp
