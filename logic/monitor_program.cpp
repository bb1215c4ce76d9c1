#include "logic/monitor_program.h"

#include <algorithm>
#include <cassert>

namespace unietp::monitoring {
namespace {

using Op = Formula::Op;

Relation relation_of(Comparison comparison, bool positive) {
  switch (comparison) {
    case Comparison::Equal:
      return positive ? Relation::Equal : Relation::Unequal;
    case Comparison::AtLeast:
      return positive ? Relation::AtLeast : Relation::Less;
    case Comparison::AtMost:
      return positive ? Relation::AtMost : Relation::Greater;
    case Comparison::Greater:
      return positive ? Relation::Greater : Relation::AtMost;
    case Comparison::Less:
      return positive ? Relation::Less : Relation::AtLeast;
  }
  return Relation::Equal;
}

std::string words_of(const Domain& domain) {
  switch (domain.kind) {
    case Domain::Kind::Object:
      return "object";
    case Domain::Kind::Room:
      return "room";
    case Domain::Kind::Agent:
      return "agent";
    case Domain::Kind::Categories:
      break;
  }
  std::string words;
  for (const auto& member : domain.members) {
    if (!words.empty()) words += " or ";
    if (member.slice) words += "slice of ";
    words += member.category;
  }
  return words;
}

class Compiler {
 public:
  Program run(const Formula& goal) {
    program_.root = compile(goal, true);
    return std::move(program_);
  }

 private:
  NodeId add(Node node) {
    std::vector<Slot> free;
    for (const auto& argument : node.arguments) {
      if (argument.kind == Node::Argument::Kind::Variable) free.push_back(argument.slot);
    }
    const auto take = [&](NodeId child, const Slot* bound) {
      for (const Slot slot : program_.nodes[child].free) {
        if (bound == nullptr || slot != *bound) free.push_back(slot);
      }
    };
    const bool binds = node.kind == Node::Kind::Forall || node.kind == Node::Kind::Exists;
    for (const NodeId child : node.children) take(child, binds ? &node.slot : nullptr);
    for (const auto& summand : node.summands) take(summand.body, &summand.slot);
    std::sort(free.begin(), free.end());
    free.erase(std::unique(free.begin(), free.end()), free.end());
    node.free = std::move(free);
    program_.nodes.push_back(std::move(node));
    return static_cast<NodeId>(program_.nodes.size() - 1);
  }

  NodeId make(Node::Kind kind, std::vector<NodeId> children) {
    Node node;
    node.kind = kind;
    node.children = std::move(children);
    return add(std::move(node));
  }

  Node::Argument argument(const Term& term) const {
    Node::Argument result;
    if (term.kind == Term::Kind::Agent) result.kind = Node::Argument::Kind::Agent;
    if (term.kind == Term::Kind::Symbol) {
      result.kind = Node::Argument::Kind::Symbol;
      result.symbol = term.name;
    }
    if (term.kind == Term::Kind::Variable) {
      result.kind = Node::Argument::Kind::Variable;
      const auto at = std::find_if(scope_.rbegin(), scope_.rend(), [&](const auto& v) { return v.first == term.name; });
      assert(at != scope_.rend() && "a goal has no free variables");
      result.slot = at->second;
    }
    return result;
  }

  NodeId literal(const Formula& formula, bool positive) {
    Node node;
    node.kind = formula.op == Op::Equal ? Node::Kind::Same : Node::Kind::Atom;
    node.positive = positive;
    node.predicate = formula.predicate;
    for (std::size_t i = 0; i < formula.terms.size() && i < 2; ++i) node.arguments[i] = argument(formula.terms[i]);
    return add(std::move(node));
  }

  NodeId parts(Node::Kind kind, const Formula& formula, bool positive) {
    std::vector<NodeId> children;
    for (const auto& child : formula.children) children.push_back(compile(child, positive));
    return make(kind, std::move(children));
  }

  struct Bound {
    Slot slot;
    NodeId body;
  };

  /// The body of a quantifier joined with its guard: `guard and body`, or for a universal one `not guard or body`.
  Bound bound_body(const Formula& formula, bool positive, bool universal) {
    const auto slot = static_cast<Slot>(program_.quantifiers.size());
    program_.quantifiers.push_back({formula.domain, !formula.domain.where.empty(), words_of(formula.domain)});
    scope_.emplace_back(formula.variable, slot);
    NodeId body = compile(formula.children.front(), positive);
    if (!formula.domain.where.empty()) {
      const NodeId guard = make(Node::Kind::Guard, {compile(formula.domain.where.front(), !universal)});
      body = make(universal ? Node::Kind::Or : Node::Kind::And, {guard, body});
    }
    scope_.pop_back();
    return {slot, body};
  }

