#include "expert/mode_expert.h"

#include <algorithm>

#include "expert/execution.h"
#include "expert/exploration.h"
#include "expert/mode_run.h"
#include "simulation/mode_episode.h"

namespace unietp {
namespace {

/// Carries out a plan that names things by ids, looking for each thing first.
class Explorer {
 public:
  Explorer(const World& start, Mode mode) : episode_(start, mode) {}

  bool carry_out(const Action& action) {
    const bool of_object = !action.args.empty() && find_node(episode_.world().scene(), action.args.front()) != nullptr;
    if (!of_object) return act(action);
    const std::string& id = action.args.front();
    if (!can_say(action) && !see(id)) return unseen(id);
    if (act(action)) return true;
    if (action.type == ActionType::GoTo) return false;
    // Perhaps from nearer by: where one is led to, or wherever the arm reaches it and the camera shows it.
    const Action approach{ActionType::GoTo, {id}};
    if ((can_say(approach) || see(id)) && act(approach) && can_say(action) && act(action)) return true;
    return look(id, true) && act(action);
  }

  const std::vector<Action>& done() const { return done_; }
  const std::string& trouble() const { return trouble_; }

 private:
  static constexpr int kMostDetours = 2;

  bool can_say(const Action& action) const { return clearly_said(episode_, action).has_value(); }
  bool unseen(const std::string& id) {
    trouble_ = id + " cannot be found";
    return false;
  }
  bool act(const Action& action) {
    const Outcome outcome = do_in(episode_, action);
    if (outcome.success) {
      done_.push_back(action);
    } else {
      trouble_ = to_text(action) + ": " + outcome.feedback;
    }
    return outcome.success;
  }
  bool look(const std::string& id, bool in_reach = false) {
    const auto way = way_to_see(episode_, id, in_reach);
    return way && std::all_of(way->begin(), way->end(), [this](const Action& step) { return act(step); });
  }
  /// Looks from here, from the room, and from furniture; furniture that is not in view itself is looked for first.
  bool see(const std::string& id, int detours = 0) {
    if (look(id)) return true;
    if (detours == kMostDetours) return false;
    for (const std::string& lookout : lookouts_for(episode_.world().scene(), id)) {
      const Action approach{ActionType::GoTo, {lookout}};
      if (can_say(approach) || !see(lookout, detours + 1) || !act(approach)) continue;
      if (look(id)) return true;
    }
    return false;
  }

  ModeEpisode episode_;
  std::vector<Action> done_;
  std::string trouble_;
};

std::optional<std::vector<Action>> plan_of(const Demonstration& shown, Mode mode) {
  std::vector<Action> plan;
  for (const DemonstrationStep& step : shown.steps) {
    if (!offers(info(step.action.type), mode)) return std::nullopt;
    plan.push_back(step.action);
  }
  return plan;
}

}  // namespace

std::variant<Demonstration, Rejection> demonstrate_in(Mode mode, const Formula& goal, const Scene& start,
                                                      const Knowledge& knowledge, const Profile& profile,
                                                      const Demonstration& shown) {
  const auto rejected = [mode](const std::string& why) {
    return Rejection{"expert", mode == Mode::M2 ? "not-in-m2" : "not-in-m3", why};
  };
  Profile own = profile;
  for (const ActionInfo& action : all_actions()) {
    if (!offers(action, mode)) own.actions[static_cast<std::size_t>(action.type)] = false;
  }
  const StepLimits limits = limits_of(mode);
  auto plan = plan_of(shown, mode);
  if (!plan) {
    auto atomic = demonstrate(goal, start, knowledge, own, {limits.steps, limits.failures});
    if (const auto* why = std::get_if<Rejection>(&atomic)) return rejected(why->reason + ": " + why->detail);
    plan = plan_of(std::get<Demonstration>(atomic), mode);
  }
  const auto world = World::create(start, knowledge, own);
  if (!world || !plan) return rejected("the start cannot be rebuilt");

  Explorer explorer(*world, mode);
  for (const Action& action : *plan) {
    if (!explorer.carry_out(action)) return rejected("for " + to_text(action) + ": " + explorer.trouble());
  }
  const ModeEpisode fresh(*world, mode);
  const auto actions = shortened(goal, start, fresh, explorer.done());
  if (!actions) return rejected("done so, it does not reach the goal");
  if (static_cast<int>(actions->size()) > limits.steps)
    return rejected("needs " + std::to_string(actions->size()) + " steps");
  return record_in(fresh, *actions);
}

}  // namespace unietp
