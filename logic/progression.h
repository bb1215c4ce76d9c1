#pragma once

#include <optional>
#include <vector>

#include "logic/residual.h"

namespace unietp::monitoring {

/// What a monitor knows of the scene: the entities that have existed so far, sorted into the domains of the goal.
struct KnownEntities {
  std::vector<std::vector<EntityIndex>> members;  // by slot, in order of appearance
  std::vector<std::size_t> fresh_from;            // by slot: members from here on are new in the last state
  std::optional<EntityIndex> agent;
  Facts first, last;  // the first and the last observed state
};

/// Evaluates a program in the last observed state: its truth if the trace ends here (`now`, of a residual `holds_now`),
/// and the residual for the rest of the trace if it goes on (`next`, `advance`). Used for one step. Every variable
/// starts as waiting: for an entity that is yet to appear, of which nothing holds in this state.
class Progression {
 public:
  Progression(const Program& program, const KnownEntities& known, Residuals& residuals)
      : program_(program), known_(known), residuals_(residuals), facts_(&known.last) {
    for (Slot slot = 0; slot < program.quantifiers.size(); ++slot) values_.push_back(Value::waiting(slot));
  }

  bool holds_now(Ref ref);  // if the trace ends here
  Ref advance(Ref ref);     // what is asked of the next state on
  /// Gives the free variables of a pending residual their values; for reading its program node directly.
  void enter(Ref pending);

  bool now(const Node& node);  // if the trace ends here
  Ref next(NodeId node);       // what is asked of the next state on
  /// A node of the program that is run.
  const Node& node(NodeId id) const { return program_.nodes[id]; }
  /// What a variable stands for at present; may be set to read a body.
  Value& value(Slot slot) { return values_[slot]; }
  /// What an argument stands for with the variables as they are bound now.
  Value value(const Node::Argument& argument) const;

 private:
  bool holds_atom(const Node& node) const;
  bool now_quantified(const Node& node, bool universal);
  bool now_new(Ref ref, bool universal);
  int number_of(const Node& node);
  Ref next_same(Value a, Value b, bool positive);
  Ref next_junction(const std::vector<NodeId>& children, bool conjunctive);
  Ref next_quantifier(const Node& node);
  Ref next_sum(const Node& node);
  Ref advance_new(Ref ref);
  Ref advance_sum(Ref ref);
  Ref pending(NodeId node);
  Ref compute_advance(Ref ref);

  const Program& program_;
  const KnownEntities& known_;
  Residuals& residuals_;
  const Facts* facts_;         // the last state; inside a guard, the first
  std::vector<Value> values_;  // by slot
  std::vector<Ref> memo_;      // advance(ref) plus one; 0 is not yet known
};

}  // namespace unietp::monitoring
