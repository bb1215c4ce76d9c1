#pragma once

#include "fuzz_bodies.h"
#include "logic/evaluate.h"
#include "logic/formula.h"
#include "logic/monitor.h"

namespace unietp::fuzz {

/// Any bytes are refused with a position, or give a formula that prints and parses to itself, has a stable normal form,
/// and on which both evaluators agree on a small trace. True when it is a goal.
inline bool parse_formula_body(std::string_view text) {
  bool goal = false;
  for (const FormulaUse use : {FormulaUse::Goal, FormulaUse::State}) {
    const auto parsed = parse_formula("fuzz", text, use);
    if (!parsed) {
      require(parsed.error().pos.line >= 1 && !parsed.error().message.empty());
      continue;
    }
    const auto again = parse_formula("fuzz", to_text(*parsed), use);
    require(static_cast<bool>(again));
    require(*again == *parsed);
    goal |= use == FormulaUse::Goal;
    constexpr std::size_t kLongForAnOrder = 400;  // the normal form tries orders of quantifiers
    if (text.size() > kLongForAnOrder) continue;
    require(normal_form(normal_form(*parsed)) == normal_form(*parsed));
    Trace trace;
    trace.entities = {{Entity::Kind::Object, "a_1", "A", ""}, {Entity::Kind::Room, "r_1", "R", ""}};
    Facts facts;
    facts.set_exists(EntityIndex(0));
    facts.set_exists(EntityIndex(1));
    facts.set(Predicate::Open, EntityIndex(0));
    trace.states = {facts, facts};
    Monitor monitor(*parsed);
    monitor.observe(trace.entities, facts);
    monitor.observe(trace.entities, facts);
    require(monitor.satisfied() == holds(*parsed, trace));
    require((monitor.progress() == 1.0) == monitor.satisfied());
  }
  return goal;
}

}  // namespace unietp::fuzz
