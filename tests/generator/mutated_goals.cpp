#include "tests/generator/mutated_goals.h"

#include <array>

namespace unietp {
namespace {

using Op = Formula::Op;

void change_here(const Formula& formula, std::vector<MutatedGoal>& found) {
  const auto add = [&](Mistake mistake, auto change) {
    auto changed = formula;
    change(changed);
    found.push_back({mistake, std::move(changed)});
  };
  if (formula.op == Op::Before) add(Mistake::WrongOrder, [](Formula& f) { std::swap(f.children[0], f.children[1]); });
  if (formula.op == Op::Until) {
    add(Mistake::WrongOrder, [](Formula& f) {
      f.op = Op::Before;
      f.children[0] = negation(f.children[0]);
    });
  }
  if (!formula.domain.where.empty()) {
    add(Mistake::Decoy, [](Formula& f) { f.domain.where[0] = negation(f.domain.where[0]); });
  }
  if (formula.op == Op::Count) {
    const auto comparison = formula.comparison;
    const bool bounded =
        comparison == Comparison::Equal || comparison == Comparison::AtMost || comparison == Comparison::Less;
    const int most = comparison == Comparison::Less ? formula.number - 1 : formula.number;
    const int least = comparison == Comparison::Greater ? formula.number + 1 : formula.number;
    if (bounded) {
      add(Mistake::OneTooMany, [&](Formula& f) {
        f.comparison = Comparison::AtLeast;
        f.number = most + 1;
      });
    }
    if (comparison != Comparison::AtMost && comparison != Comparison::Less && least >= 1) {
      add(Mistake::OneTooFew, [&](Formula& f) {
        f.comparison = Comparison::Equal;
        f.number = least - 1;
      });
    }
  }
  if (formula.op == Op::CountCompare && formula.comparison == Comparison::Equal)
    add(Mistake::OneTooMany, [](Formula& f) { f.comparison = Comparison::Greater; });
  if (formula.op == Op::And && formula.children.size() > 1) {
    for (std::size_t i = 0; i < formula.children.size(); ++i) {
      add(Mistake::PartLeftOut, [&](Formula& f) { f.children.erase(f.children.begin() + static_cast<long>(i)); });
    }
  }
}

}  // namespace

std::string_view name_of(Mistake mistake) {
  constexpr std::array<std::string_view, kMistakes> kNames{"wrong order", "decoy", "one too many", "one too few",
                                                           "a part left out"};
  return kNames[static_cast<std::size_t>(mistake)];
}

std::vector<MutatedGoal> mutated_goals(const Formula& goal) {
  std::vector<MutatedGoal> found;
  change_here(goal, found);
  for (std::size_t i = 0; i < goal.children.size(); ++i) {
    for (auto& inner : mutated_goals(goal.children[i])) {
      auto changed = goal;
      changed.children[i] = std::move(inner.goal);
      found.push_back({inner.mistake, std::move(changed)});
    }
  }
  return found;
}

}  // namespace unietp
