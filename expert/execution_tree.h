#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "akb/knowledge.h"
#include "logic/formula.h"
#include "scene/action.h"
#include "scene/comparisons.h"
#include "scene/trace.h"
#include "simulation/known_start.h"
#include "simulation/profile.h"
#include "simulation/world.h"

namespace unietp {

/// A goal and the world in which it is to be reached, with all that was tried from its start: worlds remember steps,
/// and this remembers what the logic sees at each moment. What one function has executed costs the next one nothing.
class ExecutionTree {
 public:
  /// The goal, the start, the knowledge and the profile must outlive it. Errors: as World::create.
  static Result<ExecutionTree> of(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                  const Profile& profile);
  /// The same for a start of which something is known already.
  static Result<ExecutionTree> of(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                  const Profile& profile, KnownStart known);

  /// The same tree for another goal, which must outlive it and compare nothing that this goal does not compare. What
  /// was executed so far costs it nothing.
  ExecutionTree with_goal(const Formula& goal) const;

  /// What it was made of.
  const Formula& goal() const { return *goal_; }
  const Scene& start() const { return *start_; }
  const Knowledge& knowledge() const { return *knowledge_; }
  const Profile& profile() const { return *profile_; }
  const World& world() const { return world_; }  // at the start
  /// Of the start's nodes.
  const NodeIndex& places() const { return places_; }
  /// The things of the start and, where that grew out of a home, those of the home that are gone.
  const EntityList& entities_at_start() const { return at_start_; }

  /// All things that were there in any branch, those at the start first.
  const EntityList& entities() const { return reader_.entities(); }
  /// nullopt for what was in no world so far.
  std::optional<EntityIndex> find(std::string_view id) const { return reader_.find(id); }

  /// Does the action in a world that goes back to this start by steps of this tree.
  ActionResult step(World& world, const Action& action);
  /// Takes in a world that came from the moment `before` by one step, whoever did it.
  void read(MomentId before, const World& world);
  /// What the logic sees in such a world.
  const Facts& facts(const World& world) const { return facts(world.moment()); }
  const Facts& facts(MomentId moment) const { return *facts_[moment.index()]; }

  /// Truth of the goal, by the direct evaluator, on the trace of these moments, of which the first is the start.
  bool reaches_goal(std::vector<MomentId> moments);

 private:
  ExecutionTree(const Formula& goal, const Scene& start, const Knowledge& knowledge, const Profile& profile,
                NodeIndex places, std::optional<ReadScene> read, World world);
  Facts read(const Scene& scene);
  Facts compared(Facts facts, const Scene& scene) const;
  void read(MomentId before, const World& now, const Delta& changes);

  const Formula* goal_;
  const Scene* start_;
  const Knowledge* knowledge_;
  const Profile* profile_;
  NodeIndex places_;
  World world_;
  FactReader reader_;
  EntityList at_start_;
  Compared compared_;
  bool compares_later_;
  std::deque<std::optional<Facts>> facts_;  // by moment
  Trace trace_;                             // the last that was judged, and its moments
  std::vector<MomentId> judged_;
};

}  // namespace unietp
