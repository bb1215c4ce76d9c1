#include "symbolic/heuristic.h"

#include <algorithm>
#include <climits>

namespace unietp::symbolic {
namespace {

const Estimate kNothing{};

Estimate with_steps_of(Estimate estimate, const Estimate& other) {
  estimate.steps.add(other.steps);
  return estimate;
}

}  // namespace

void FewSteps::add(const Step& step) {
  const auto known = all();
  if (size_ < steps_.size() && std::find(known.begin(), known.end(), step) == known.end()) steps_[size_++] = step;
}

void FewSteps::add(const FewSteps& more) {
  for (const Step& step : more.all()) add(step);
}

Estimate together(Estimate first, const Estimate& second) {
  if (!first.possible() || !second.possible()) return kUnreachable;
  first.cost += second.cost;
  first.steps.add(second.steps);
  return first;
}

void Choice::add(const Estimate& way) {
  std::size_t rank = size_;
  while (rank > 0 && way.cost < ways_[rank - 1].cost) --rank;
  if (!way.possible() || rank == ways_.size()) return;
  if (size_ < ways_.size()) ++size_;
  for (std::size_t i = size_ - 1; i > rank; --i) ways_[i] = ways_[i - 1];
  ways_[rank] = way;
}

Estimate Choice::estimate() const {
  if (size_ == 0) return kUnreachable;
  if (ways_[0].cost == 0) return kNothing;
  Estimate best = ways_[0];
  for (std::size_t i = 1; i < size_; ++i) best.steps.add(ways_[i].steps);
  return best;
}

Estimate Heuristic::estimate(const World& world, const Progress& progress) const {
  return toward(goal_.root(), true, world, progress);
}

Estimate Heuristic::toward(std::size_t index, bool wanted, const World& world, const Progress& progress) const {
  const auto& node = goal_.node(index);
  switch (node.op) {
    case Goal::Op::Atom:
      return symbolic::toward(setting_, world, node.atom, wanted);
    case Goal::Op::Not:
      return toward(node.children[0], !wanted, world, progress);
    case Goal::Op::AtEnd:
      return toward(node.children[0], wanted, world, progress);
    case Goal::Op::And:
    case Goal::Op::Or: {
      if ((node.op == Goal::Op::And) == wanted) {
        Estimate all;
        for (const auto child : node.children) all = together(all, toward(child, wanted, world, progress));
        return all;
      }
      Choice ways;
      for (const auto child : node.children) ways.add(toward(child, wanted, world, progress));
      return ways.estimate();
    }
    case Goal::Op::Count: {
      if (wanted) return toward_number(node.children, node.least, node.most, world, progress);
      Choice ways;
      if (node.least > 0) ways.add(toward_number(node.children, 0, node.least - 1, world, progress));
      if (node.most < INT_MAX) ways.add(toward_number(node.children, node.most + 1, INT_MAX, world, progress));
      return ways.estimate();
    }
    case Goal::Op::Compare:
      return toward_comparison(node, wanted, world, progress);
    default:
      if (holds(goal_, index, setting_, world, progress) == wanted) return kNothing;
      return wanted ? toward_moment(node, world, progress) : kUnreachable;
  }
}

Estimate Heuristic::toward_number(const std::vector<std::size_t>& children, int least, int most, const World& world,
                                  const Progress& progress) const {
  std::vector<Estimate> yes, no;
  int number = 0;
  for (const auto child : children) {
    const bool now = holds(goal_, child, setting_, world, progress);
    number += now ? 1 : 0;
    if (now) {
      no.push_back(toward(child, false, world, progress));
    } else {
      yes.push_back(toward(child, true, world, progress));
    }
  }
  const int missing = number < least ? least - number : 0;
  const int excess = number > most ? number - most : 0;
  auto& ways = missing > 0 ? yes : no;
  const int changes = missing + excess;
  const auto needed = static_cast<std::size_t>(changes);
  if (needed == 0) return kNothing;
  if (needed > ways.size()) return kUnreachable;
  std::stable_sort(ways.begin(), ways.end(), [](const Estimate& a, const Estimate& b) { return a.cost < b.cost; });
  Estimate all;
  for (std::size_t i = 0; i < needed; ++i) all = together(all, ways[i]);
  if (all.possible() && needed < ways.size() && ways[needed].possible()) return with_steps_of(all, ways[needed]);
  return all;
}

Estimate Heuristic::toward_comparison(const Goal::Node& node, bool wanted, const World& world,
                                      const Progress& progress) const {
  if (!wanted) return kNothing;  // no goal of the library asks for it; the search itself finds out what happens
  const auto middle = node.children.begin() + static_cast<std::ptrdiff_t>(node.split);
  const std::vector<std::size_t> firsts(node.children.begin(), middle), seconds(middle, node.children.end());
  const auto number = [&](const std::vector<std::size_t>& children) {
    return static_cast<int>(std::count_if(children.begin(), children.end(), [&](std::size_t child) {
      return holds(goal_, child, setting_, world, progress);
    }));
  };
  const int a = number(firsts), b = number(seconds);
  const bool strict = node.comparison == Comparison::Greater || node.comparison == Comparison::Less;
  const int margin = strict ? 1 : 0;
  Choice ways;
  const bool more = node.comparison == Comparison::AtLeast || node.comparison == Comparison::Greater;
  const bool less = node.comparison == Comparison::AtMost || node.comparison == Comparison::Less;
  if (more ? a >= b + margin : less ? b >= a + margin : a == b) return kNothing;
  if (more || (!less && a < b)) {
    ways.add(toward_number(firsts, b + margin, INT_MAX, world, progress));
    ways.add(toward_number(seconds, 0, a - margin, world, progress));
  } else {
    ways.add(toward_number(seconds, a + margin, INT_MAX, world, progress));
    ways.add(toward_number(firsts, 0, b - margin, world, progress));
  }
  return ways.estimate();
}

Estimate Heuristic::toward_moment(const Goal::Node& node, const World& world, const Progress& progress) const {
  const auto part = progress.part(node.memory);
  if (part == Progress::Part::Broken) return kUnreachable;
  switch (node.op) {
    case Goal::Op::Sometime:
      return toward(node.children[0], true, world, progress);
    case Goal::Op::Until:
      return toward(node.children[1], true, world, progress);
    case Goal::Op::Before: {
      auto second = toward(node.children[1], true, world, progress);
      if (part == Progress::Part::FirstDone) return second;
      auto first = toward(node.children[0], true, world, progress);
      if (!first.possible() || !second.possible()) return kUnreachable;
      first.cost += second.cost;  // add up the costs, but work only on the first now
      return first;
    }
    default:
      return kUnreachable;
  }
}

}  // namespace unietp::symbolic
