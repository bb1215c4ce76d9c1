#include <algorithm>
#include <climits>

#include "pddl/monitors.h"
#include "pddl/problem.h"

namespace unietp::pddl {
namespace {

using symbolic::Goal;

constexpr std::size_t kMostText = 400'000;  // bytes of a goal
constexpr double kMostCases = 20'000;       // conjunctions in disjunctive normal form, which many planners build

/// A part of a goal, and the number of conjunctions in its disjunctive normal form.
struct Part {
  std::string text;
  double cases = 1;
};
const Part kTrue{"(and)", 1}, kFalse{"(or)", 0};

class GoalTextWriter {
 public:
  GoalTextWriter(const Goal& goal, const Problem& names) : goal_(goal), names_(names) {}

  Result<GoalText> write() {
    if (!goal_.understood()) refuse("a temporal operator is inside another");
    const Part goal = text(goal_.root(), true);
    made_.goal = goal.text;
    if (goal.text.size() > kMostText) refuse("its numbers take too many literals");
    if (goal.cases > kMostCases) refuse("it is one of too many cases");
    if (goal.text == kTrue.text || goal.text == kFalse.text) refuse("it does not depend on what is done");
    if (!problem_.empty()) return Error{Error::Kind::Unsatisfiable, "goal", {}, problem_};
    return std::move(made_);
  }

 private:
  void refuse(const std::string& why) {
    if (problem_.empty()) problem_ = why;
  }

  static Part joined(const std::string& op, const std::vector<Part>& parts) {
    const bool all = op == "and";
    const Part& neutral = all ? kTrue : kFalse;
    const Part& zero = all ? kFalse : kTrue;
    Part joint{"", neutral.cases};
    std::size_t number = 0;
    for (const Part& part : parts) {
      if (part.text == zero.text) return zero;
      if (part.text == neutral.text) continue;
      joint.text += " " + part.text;
      joint.cases = all ? joint.cases * part.cases : joint.cases + part.cases;
      ++number;
    }
    if (number == 0) return neutral;
    joint.text = number == 1 ? joint.text.substr(1) : "(" + op + joint.text + ")";
    return joint;
  }

  /// The node, or with `wanted` false its negation; "not" stands only before atoms.
  Part text(std::size_t index, bool wanted) {
    if (!problem_.empty()) return kTrue;
    const auto& node = goal_.node(index);
    switch (node.op) {
      case Goal::Op::Atom:
        return atom(node.atom, wanted);
      case Goal::Op::Not:
        return text(node.children[0], !wanted);
      case Goal::Op::AtEnd:
        return text(node.children[0], wanted);
      case Goal::Op::And:
      case Goal::Op::Or: {
        std::vector<Part> parts;
        for (const auto child : node.children) {
          if (node.op != Goal::Op::And || !goes_without_saying(child, node.children))
            parts.push_back(text(child, wanted));
        }
        return joined((node.op == Goal::Op::And) == wanted ? "and" : "or", parts);
      }
      case Goal::Op::Count: {
        if (wanted && node.least == node.most) return choices(node.children, node.least, true, true);
        const auto enough = at_least(node.children, node.least, wanted);
        const auto few =
            node.most == INT_MAX ? (wanted ? kTrue : kFalse) : at_least(node.children, node.most + 1, !wanted);
        return joined(wanted ? "and" : "or", {enough, few});
      }
      case Goal::Op::Compare:
        return compared(node, wanted);
      default:
        return monitored(node, wanted);
    }
  }

  /// The thing that must exist for the node, a single atom, to hold; kNobody for all other nodes.
  symbolic::Id certainly_there(std::size_t index) const {
    const auto& node = goal_.node(index);
    const bool wraps = node.op == Goal::Op::AtEnd ||
                       ((node.op == Goal::Op::And || node.op == Goal::Op::Or) && node.children.size() == 1);
    if (wraps) return certainly_there(node.children[0]);
    const bool says = node.op == Goal::Op::Atom && node.atom.predicate != Predicate::SliceOf;
    return says && node.atom.first.is_thing() ? node.atom.first : symbolic::kNobody;
  }

