#include "expert/explorer.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "expert/execution.h"
#include "expert/exploration.h"
#include "expert/rollout.h"

namespace unietp {
namespace {

/// Carries out a plan that names things by ids, looking for each thing first.
class Explorer {
 public:
  /// `looks_left`: as in way_to_see, for all that it looks for.
  Explorer(ExecutionTree& executions, const ModeRules& rules, std::size_t& looks_left)
      : rollout_(executions, rules), looks_left_(&looks_left) {}
  /// From now on it looks around from where it stands, also where it would see a thing sooner from elsewhere.
  void stay() { stays_ = true; }

  bool carry_out(const Action& action) {
    const bool of_object = !action.args.empty() && world().find(action.args.front()) != nullptr;
    if (!of_object) return act(action);
    const std::string& id = action.args.front();
    // Who has come to stand where something works had better look around without leaving.
    const bool stays = stays_ && action.type != ActionType::GoTo;
    if (!can_say(action) && !(stays && look(id, Viewpoint::Here)) && !see(id)) return unseen(id);
    if (act(action)) return true;
    if (action.type == ActionType::GoTo) return false;
    // Perhaps from nearer by: where one is led to, or wherever the arm reaches it and the camera shows it.
    const Action approach{ActionType::GoTo, {id}};
    if ((can_say(approach) || see(id)) && act(approach) && can_say(action) && act(action)) return true;
    return look(id, Viewpoint::InReach) && act(action);
  }

  /// Does what comes before `stop`; true when the goal is reached then, else `trouble` says why not.
  bool follow(std::span<const Action> plan) {
    lost_.clear();
    for (const Action& action : plan.first(plan.size() - 1)) {
      if (carry_out(action)) continue;
      trouble_.text = "for " + to_text(action) + ": " + trouble_.text;
      if (!action.args.empty()) lost_ = action.args.front();
      return false;
    }
    trouble_ = {"done so, it does not reach the goal"};
    return rollout_.reaches_goal();
  }

  const std::vector<Action>& done() const { return rollout_.done(); }
  const Trouble& trouble() const { return trouble_; }
  const std::string& lost() const { return lost_; }  // what was not come to, or could not be used; or ""
  bool over() const { return rollout_.episode().over(); }

 private:
  static constexpr int kMostDetours = 2;

  const World& world() const { return rollout_.episode().world(); }
  bool can_say(const Action& action) const { return clearly_said(rollout_.episode(), action).has_value(); }
  bool unseen(const std::string& id) {
    trouble_ = {id + " cannot be found", Failure::NotSeenYet};
    return false;
  }
  bool act(const Action& action) {
    const Outcome outcome = rollout_.go_on(action);
    if (!outcome.success) trouble_ = {to_text(action) + ": " + outcome.feedback, outcome.failure};
    return outcome.success;
  }
  bool look(const std::string& id, Viewpoint standing = Viewpoint::Anywhere) {
    const auto way = way_to_see(rollout_.episode(), id, standing, looks_left_);
    return way && std::all_of(way->begin(), way->end(), [this](const Action& step) { return act(step); });
  }
  /// Looks from here, from the room, and from furniture; furniture that is not in view itself is looked for first.
  bool see(const std::string& id, int detours = 0) {
    if (look(id)) return true;
    if (detours == kMostDetours) return false;
    const Rollout before = rollout_;
    for (const std::string& lookout : lookouts_for(world(), id)) {
      const Action approach{ActionType::GoTo, {lookout}};
      if (can_say(approach) || !see(lookout, detours + 1) || !act(approach)) continue;
      if (look(id)) return true;
    }
    return detours == 0 && see_from_nearby(id, before);
  }
  /// Where long steps and wide turns lead to few places, each thing nearby that is gone to leads to others. Once for
  /// each thing that is not found so.
  bool see_from_nearby(const std::string& id, const Rollout& before) {
    if (given_up_.contains(id)) return false;
    for (const std::string& other : things_near(world(), id)) {
      rollout_ = before;
      const Action approach{ActionType::GoTo, {other}};
      if ((can_say(approach) || look(other)) && act(approach) && look(id)) return true;
    }
    rollout_ = before;
    given_up_.insert(id);
    return false;
  }

  Rollout rollout_;
  std::size_t* looks_left_;
  bool stays_ = false;
  std::set<std::string> given_up_;
  Trouble trouble_;
  std::string lost_;
};

}  // namespace

std::variant<std::vector<Action>, Trouble> explore(const ModeRules& rules, ExecutionTree& executions,
                                                   std::vector<Action> plan, const ExpertOptions& options) {
  constexpr int kMostReplans = 4;
  // What cannot be seen from anywhere is looked for from each lookout again: hundreds of thousands of poses in a large
  // home. The plans that were found looked from a few thousand.
  std::size_t looks_left = 10'000;
  Explorer explorer(executions, rules, looks_left);
  ExecutedPrefix beginning;
  for (int replans = 0; !explorer.follow(plan); ++replans) {
    const Trouble trouble = explorer.trouble();
    if (replans == kMostReplans) return trouble;
    if (!explorer.lost().empty()) beginning.avoided.push_back(explorer.lost());
    const bool goes_on = replans % 2 == 0 && !explorer.over();
    beginning.clears = replans >= kMostReplans / 2;
    beginning.done = goes_on ? explorer.done() : std::vector<Action>{};
    auto other = find_plan_from(executions, beginning, options);
    if (std::holds_alternative<Rejection>(other) && goes_on) {
      beginning.done.clear();
      other = find_plan_from(executions, beginning, options);
    }
    if (std::holds_alternative<Rejection>(other)) return trouble;
    plan = std::move(std::get<std::vector<Action>>(other));
    if (beginning.done.empty()) explorer = Explorer(executions, rules, looks_left);
    explorer.stay();
  }
  return explorer.done();
}

}  // namespace unietp