  NodeId quantifier(const Formula& formula, bool positive) {
    const bool universal = (formula.op == Op::Forall) == positive;
    const Bound bound = bound_body(formula, positive, universal);
    Node node;
    node.kind = universal ? Node::Kind::Forall : Node::Kind::Exists;
    node.slot = bound.slot;
    node.children = {bound.body};
    return add(std::move(node));
  }

  NodeId sum(const Formula& formula, bool positive) {
    Node node;
    node.kind = Node::Kind::Sum;
    node.relation = relation_of(formula.comparison, positive);
    const auto summand = [&](const Formula& number, int weight) {
      const Bound bound = bound_body(number, true, false);
      node.summands.push_back({weight, bound.slot, bound.body});
    };
    if (formula.op == Op::Count) {
      node.constant = -formula.number;
      summand(formula, 1);
    } else {
      summand(formula.children[0], 1);
      summand(formula.children[1], -1);
    }
    return add(std::move(node));
  }

  NodeId until(const Formula& first, bool first_positive, const Formula& second, bool positive) {
    const NodeId f = compile(first, first_positive), g = compile(second, positive);
    return make(positive ? Node::Kind::Until : Node::Kind::Release, {f, g});
  }

  /// f first strictly before g first: `(not g) until (f and not g)`, and sometime g.
  NodeId before(const Formula& formula, bool positive) {
    const Formula& f = formula.children[0];
    const Formula& g = formula.children[1];
    const NodeId not_g = compile(g, !positive);
    const NodeId f_alone =
        make(positive ? Node::Kind::And : Node::Kind::Or, {compile(f, positive), compile(g, !positive)});
    const NodeId order = make(positive ? Node::Kind::Until : Node::Kind::Release, {not_g, f_alone});
    const NodeId happens = make(positive ? Node::Kind::Sometime : Node::Kind::Always, {compile(g, positive)});
    return make(positive ? Node::Kind::And : Node::Kind::Or, {order, happens});
  }

  NodeId compile(const Formula& formula, bool positive) {
    switch (formula.op) {
      case Op::Atom:
      case Op::Equal:
        return literal(formula, positive);
      case Op::And:
        return parts(positive ? Node::Kind::And : Node::Kind::Or, formula, positive);
      case Op::Or:
        return parts(positive ? Node::Kind::Or : Node::Kind::And, formula, positive);
      case Op::Not:
        return compile(formula.children.front(), !positive);
      case Op::Imply: {
        const NodeId premise = compile(formula.children[0], !positive);
        const NodeId conclusion = compile(formula.children[1], positive);
        return make(positive ? Node::Kind::Or : Node::Kind::And, {premise, conclusion});
      }
      case Op::Forall:
      case Op::Exists:
        return quantifier(formula, positive);
      case Op::Count:
      case Op::CountCompare:
        return sum(formula, positive);
      case Op::AtEnd:
        return parts(Node::Kind::AtEnd, formula, positive);
      case Op::Sometime:
        return parts(positive ? Node::Kind::Sometime : Node::Kind::Always, formula, positive);
      case Op::Always:
        return parts(positive ? Node::Kind::Always : Node::Kind::Sometime, formula, positive);
      case Op::Until:
        return until(formula.children[0], positive, formula.children[1], positive);
      case Op::Before:
        return before(formula, positive);
      case Op::Number:
        break;
    }
    assert(false && "a number stands only in a comparison of counts");
    return make(Node::Kind::False, {});
  }

  Program program_;
  std::vector<std::pair<std::string, Slot>> scope_;
};

}  // namespace

bool compare_with_zero(Relation relation, int value) {
  switch (relation) {
    case Relation::Equal:
      return value == 0;
    case Relation::Unequal:
      return value != 0;
    case Relation::AtLeast:
      return value >= 0;
    case Relation::AtMost:
      return value <= 0;
    case Relation::Greater:
      return value > 0;
    case Relation::Less:
      return value < 0;
  }
  return false;
}

Program compile(const Formula& goal) { return Compiler().run(goal); }

}  // namespace unietp::monitoring