  /// Whether the node, that a piece exists, is implied by a sibling: an atom about the piece.
  bool goes_without_saying(std::size_t index, const std::vector<std::size_t>& beside) const {
    const auto& node = goal_.node(index);
    if (node.op != Goal::Op::Atom || node.atom.predicate != Predicate::SliceOf) return false;
    return std::any_of(beside.begin(), beside.end(),
                       [&](std::size_t other) { return certainly_there(other) == node.atom.first; });
  }

  /// The disjunction over all choices of k children: these hold (or, with `wanted` false, do not), and with `no_other`
  /// the other children do not (or do).
  Part choices(const std::vector<std::size_t>& children, int k, bool wanted, bool no_other) {
    const auto n = static_cast<int>(children.size());
    if (k < 0 || k > n) return kFalse;
    std::vector<Part> ways;
    std::vector<bool> chosen(children.size(), false);
    std::size_t length = 0;
    const auto choose = [&](auto&& self, int from, int left) -> void {
      if (length > kMostText) return refuse("its numbers take too many literals");
      if (left == 0) {
        std::vector<Part> parts;
        for (std::size_t i = 0; i < children.size(); ++i) {
          if (chosen[i] || no_other) parts.push_back(text(children[i], chosen[i] == wanted));
        }
        ways.push_back(joined("and", parts));
        length += ways.back().text.size();
        return;
      }
      for (int i = from; i <= n - left; ++i) {
        chosen[static_cast<std::size_t>(i)] = true;
        self(self, i + 1, left - 1);
        chosen[static_cast<std::size_t>(i)] = false;
      }
    };
    choose(choose, 0, k);
    return joined("or", ways);
  }

  /// At least k of the children hold; or fewer do: all but k - 1 of them do not.
  Part at_least(const std::vector<std::size_t>& children, int k, bool wanted) {
    const auto n = static_cast<int>(children.size());
    if (k <= 0) return wanted ? kTrue : kFalse;
    if (k > n) return wanted ? kFalse : kTrue;
    return choices(children, wanted ? k : n - k + 1, wanted, false);
  }

  Part compared(const Goal::Node& node, bool wanted) {
    const auto middle = node.children.begin() + static_cast<std::ptrdiff_t>(node.split);
    std::vector<std::size_t> a(node.children.begin(), middle), b(middle, node.children.end());
    // `more` of `x` than of `y`, by `margin`: for each k, k of y bring k + margin of x.
    const auto more = [&](const auto& x, const auto& y, int margin) {
      std::vector<Part> parts;
      for (int k = 0; k <= static_cast<int>(y.size()); ++k) {
        const auto y_has = at_least(y, k, !wanted);
        const auto x_has = at_least(x, k + margin, wanted);
        parts.push_back(joined(wanted ? "or" : "and", {y_has, x_has}));
      }
      return joined(wanted ? "and" : "or", parts);
    };
    switch (node.comparison) {
      case Comparison::AtLeast:
        return more(a, b, 0);
      case Comparison::Greater:
        return more(a, b, 1);
      case Comparison::AtMost:
        return more(b, a, 0);
      case Comparison::Less:
        return more(b, a, 1);
      case Comparison::Equal:
        break;
    }
    return joined(wanted ? "and" : "or", {more(a, b, 0), more(b, a, 0)});
  }

  Part atom(const symbolic::Atom& atom, bool wanted) {
    const auto fact = fact_of(atom, names_);
    if (!fact) {
      refuse("(" + std::string(info(atom.predicate).name) + " …) is nothing that the domain's actions bring about");
      return kTrue;
    }
    return flag(*fact, wanted);
  }

  static Part flag(const std::string& fact, bool wanted) { return {wanted ? fact : "(not " + fact + ")", 1}; }

