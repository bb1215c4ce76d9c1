#include "logic/progression.h"

#include <algorithm>
#include <utility>

namespace unietp::monitoring {
namespace {

using Kind = Node::Kind;
using Rest = Residuals::Kind;

constexpr Ref truth(bool value) { return value ? kTrue : kFalse; }

}  // namespace

Value Progression::value(const Node::Argument& argument) const {
  if (argument.kind != Node::Argument::Kind::Agent) return values_[argument.slot];
  return known_.agent ? Value(*known_.agent) : Value::nothing();
}

void Progression::enter(Ref pending_ref) {
  const auto words = residuals_.data(pending_ref);
  const auto& free = program_.nodes[residuals_.id(pending_ref)].free;
  for (std::size_t i = 0; i < free.size(); ++i) values_[free[i]] = Value::from_word(words[i]);
}

Ref Progression::pending(NodeId id) {
  const auto& free = program_.nodes[id].free;
  std::vector<std::uint32_t> values;
  values.reserve(free.size());
  for (const Slot slot : free) values.push_back(values_[slot].word());
  return residuals_.pending(id, values);
}

bool Progression::holds_atom(const Node& node) const {
  const Value first = value(node.arguments[0]);
  if (first.waits()) return false;
  switch (node.arguments[1].kind) {
    case Node::Argument::Kind::None:
      return facts_->holds(node.predicate, first.entity());
    case Node::Argument::Kind::Symbol:
      return facts_->holds(node.predicate, first.entity(), node.arguments[1].symbol);
    default:
      break;
  }
  const Value second = value(node.arguments[1]);
  return !second.waits() && facts_->holds(node.predicate, first.entity(), second.entity());
}

bool Progression::now_quantified(const Node& node, bool universal) {
  bool result = universal;
  for (const EntityIndex e : known_.members[node.slot]) {
    values_[node.slot] = Value(e);
    if (now(program_.nodes[node.children[0]]) == universal) continue;
    result = !universal;
    break;
  }
  values_[node.slot] = Value::waiting(node.slot);
  return result;
}

int Progression::number_of(const Node& node) {
  int total = node.constant;
  for (const auto& summand : node.summands) {
    for (const EntityIndex e : known_.members[summand.slot]) {
      values_[summand.slot] = Value(e);
      if (now(program_.nodes[summand.body])) total += summand.weight;
    }
    values_[summand.slot] = Value::waiting(summand.slot);
  }
  return total;
}

bool Progression::now(const Node& node) {
  switch (node.kind) {
    case Kind::True:
      return true;
    case Kind::False:
      return false;
    case Kind::Atom:
      return holds_atom(node) == node.positive;
    case Kind::Same:
      return (value(node.arguments[0]) == value(node.arguments[1])) == node.positive;
    case Kind::And:
      return std::all_of(node.children.begin(), node.children.end(), [&](NodeId c) { return now(program_.nodes[c]); });
    case Kind::Or:
      return std::any_of(node.children.begin(), node.children.end(), [&](NodeId c) { return now(program_.nodes[c]); });
    case Kind::Forall:
      return now_quantified(node, true);
    case Kind::Exists:
      return now_quantified(node, false);
    case Kind::Sum:
      return compare_with_zero(node.relation, number_of(node));
    case Kind::AtEnd:
    case Kind::Sometime:
    case Kind::Always:
      return now(program_.nodes[node.children[0]]);
    case Kind::Until:
    case Kind::Release:
      return now(program_.nodes[node.children[1]]);
    case Kind::Guard: {
      const Facts* const outside = std::exchange(facts_, &known_.first);
      const bool result = now(program_.nodes[node.children[0]]);
      facts_ = outside;
      return result;
    }
  }
  return false;
}

Ref Progression::next_same(Value a, Value b, bool positive) {
  if (a == b) return truth(positive);
  // A waiting variable is none of the entities known by now; of two waiting ones nothing is known yet.
  if (!a.waits() || !b.waits()) return truth(!positive);
  return residuals_.same(a, b, positive);
}

Ref Progression::next_junction(const std::vector<NodeId>& children, bool conjunctive) {
  std::vector<Ref> parts;
  for (const NodeId child : children) {
    const Ref part = next(child);
    if (part == truth(!conjunctive)) return part;
    if (part != truth(conjunctive)) parts.push_back(part);
  }
  return conjunctive ? residuals_.conjunction(std::move(parts)) : residuals_.disjunction(std::move(parts));
}

Ref Progression::next_quantifier(const Node& node) {
  const bool universal = node.kind == Kind::Forall;
  std::vector<Ref> parts;
  bool decided = false;
  for (const EntityIndex e : known_.members[node.slot]) {
    values_[node.slot] = Value(e);
    const Ref part = next(node.children[0]);
    decided = part == truth(!universal);
    if (decided) break;
    if (part != truth(universal)) parts.push_back(part);
  }
  values_[node.slot] = Value::waiting(node.slot);
  if (decided) return truth(!universal);
  if (!program_.quantifiers[node.slot].first_state_only) {
    const Ref body = next(node.children[0]);
    parts.push_back(universal ? residuals_.for_new(node.slot, body) : residuals_.some_new(node.slot, body));
  }
  return universal ? residuals_.conjunction(std::move(parts)) : residuals_.disjunction(std::move(parts));
}

Ref Progression::next_sum(const Node& node) {
  std::vector<Residuals::Term> terms;
  std::vector<Residuals::NewTerm> news;
  for (const auto& summand : node.summands) {
    for (const EntityIndex e : known_.members[summand.slot]) {
      values_[summand.slot] = Value(e);
      terms.push_back({next(summand.body), summand.weight});
    }
    values_[summand.slot] = Value::waiting(summand.slot);
    if (program_.quantifiers[summand.slot].first_state_only) continue;
    news.push_back({summand.slot, next(summand.body), summand.weight});
  }
  return residuals_.sum(node.relation, node.constant, std::move(terms), std::move(news));
}

Ref Progression::next(NodeId id) {
  const Node& node = program_.nodes[id];
  switch (node.kind) {
    case Kind::True:
      return kTrue;
    case Kind::False:
      return kFalse;
    case Kind::Atom:
      return truth(holds_atom(node) == node.positive);
    case Kind::Same:
      return next_same(value(node.arguments[0]), value(node.arguments[1]), node.positive);
    case Kind::And:
      return next_junction(node.children, true);
    case Kind::Or:
      return next_junction(node.children, false);
    case Kind::Forall:
    case Kind::Exists:
      return next_quantifier(node);
    case Kind::Sum:
      return next_sum(node);
    case Kind::AtEnd:
      return pending(id);
    case Kind::Sometime: {
      const Ref body = next(node.children[0]);
      return body == kTrue ? kTrue : residuals_.disjunction({body, pending(id)});
    }
    case Kind::Always: {
      const Ref body = next(node.children[0]);
      return body == kFalse ? kFalse : residuals_.conjunction({body, pending(id)});
    }
    case Kind::Until: {
      const Ref goal = next(node.children[1]);
      if (goal == kTrue) return kTrue;
      const Ref meanwhile = next(node.children[0]);
      return residuals_.disjunction({goal, residuals_.conjunction({meanwhile, pending(id)})});
    }
    case Kind::Release: {
      const Ref kept = next(node.children[1]);
      if (kept == kFalse) return kFalse;
      const Ref released = next(node.children[0]);
      return residuals_.conjunction({kept, residuals_.disjunction({released, pending(id)})});
    }
    case Kind::Guard: {
      const Facts* const outside = std::exchange(facts_, &known_.first);
      const Ref result = next(node.children[0]);
      facts_ = outside;
      return result;
    }
  }
  return kFalse;
}

bool Progression::now_new(Ref ref, bool universal) {
  const Slot slot = residuals_.id(ref);
  const Ref body = residuals_.data(ref)[0];
  const auto& members = known_.members[slot];
  for (std::size_t i = known_.fresh_from[slot]; i < members.size(); ++i) {
    if (holds_now(residuals_.instantiate(body, slot, Value(members[i]))) != universal) return !universal;
  }
  return universal;
}

bool Progression::holds_now(Ref ref) {
  switch (residuals_.kind(ref)) {
    case Rest::False:
      return false;
    case Rest::True:
      return true;
    case Rest::Pending:
      enter(ref);
      return now(program_.nodes[residuals_.id(ref)]);
    case Rest::Same:
      return residuals_.data(ref)[2] == 0;  // still waiting: different, were both to come
    case Rest::And:
    case Rest::Or: {
      const bool conjunctive = residuals_.kind(ref) == Rest::And;
      for (std::size_t i = 0; i < residuals_.data(ref).size(); ++i) {  // the store may grow meanwhile
        if (holds_now(residuals_.data(ref)[i]) != conjunctive) return !conjunctive;
      }
      return conjunctive;
    }
    case Rest::ForNew:
      return now_new(ref, true);
    case Rest::SomeNew:
      return now_new(ref, false);
    case Rest::Sum: {
      const auto view = residuals_.view_sum(ref);
      int total = view.constant;
      for (const auto& term : view.terms) total += holds_now(term.part) ? term.weight : 0;
      for (const auto& term : view.news) {
        const auto& members = known_.members[term.slot];
        for (std::size_t i = known_.fresh_from[term.slot]; i < members.size(); ++i) {
          total += holds_now(residuals_.instantiate(term.part, term.slot, Value(members[i]))) ? term.weight : 0;
        }
      }
      return compare_with_zero(view.relation, total);
    }
  }
  return false;
}

Ref Progression::advance(Ref ref) {
  if (memo_.size() <= ref) memo_.resize(residuals_.size(), 0);
  if (memo_[ref] != 0) return memo_[ref] - 1;
  const Ref result = compute_advance(ref);
  if (memo_.size() <= ref) memo_.resize(residuals_.size(), 0);
  memo_[ref] = result + 1;
  return result;
}

Ref Progression::compute_advance(Ref ref) {
  switch (residuals_.kind(ref)) {
    case Rest::False:
    case Rest::True:
      return ref;
    case Rest::Pending:
      enter(ref);
      return next(residuals_.id(ref));
    case Rest::Same: {
      const auto words = residuals_.data(ref);
      return next_same(Value::from_word(words[0]), Value::from_word(words[1]), words[2] != 0);
    }
    case Rest::And:
    case Rest::Or: {
      const bool conjunctive = residuals_.kind(ref) == Rest::And;
      std::vector<Ref> parts;
      for (std::size_t i = 0; i < residuals_.data(ref).size(); ++i) {  // the store may grow meanwhile
        const Ref part = advance(residuals_.data(ref)[i]);
        if (part == truth(!conjunctive)) return part;
        parts.push_back(part);
      }
      return conjunctive ? residuals_.conjunction(std::move(parts)) : residuals_.disjunction(std::move(parts));
    }
    case Rest::ForNew:
    case Rest::SomeNew:
      return advance_new(ref);
    case Rest::Sum:
      return advance_sum(ref);
  }
  return kFalse;
}

Ref Progression::advance_new(Ref ref) {
  const bool universal = residuals_.kind(ref) == Rest::ForNew;
  const Slot slot = residuals_.id(ref);
  const Ref body = residuals_.data(ref)[0];
  const auto& members = known_.members[slot];
  std::vector<Ref> parts;
  for (std::size_t i = known_.fresh_from[slot]; i < members.size(); ++i) {
    parts.push_back(advance(residuals_.instantiate(body, slot, Value(members[i]))));
  }
  const Ref rest = advance(body);
  parts.push_back(universal ? residuals_.for_new(slot, rest) : residuals_.some_new(slot, rest));
  return universal ? residuals_.conjunction(std::move(parts)) : residuals_.disjunction(std::move(parts));
}

Ref Progression::advance_sum(Ref ref) {
  auto view = residuals_.view_sum(ref);
  for (auto& term : view.terms) term.part = advance(term.part);
  const auto news = view.news;
  for (std::size_t k = 0; k < news.size(); ++k) {
    const auto& members = known_.members[news[k].slot];
    for (std::size_t i = known_.fresh_from[news[k].slot]; i < members.size(); ++i) {
      const Ref instance = residuals_.instantiate(news[k].part, news[k].slot, Value(members[i]));
      view.terms.push_back({advance(instance), news[k].weight});
    }
    view.news[k].part = advance(news[k].part);
  }
  return residuals_.sum(view.relation, view.constant, std::move(view.terms), std::move(view.news));
}

}  // namespace unietp::monitoring
