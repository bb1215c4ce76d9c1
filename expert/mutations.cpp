#include <algorithm>
#include <iterator>
#include <span>

#include "core/keep_least.h"
#include "expert/execution.h"
#include "expert/expert.h"
#include "expert/rollout.h"
#include "expert/situation.h"
#include "expert/tidying.h"
#include "logic/evaluate.h"

namespace unietp {
namespace {

constexpr std::size_t kMostDistractors = 8;  // for one referent

bool manipulates(const Action& action) {
  const ActionClass group = info(action.type).group;
  return group == ActionClass::Manipulation || group == ActionClass::Composite;
}

/// What is done with the thing in the hand, which stays there.
bool uses_the_held(ActionType type) {
  using enum ActionType;
  return type == Slice || type == PourTo || type == Wipe || type == SpreadTo ||
         info(type).group == ActionClass::Composite;
}

/// From walking up to something to the hands being as they were, or having done their work: the parts whose order a
/// goal may fix.
struct Block {
  std::size_t begin = 0, end = 0;
};

std::vector<Block> blocks_of(const std::vector<Action>& actions) {
  std::vector<Block> blocks;
  std::size_t begin = 0;
  int in_hand = 0;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const ActionType type = actions[i].type;
    if (type == ActionType::PickUp) ++in_hand;
    if (type == ActionType::PlaceOn || type == ActionType::PlaceIn || type == ActionType::Drop) --in_hand;
    const bool changes_state = manipulates(actions[i]) && type != ActionType::PickUp;
    if (in_hand <= 0 ? changes_state : uses_the_held(type)) {
      blocks.push_back({begin, i + 1});
      begin = i + 1;
    }
  }
  return blocks;
}

class Mutator {
 public:
  Mutator(ExecutionTree& executions, Mode mode)
      : start_(executions, rules_of(mode)), world_(executions.world()), goal_(executions.goal()) {}

  bool survives(const std::vector<Action>& actions) const {
    Rollout rollout = start_;
    rollout.go_on(actions);
    return rollout.reaches_goal();
  }

  /// Each step but those of a search, which nobody needs who knows what it shows, and those that only tidy up.
  void drop_each(const Demonstration& demonstration, const std::vector<Action>& actions,
                 std::vector<std::string>& surviving) const {
    Rollout here = start_;
    for (std::size_t i = 0; i < actions.size(); ++i) {
      const DemonstrationStep& step = demonstration.steps[i];
      if (step.action.type != ActionType::Stop && !step.search && !step.tidying) {
        Rollout without = here;
        without.go_on(std::span(actions).subspan(i + 1));
        if (without.reaches_goal()) {
          surviving.push_back("without step " + std::to_string(i + 1) + ": " + to_text(actions[i]));
        }
      }
      (void)here.go_on(actions[i]);
    }
  }

  void leave_in_hand(const std::vector<Action>& actions, std::vector<std::string>& surviving) const {
    for (const LeftInHand& mutant : left_in_hand(actions)) {
      if (survives(mutant.actions)) surviving.push_back("with " + mutant.thing + " left in the hand");
    }
  }

  /// Only some orders need matter (two mugs before a plate: the mugs may swap), but not none.
  void swap_neighbors(const std::vector<Action>& actions, std::vector<std::string>& surviving) const {
    if (!has_operator(goal_, {Formula::Op::Before, Formula::Op::Until})) return;
    const std::vector<Block> blocks = blocks_of(actions);
    std::vector<std::string> swapped;
    for (std::size_t b = 0; b + 1 < blocks.size(); ++b) {
      std::vector<Action> mutant = actions;
      const auto at = [&mutant](std::size_t i) { return mutant.begin() + static_cast<std::ptrdiff_t>(i); };
      std::rotate(at(blocks[b].begin), at(blocks[b].end), at(blocks[b + 1].end));
      if (!survives(mutant)) return;
      swapped.push_back("with " + to_text(actions[blocks[b].end - 1]) + " after " +
                        to_text(actions[blocks[b + 1].end - 1]));
    }
    surviving.insert(surviving.end(), swapped.begin(), swapped.end());
  }

  /// Each referent of a referring domain replaced by the nearest few things of its categories that the domain excludes.
  /// What lies farther away differs from those in the way to it alone, which no goal asks for.
  void use_distractors(const Formula& formula, const Trace& trace, const std::vector<Action>& actions,
                       std::vector<std::string>& surviving) const {
    for (const Formula& child : formula.children) use_distractors(child, trace, actions, surviving);
    if (formula.domain.where.empty()) return;
    auto outer = free_variables(formula.domain.where.front());
    std::erase(outer, formula.variable);
    if (!outer.empty()) return;
    const auto referents = members_of(formula.domain, formula.variable, trace);
    Domain whole = formula.domain;
    whole.where.clear();
    auto excluded = members_of(whole, formula.variable, trace);
    std::erase_if(excluded, [&](EntityIndex other) {
      return std::find(referents.begin(), referents.end(), other) != referents.end();
    });
    for (const EntityIndex referent : referents) {
      const std::string& intended = trace.entities[referent].id;
      for (const EntityIndex other : nearest(intended, excluded, trace))
        replace(intended, trace.entities[other].id, actions, surviving);
    }
  }

 private:
  std::vector<EntityIndex> nearest(const std::string& to, std::vector<EntityIndex> things, const Trace& trace) const {
    const Node* middle = world_.find(to);
    const auto away = [&](EntityIndex thing) {
      const Node* node = world_.find(trace.entities[thing].id);
      return node == nullptr || middle == nullptr ? 0.0 : (node->pose.position - middle->pose.position).norm();
    };
    keep_least(things, kMostDistractors, away);
    return things;
  }

  void replace(const std::string& from, const std::string& to, const std::vector<Action>& actions,
               std::vector<std::string>& surviving) const {
    std::vector<Action> mutant = actions;
    bool used = false;
    for (Action& action : mutant) {
      for (std::string& argument : action.args) {
        if (argument != from) continue;
        argument = to;
        used = used || manipulates(action);
      }
    }
    if (used && survives(mutant)) surviving.push_back("with " + to + " instead of " + from);
  }

  Rollout start_;
  const World& world_;  // at the start
  const Formula& goal_;
};

}  // namespace

std::vector<std::string> needless_steps(ExecutionTree& executions, const Demonstration& demonstration) {
  std::vector<Action> actions;
  for (const DemonstrationStep& step : demonstration.steps) actions.push_back(step.action);
  const Mutator mutator(executions, demonstration.mode);
  std::vector<std::string> surviving;
  mutator.drop_each(demonstration, actions, surviving);
  actions = actions_for_the_goal(demonstration);
  mutator.leave_in_hand(actions, surviving);
  mutator.swap_neighbors(actions, surviving);
  const Trace start{executions.entities(), {executions.facts(executions.world())}};
  mutator.use_distractors(executions.goal(), start, actions, surviving);
  return surviving;
}

std::vector<std::string> needless_steps(const Formula& goal, const Scene& start, const Demonstration& demonstration,
                                        const Knowledge& knowledge, const Profile& profile) {
  auto executions = ExecutionTree::of(goal, start, knowledge, profile);
  if (!executions) return {"the start cannot be replayed: " + format(executions.error())};
  return needless_steps(*executions, demonstration);
}

}  // namespace unietp
