#include "expert/belief_planner.h"

#include <algorithm>
#include <utility>

#include "expert/execution.h"
#include "expert/search_marks.h"
#include "expert/tidying.h"

namespace unietp {
namespace {

constexpr std::size_t kLongestRun = 3;

}  // namespace

ModeRules BeliefPlanner::rules(int steps_left) const {
  ModeRules rules = rules_of(Mode::M2);
  rules.movables = true;  // all that is believed was seen
  if (points()) rules.teleport = Teleport::Anything;
  rules.limits.steps = steps_left + static_cast<int>(done_.size());
  return rules;
}

/// What is believed of the home as it was when the first plan was made: with what has come into view since, as it is
/// unless the agent itself has changed it.
Scene BeliefPlanner::believed_before(const Belief& belief) const {
  if (done_.empty()) return belief.scene();
  Scene before = *believed_scene_;
  NodeIndex places(before.nodes);
  for (const Node& node : belief.scene().nodes) {
    if (touched_.contains(node.id)) continue;
    if (const auto place = places.find(node.id)) {
      if (before.nodes[*place] != node) before.nodes.edit(*place) = node;
    } else if (node.slice_of.empty()) {
      before.nodes.push_back(node);
    }
  }
  return before;
}

/// Does again what was done; where the agent pointed at things, a look that leads elsewhere now does not matter.
bool BeliefPlanner::replay(Rollout& again) {
  for (const Action& action : done_) {
    if (!again.go_on(action).success && !(points() && may_be_search(action.type))) return false;
  }
  return true;
}

bool BeliefPlanner::make(const Belief& belief, KnownHome& home, int steps_left, const std::vector<std::string>& opened,
                         bool anew) {
  auto scene = std::make_unique<Scene>(believed_before(belief));
  KnownStart known = home.of(*scene);
  auto made = ExecutionTree::of(problem_.goal, *scene, problem_.knowledge, problem_.profile, std::move(known));
  if (!made) return false;
  auto tree = std::make_unique<ExecutionTree>(std::move(*made));
  const ModeRules rules = this->rules(steps_left);
  Rollout again(*tree, rules);
  unfit_ = !replay(again);
  if (unfit_) {
    trouble_ = {"what was done does not fit what was seen"};
    return false;
  }
  const std::vector<Action> done = again.done();
  std::optional<std::vector<Action>> plan = done_.empty() || anew ? std::nullopt : the_rest(again);
  if (!plan) plan = another_plan(*tree, rules, done, opened);
  if (!plan) return false;
  if (plan->size() == 1 && done_.empty()) {
    trouble_ = {"all that was seen is as it should be", Failure::NotSeenYet};
    return false;  // there must be something to do: it was not seen yet
  }
  plan_ = std::move(*plan);
  next_ = 0;
  foreseen_ = std::make_unique<World>(again.episode().world());
  believed_ = std::move(tree);
  believed_scene_ = std::move(scene);
  return true;
}

/// What is left of the plan, if it reaches the goal.
std::optional<std::vector<Action>> BeliefPlanner::the_rest(Rollout rollout) const {
  const auto left = rest();
  if (left.empty()) return std::nullopt;
  const std::size_t before = rollout.done().size();
  rollout.go_on(left);
  if (rollout.done().size() != before + left.size() || !rollout.reaches_goal()) return std::nullopt;
  return std::vector(left.begin(), left.end());
}

std::optional<std::vector<Action>> BeliefPlanner::another_plan(ExecutionTree& tree, const ModeRules& rules,
                                                               const std::vector<Action>& done,
                                                               const std::vector<std::string>& opened) {
  const ExpertOptions options{.max_steps = rules.limits.steps, .mode = problem_.mode};
  auto found = find_cheapest_plan_from(tree, {done, avoided_, false}, options);
  if (auto* why = std::get_if<Rejection>(&found)) {
    trouble_ = {std::string(name_of(why->reason)) + ": " + why->detail, why->failure};
    return std::nullopt;
  }
  std::vector<Action> whole = done;
  const auto& rest = std::get<std::vector<Action>>(found);
  whole.insert(whole.end(), rest.begin(), rest.end());
  auto explored = explore(rules, tree, std::move(whole), options);
  if (auto* why = std::get_if<Trouble>(&explored)) {
    trouble_ = std::move(*why);
    return std::nullopt;
  }
  auto& all = std::get<std::vector<Action>>(explored);
  all.push_back({ActionType::Stop, {}});
  if (all.size() <= done.size() || !std::equal(done.begin(), done.end(), all.begin())) {
    trouble_ = {"what was done does not fit what was seen"};
    return std::nullopt;
  }
  const auto plan = without_needless(tree, rules, std::move(all), kLongestRun, done.size());
  if (!plan) return std::nullopt;
  const auto careful = tidied(tree, rules, *plan, done.size(), opened);
  return std::vector(careful.begin() + static_cast<std::ptrdiff_t>(done.size()), careful.end());
}

void BeliefPlanner::did(const Action& action, const Delta& changes) {
  done_.push_back(action);
  for (const Node& node : changes.nodes) touched_.insert(node.id);
}

}  // namespace unietp
