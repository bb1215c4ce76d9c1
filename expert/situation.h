#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "expert/rehearsal.h"

namespace unietp {

inline constexpr EntityIndex kNobody = std::numeric_limits<EntityIndex>::max();

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
  EntityIndex first_imagined = 0;
  std::vector<ImaginedSlice> imagined;
  std::vector<const Node*> nodes;    // by entity; of an imagined slice its whole's; nullptr for rooms and the agent
  std::vector<EntityIndex> shut_in;  // by entity: the closed container around it, or kNobody
  static constexpr double kFar_m = 100;

  /// From where the agent stands, capped at kFar_m; of an imagined slice its whole's.
  double walk_m(EntityIndex index) const;
  const Facts& facts() const { return trace.states.front(); }
  const Entity& entity(EntityIndex index) const { return trace.entities[index]; }
  bool is_imagined(EntityIndex index) const { return index != kNobody && index >= first_imagined; }
  const ImaginedSlice& slice(EntityIndex index) const { return imagined[index - first_imagined]; }

 private:
  friend Situation look_around(const Rehearsal& rehearsal, Mode mode);
  explicit Situation(const World& at_start) : world_(at_start) {}
  World world_;
  mutable std::vector<std::optional<double>> walked_m_;  // by entity, as far as asked for
};

/// The start for one who plans with the actions of a mode. The rehearsal must outlive the situation.
Situation look_around(const Rehearsal& rehearsal, Mode mode);

/// True when the formula has one of the operators, at any depth.
bool has_operator(const Formula& formula, std::initializer_list<Formula::Op> operators);

}  // namespace unietp
