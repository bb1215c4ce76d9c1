#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "expert/execution_tree.h"

namespace unietp {

/// No entity.
inline constexpr EntityIndex kNobody = EntityIndex::none();

/// A slice that does not exist yet: the `ordinal`-th (from 0) that cutting `whole` would make.
struct ImaginedSlice {
  EntityIndex whole = kNobody;
  int ordinal = 0;
};

/// The start of an episode as the planner sees it. Entities are those of the start in the order of FactReader, so their
/// indices stay valid in every trace that begins there; after them come the slices that could be cut, which are told
/// apart by index and looked up by (whole, ordinal) once they exist.
struct Situation {
  const Scene* start = nullptr;
  const Knowledge* knowledge = nullptr;
  Profile profile;  // with the actions that the mode offers
  Trace trace;      // the start, then an imagined state in which all slices exist too
  EntityIndex first_imagined;
  std::vector<ImaginedSlice> imagined;
  static constexpr double kFar_m = 100;

  /// Of the start; of an imagined slice its whole's; nullptr for rooms, the agent and what is gone.
  const Node* node(EntityIndex index) const;
  /// The closed container around it, or kNobody; of an imagined slice the one around its whole.
  EntityIndex shut_in(EntityIndex index) const;
  const NodeIndex& places() const { return executions_->places(); }
  /// Entity of the start by id; nullopt when there is none.
  std::optional<EntityIndex> find(std::string_view id) const;
  /// From where the agent stands, capped at kFar_m; of an imagined slice its whole's.
  double walk_m(EntityIndex index) const;
  /// No more than that, and found at once.
  double straight_m(EntityIndex index) const;
  /// What holds at the start.
  const Facts& facts() const { return trace.states.front(); }
  const Entity& entity(EntityIndex index) const { return trace.entities[index]; }
  /// Whether it is a slice that is not cut yet; `slice` says which.
  bool is_imagined(EntityIndex index) const { return index != kNobody && index >= first_imagined; }
  const ImaginedSlice& slice(EntityIndex index) const { return imagined[index.index() - first_imagined.index()]; }

 private:
  friend Situation look_around(const ExecutionTree& executions, Mode mode);
  explicit Situation(const ExecutionTree& executions) : executions_(&executions) {}
  const ExecutionTree* executions_;
  struct Known {
    std::optional<double> walked_m;
    std::optional<const Node*> node;
    std::optional<EntityIndex> shut_in;
  };
  Known& known(EntityIndex index) const;
  // Of the few that are asked for, among the thousands of a large home.
  mutable std::deque<Known> known_;
  mutable std::vector<std::uint32_t> known_at_;  // by entity, from 1; 0 for none
};

/// The start for one who plans with the actions of a mode. The tree must outlive the situation.
Situation look_around(const ExecutionTree& executions, Mode mode);

/// True when the formula has one of the operators, at any depth.
bool has_operator(const Formula& formula, std::initializer_list<Formula::Op> operators);

}  // namespace unietp
