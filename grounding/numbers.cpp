#include "grounding/numbers.h"

#include <algorithm>
#include <limits>
#include <string>

#include "generator/fixed_start.h"
#include "logic/evaluate.h"
#include "scene/comparisons.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr int kMostTakenOut = 3;  // of one kind: what is left is to look like a home
constexpr int kAny = std::numeric_limits<int>::max();

bool compares(const Formula& formula) {
  Compared compared;
  compared.add(formula);
  return !compared.none();
}

std::optional<GroundingFailure> refused_by_number(const Formula& count, const Home& home, const Knowledge& knowledge) {
  const Formula& body = count.children.front();
  if (count.op != Op::Count || count.domain.members.size() != 1 || count.domain.members.front().slice ||
      body.op != Op::And || !body.children.empty())
    return std::nullopt;
  const Category* category = knowledge.find(count.domain.members.front().category);
  if (category == nullptr || !category->movable) return std::nullopt;
  const int number = static_cast<int>(members_of(count.domain, count.variable, home.now).size());
  const int high = count_range(count.comparison, count.number, true).second;
  if (high == kAny || number - high <= kMostTakenOut) return std::nullopt;
  return GroundingFailure{RejectionReason::CannotEnforce,
                          "the home has " + std::to_string(number) + " of " + category->name + ", " +
                              std::to_string(number - high) + " too many to take out",
                          {}};
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
  std::vector<Formula> plain = constraints;
  std::erase_if(plain, compares);  // the home's state says nothing of what they compare
  if (const Formula* missing = misfit(plain, knowledge, home.now)) {
    return GroundingFailure{lack_of(missing->domain.members.front().category, knowledge),
                            "as the home is, it cannot have " + to_text(*missing),
                            {}};
  }
  for (const Formula& constraint : plain) {
    if (auto why = refused_by_number(constraint, home, knowledge)) return why;
  }
  return std::nullopt;
}

}  // namespace unietp
