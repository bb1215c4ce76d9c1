#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expert/demonstration.h"
#include "expert/execution_tree.h"
#include "expert/subgoal.h"
#include "generator/rejection.h"
#include "scene/trace.h"
#include "simulation/world.h"

namespace unietp {

/// Id of the object that the joint of a door or lid would hit; "" when the action failed otherwise.
std::string blocker_of(const ActionResult& result);

/// An execution of one alternative in a world of its own: does actions, records those that succeed, watches which
/// moments have come, and takes back an action that would break a truth to keep. What went wrong last is remembered, so
/// that a method can try another tool or place and the expert can choose otherwise next time.
class Attempt {
 public:
  Attempt(ExecutionTree& executions, const Situation& situation, const Alternative& alternative,
          const ExpertOptions& options);

  /// Does the action; false when it failed, would break a truth to keep, or a budget is used up.
  bool act(Action action);
  bool act(ActionType type, const std::string& argument);
  bool act(ActionType type) { return act(Action{type, {}}); }

  /// What it was made with, and what it has come to: the world now, and the actions that succeeded.
  const Situation& situation() const { return *situation_; }
  const Alternative& alternative() const { return *alternative_; }
  const World& world() const { return world_; }
  const std::vector<Action>& actions() const { return actions_; }

  /// Truth of a literal in the world as it is now; of a slice that is not cut yet nothing holds.
  bool holds(const Literal& literal) const;
  /// Whether a moment of the alternative has come, by its position.
  bool has_come(std::size_t moment) const { return come_[moment]; }
  /// Node that an entity stands for by then; nullptr for a slice before the cut, for rooms and the agent.
  const Node* node(EntityIndex entity) const;
  /// Id of an entity of any kind; "" for a slice before the cut.
  std::string id_of(EntityIndex entity) const;
  /// Whether the agent holds the object now.
  bool is_held(std::string_view id) const;

  /// What went wrong last.
  struct Trouble {
    RejectionReason reason = RejectionReason::ActionFailed;
    Action action;
    Failure failure = Failure::None;
    std::string text;
    std::string blocker = "";  // id of the object that a door or lid would hit, or ""
  };
  /// nullopt as long as nothing went wrong.
  const std::optional<Trouble>& trouble() const { return trouble_; }
  /// Number of actions that failed or were taken back.
  int failures() const { return failures_; }
  /// A budget is used up, so that no further action is done.
  bool exhausted() const { return exhausted_; }

 private:
  void give_up(Action action, RejectionReason reason, std::string text);
  bool passes(const Facts& facts);
  bool passes_all();
  bool keeps_hold() const;
  void mark_moments();
  std::optional<EntityIndex> current(EntityIndex entity) const;

  ExecutionTree* executions_;
  const Situation* situation_;
  const Alternative* alternative_;
  ExpertOptions options_;
  World world_;
  Trace trace_;
  std::vector<bool> come_;
  std::vector<Action> actions_;
  std::optional<Trouble> trouble_;
  int failures_ = 0;
  bool exhausted_ = false;
};

}  // namespace unietp