  Part monitored(const Goal::Node& node, bool wanted) {
    // `always` of a conjunction is the conjunction of `always` of each part.
    const auto& children = node.children;
    if (node.op == Goal::Op::Always && goal_.node(children[0]).op == Goal::Op::And) {
      std::vector<Part> parts;
      for (const auto child : goal_.node(children[0]).children) {
        const auto watch = monitor(child);
        if (watch) parts.push_back(flag("(missed " + name(*watch) + ")", !wanted));
      }
      return joined(wanted ? "and" : "or", parts);
    }
    const auto first = monitor(children[0]);
    const auto second = children.size() > 1 ? monitor(children[1]) : first;
    if (!first || !second) return kTrue;
    const auto both = " " + name(*first) + " " + name(*second) + ")";
    switch (node.op) {
      case Goal::Op::Sometime:
        return flag("(seen " + name(*first) + ")", wanted);
      case Goal::Op::Always:
        return flag("(missed " + name(*first) + ")", !wanted);
      case Goal::Op::Before:
        made_.ordered.emplace_back(*first, *second);
        return flag("(in-order" + both, wanted);
      default:
        made_.kept.emplace_back(*first, *second);
        return joined(wanted ? "and" : "or",
                      {flag("(seen " + name(*second) + ")", wanted), flag("(not-kept" + both, !wanted)});
    }
  }

  std::string name(std::size_t monitor) const { return made_.monitors[monitor].name; }

  /// A monitor of an atom or its opposite.
  std::optional<std::size_t> monitor(std::size_t index) {
    bool negative = false;
    auto at = index;
    for (;;) {
      const auto& node = goal_.node(at);
      const bool single = (node.op == Goal::Op::And || node.op == Goal::Op::Or) && node.children.size() == 1;
      if (node.op == Goal::Op::Not) negative = !negative;
      if (node.op != Goal::Op::Not && !single) break;
      at = node.children[0];
    }
    const auto& node = goal_.node(at);
    if (node.op != Goal::Op::Atom) {
      refuse("a temporal operator has more than one literal");
      return std::nullopt;
    }
    if (!fact_of(node.atom, names_) || node.atom.predicate == Predicate::SliceOf ||
        (node.atom.predicate == Predicate::Covered && !node.atom.symbol)) {
      refuse("a temporal operator refers to (" + std::string(info(node.atom.predicate).name) +
             " …), which no monitor watches");
      return std::nullopt;
    }
    for (std::size_t i = 0; i < made_.monitors.size(); ++i) {
      const auto& known = made_.monitors[i];
      if (known.negative == negative && fact_of(known.atom, names_) == fact_of(node.atom, names_)) return i;
    }
    made_.monitors.push_back({"m" + std::to_string(made_.monitors.size() + 1), node.atom, negative});
    return made_.monitors.size() - 1;
  }

  const Goal& goal_;
  const Problem& names_;
  GoalText made_;
  std::string problem_;
};

}  // namespace

std::optional<std::string> fact_of(const symbolic::Atom& atom, const Problem& names) {
  using enum Predicate;
  const auto thing = [&](symbolic::Id id) { return " " + names.things[id.index()]; };
  const auto room = [&](symbolic::Id id) { return " " + names.rooms[id.index()]; };
  const auto word = std::string(info(atom.predicate).name);
  if (atom.predicate == InRoom && atom.first == symbolic::kAgent) return "(agent-in" + room(atom.second) + ")";
  if (!atom.first.is_thing()) return std::nullopt;
  const bool symbol = atom.symbol.has_value();
  switch (atom.predicate) {
    case On:
    case Inside:
      return "(" + word + thing(atom.first) + thing(atom.second) + ")";
    case OnFloor:
    case InRoom:
      return "(" + word + thing(atom.first) + room(atom.second) + ")";
    case SliceOf:
      return "(present" + thing(atom.first) + ")";
    case Filled:
      return symbol ? "(filled-with" + thing(atom.first) + " " + names.substances[atom.symbol->index()] + ")"
                    : "(filled" + thing(atom.first) + ")";
    case Covered: {
      if (symbol) return "(covered-with" + thing(atom.first) + " " + names.substances[atom.symbol->index()] + ")";
      return std::nullopt;
    }
    default:
      break;
  }
  const auto& all = all_watched();
  const bool known = std::any_of(all.begin(), all.end(), [&](const MonitoredPredicate& watched) {
    return watched.predicate == atom.predicate && watched.name == word && watched.variables == "?x";
  });
  if (!known) return std::nullopt;
  return "(" + word + thing(atom.first) + ")";
}

Result<GoalText> goal_text(const symbolic::Goal& goal, const Problem& names) {
  return GoalTextWriter(goal, names).write();
}

}  // namespace unietp::pddl
