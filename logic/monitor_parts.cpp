#include "logic/monitor_parts.h"

#include <algorithm>

namespace unietp::monitoring {
namespace {

using Kind = Node::Kind;

bool is_inner(Kind kind) {
  return kind == Kind::And || kind == Kind::Or || kind == Kind::Forall || kind == Kind::Exists || kind == Kind::Sum;
}

void instantiate_part(Part& part, Slot slot, EntityIndex entity, Residuals& residuals) {
  part.origin = residuals.instantiate(part.origin, slot, Value(entity));
  part.residual = residuals.instantiate(part.residual, slot, Value(entity));
  for (auto& group : part.groups) {
    for (auto& inner : group.parts) instantiate_part(inner, slot, entity, residuals);
    for (auto& inner : group.waiting) instantiate_part(inner, slot, entity, residuals);
  }
}

/// A member that its `:where` rules out is dropped; one that it lets in loses the condition.
void settle_guards(Part::Group& group, const Program& program, bool universal) {
  const Ref let_in = universal ? kFalse : kTrue, ruled_out = universal ? kTrue : kFalse;
  const auto guard = [&](const Part& part) { return part.groups.front().parts.front().residual; };
  const auto guarded = [&](const Part& part) {
    return part.groups.size() == 1 && part.groups.front().parts.size() == 2 &&
           program.nodes[part.groups.front().parts.front().node].kind == Kind::Guard;
  };
  std::erase_if(group.parts, [&](const Part& part) { return guarded(part) && guard(part) == ruled_out; });
  for (Part& part : group.parts) {
    if (!guarded(part) || guard(part) != let_in) continue;
    Part body = std::move(part.groups.front().parts.back());
    part = std::move(body);
  }
}

bool value_of(const Part& part, const Node& node) {
  if (node.kind != Kind::Sum) {
    const bool conjunctive = node.kind == Kind::And || node.kind == Kind::Forall;
    const auto& parts = part.groups.front().parts;
    return conjunctive ? std::all_of(parts.begin(), parts.end(), [](const Part& p) { return p.now; })
                       : std::any_of(parts.begin(), parts.end(), [](const Part& p) { return p.now; });
  }
  int total = node.constant;
  for (const auto& group : part.groups) {
    for (const auto& inner : group.parts) total += inner.now ? group.weight : 0;
  }
  return compare_with_zero(node.relation, total);
}

PartVerdict verdict_of_sum(const Part& part, const Node& node, const Program& program) {
  constexpr int kMany = 1 << 28;
  int low = node.constant, high = node.constant;
  for (const auto& group : part.groups) {
    for (const auto& inner : group.parts) {
      const PartVerdict verdict = verdict_of(inner, program);
      const int lowest = verdict == PartVerdict::Satisfied ? group.weight : std::min(0, group.weight);
      const int highest = verdict == PartVerdict::Satisfied ? group.weight : std::max(0, group.weight);
      low += verdict == PartVerdict::Violated ? 0 : lowest;
      high += verdict == PartVerdict::Violated ? 0 : highest;
    }
    for (const auto& inner : group.waiting) {
      if (verdict_of(inner, program) != PartVerdict::Violated) (group.weight > 0 ? high : low) += group.weight * kMany;
    }
  }
  if (low == high) return compare_with_zero(node.relation, low) ? PartVerdict::Satisfied : PartVerdict::Violated;
  const bool outside = low > 0 || high < 0;
  if (node.relation == Relation::Equal) return outside ? PartVerdict::Violated : PartVerdict::Undecided;
  if (node.relation == Relation::Unequal) return outside ? PartVerdict::Satisfied : PartVerdict::Undecided;
  const bool at_low = compare_with_zero(node.relation, low);
  if (at_low != compare_with_zero(node.relation, high)) return PartVerdict::Undecided;
  return at_low ? PartVerdict::Satisfied : PartVerdict::Violated;
}

}  // namespace

Part build_part(const Program& program, NodeId id, Residuals& residuals) {
  const Node& node = program.nodes[id];
  Part part;
  part.node = id;
  if (!is_inner(node.kind)) {
    std::vector<std::uint32_t> values;
    for (const Slot slot : node.free) values.push_back(Value::waiting(slot).word());
    part.origin = part.residual = residuals.pending(id, values);
    return part;
  }
  if (node.kind == Kind::And || node.kind == Kind::Or) {
    part.groups.emplace_back();
    for (const NodeId child : node.children) part.groups.front().parts.push_back(build_part(program, child, residuals));
    return part;
  }
  const auto add_quantified = [&](Slot slot, NodeId body, int weight) {
    Part::Group group;
    group.waiting.push_back(build_part(program, body, residuals));
    group.slot = slot;
    group.quantified = true;
    group.weight = weight;
    part.groups.push_back(std::move(group));
  };
  if (node.kind == Kind::Sum) {
    for (const auto& summand : node.summands) add_quantified(summand.slot, summand.body, summand.weight);
  } else {
    add_quantified(node.slot, node.children.front(), 1);
  }
  return part;
}

void update_part(Part& part, const Program& program, const KnownEntities& known, Residuals& residuals,
                 Progression& step) {
  if (part.groups.empty()) {
    part.now = step.holds_now(part.residual);
    part.residual = step.advance(part.residual);
    return;
  }
  const Node& node = program.nodes[part.node];
  for (auto& group : part.groups) {
    const bool fixed = group.quantified && program.quantifiers[group.slot].first_state_only;
    const bool first_time = fixed && !group.waiting.empty();
    if (group.quantified && !group.waiting.empty()) {
      const auto& members = known.members[group.slot];
      for (std::size_t i = known.fresh_from[group.slot]; i < members.size(); ++i) {
        group.parts.push_back(group.waiting.front());
        instantiate_part(group.parts.back(), group.slot, members[i], residuals);
      }
    }
    if (fixed) group.waiting.clear();
    for (auto& inner : group.parts) update_part(inner, program, known, residuals, step);
    for (auto& inner : group.waiting) update_part(inner, program, known, residuals, step);
    if (first_time) settle_guards(group, program, node.kind == Kind::Forall);
  }
  part.now = value_of(part, node);
}

PartVerdict verdict_of(const Part& part, const Program& program) {
  if (part.groups.empty()) {
    return part.residual == kFalse  ? PartVerdict::Violated
           : part.residual == kTrue ? PartVerdict::Satisfied
                                    : PartVerdict::Undecided;
  }
  const Node& node = program.nodes[part.node];
  if (node.kind == Kind::Sum) return verdict_of_sum(part, node, program);
  const bool conjunctive = node.kind == Kind::And || node.kind == Kind::Forall;
  const PartVerdict decisive = conjunctive ? PartVerdict::Violated : PartVerdict::Satisfied;
  PartVerdict result = conjunctive ? PartVerdict::Satisfied : PartVerdict::Violated;
  const auto& group = part.groups.front();
  for (const auto& inner : group.parts) {
    const PartVerdict verdict = verdict_of(inner, program);
    if (verdict == decisive) return decisive;
    if (verdict == PartVerdict::Undecided) result = PartVerdict::Undecided;
  }
  // An object that is yet to appear may never do so: it can keep the question open, not decide it.
  for (const auto& inner : group.waiting) {
    if (verdict_of(inner, program) != result) result = PartVerdict::Undecided;
  }
  return result;
}

}  // namespace unietp::monitoring
