#include <algorithm>

#include "symbolic/reach.h"

namespace unietp::symbolic {
namespace {

/// Walks through a goal and keeps the first atom that is out of reach.
class Walk {
 public:
  Walk(const Goal& goal, const Reach& reach, const Setting& setting, const World& start)
      : goal_(goal), reach_(reach), setting_(setting), start_(start), at_start_(goal) {}

  std::optional<OutOfReach> run() {
    if (may(goal_.root(), true)) return std::nullopt;
    return blamed_ ? *blamed_ : OutOfReach{};
  }

 private:
  bool now(std::size_t index) const { return holds(goal_, index, setting_, start_, at_start_); }

  std::pair<int, int> numbers(std::size_t from, std::size_t to, const std::vector<std::size_t>& children) {
    int least = 0, most = 0;
    for (std::size_t i = from; i < to; ++i) most += may(children[i], true) ? 1 : 0;
    const auto before = blamed_;
    for (std::size_t i = from; i < to; ++i) least += may(children[i], false) ? 0 : 1;
    blamed_ = before;
    return {least, most};
  }

  bool may(std::size_t index, bool wanted) {
    const auto& node = goal_.node(index);
    switch (node.op) {
      case Goal::Op::Atom: {
        const bool can = reach_.may(node.atom, wanted);
        if (!can && !blamed_) blamed_ = OutOfReach{node.atom, wanted};
        return can;
      }
      case Goal::Op::Not:
        return may(node.children[0], !wanted);
      case Goal::Op::And:
      case Goal::Op::Or: {
        const bool all = (node.op == Goal::Op::And) == wanted;
        const auto before = blamed_;
        for (const auto child : node.children) {
          const bool can = may(child, wanted);
          if (can != all) {
            if (can) blamed_ = before;
            return can;
          }
        }
        return all;
      }
      case Goal::Op::Count: {
        const auto [least, most] = numbers(0, node.children.size(), node.children);
        if (wanted) return most >= node.least && least <= node.most;
        return least < node.least || most > node.most;
      }
      case Goal::Op::Compare:
        return !wanted || may_compare(node);
      default:
        return may_moment(node, wanted);
    }
  }

  bool may_compare(const Goal::Node& node) {
    const auto [least_a, most_a] = numbers(0, node.split, node.children);
    const auto [least_b, most_b] = numbers(node.split, node.children.size(), node.children);
    switch (node.comparison) {
      case Comparison::AtLeast:
        return most_a >= least_b;
      case Comparison::Greater:
        return most_a > least_b;
      case Comparison::AtMost:
        return least_a <= most_b;
      case Comparison::Less:
        return least_a < most_b;
      case Comparison::Equal:
        return most_a >= least_b && most_b >= least_a;
    }
    return true;
  }

  bool may_moment(const Goal::Node& node, bool wanted) {
    if (!goal_.understood()) return true;
    const auto& children = node.children;
    switch (node.op) {
      case Goal::Op::AtEnd:
        return may(children[0], wanted);
      case Goal::Op::Sometime:
        return wanted ? may(children[0], true) : !now(children[0]);
      case Goal::Op::Always:
        return wanted ? now(children[0]) : may(children[0], false);
      case Goal::Op::Until:
        return !wanted || (may(children[1], true) && (now(children[0]) || now(children[1])));
      default:
        return !wanted || (!now(children[1]) && may(children[0], true) && may(children[1], true));
    }
  }

  const Goal& goal_;
  const Reach& reach_;
  const Setting& setting_;
  const World& start_;
  Progress at_start_;
  std::optional<OutOfReach> blamed_;
};

}  // namespace

std::optional<OutOfReach> out_of_reach(const Goal& goal, const Reach& reach, const Setting& setting,
                                       const World& start) {
  return Walk(goal, reach, setting, start).run();
}

}  // namespace unietp::symbolic
