#pragma once

#include <cstddef>
#include <vector>

#include "core/rng.h"
#include "generator/start_demands.h"
#include "generator/symbolic_start.h"
#include "symbolic/goal.h"

namespace unietp {

inline constexpr double kHomeLength_m = 20;  // along which furniture stands, for `nearest`

/// A start under way: objects are there, and are changed until all of `init` holds.
class StartDraft {
 public:
  StartDraft(const StartDemands& demands, Rng& rng);

  /// Changes one object for one broken constraint. False when nothing is broken any more, or nothing can be done.
  bool improve();
  /// Whether all of `init` holds.
  bool sound() const { return broken_.empty(); }
  /// The start as it is; only when it is sound.
  SymbolicStart finished() &&;

 private:
  using Id = symbolic::Id;
  const symbolic::Setting& setting() const { return start_.setting; }
  symbolic::World& world() { return start_.world; }

  void add_things();
  void draw_states(Id thing);
  void read_constraints();
  void read_attributes();  // anew in the constraints, where one has changed
  void find_broken();
  void move_anywhere(Id thing);
  bool can_be_put(Id thing, Predicate relation, Id place) const;
  void put(Id thing, symbolic::PlaceKind where, Id at);
  Id random_room();
  std::vector<Id> things_of(const Domain& domain) const;
  std::vector<Id> rooms_of(const Domain& domain) const;
  bool is_true(const StartLiteral& literal, Id thing) const;
  bool satisfies(const StartDemands::Aim& aim, Id thing) const;
  void perturb(const StartDemands::Aim& aim);
  void change(const StartDemands::Aim& aim);
  void make(const StartLiteral& literal, Id thing, bool truth);
  void make_state(const StartLiteral& literal, Id thing, bool truth);
  void make_relation(const StartLiteral& literal, Id thing);
  bool set_attribute(const StartLiteral& literal, Id thing);

  const StartDemands& demands_;
  Rng& rng_;
  SymbolicStart start_;
  std::vector<symbolic::Goal> constraints_;  // one for each aim, over the things that are there
  std::vector<std::size_t> broken_;          // positions in aims
  bool attributes_changed_ = false;          // they are fixed where a constraint is read
};

}  // namespace unietp
