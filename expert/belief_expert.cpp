#include "expert/belief_expert.h"

#include <algorithm>
#include <set>
#include <utility>

#include "expert/belief.h"
#include "expert/belief_planner.h"
#include "expert/exploration.h"
#include "expert/known_world.h"
#include "expert/recognition.h"
#include "expert/search_order.h"
#include "expert/search_targets.h"
#include "expert/search_tools.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

// Of the limit of the mode: of steps spent on that before something is done, and of all when more is looked for at the
// end.
constexpr double kThorough = 0.4, kChecking = 0.6;
constexpr int kStepsForTheRest = 4;         // at least, after what is needed was found
constexpr int kStepsToBeTidy = 25;          // left, else nothing is closed while something that is needed is looked for
constexpr std::size_t kMostGlances = 4000;  // that are thought of to bring one thing into the picture
constexpr int kMostApproaches = 4, kMostReplans = 3;  // when a thing cannot be brought into it

/// Looks, plans and acts behind a window.
class BeliefExpert {
 public:
  BeliefExpert(const SearchProblem& problem, Window& window)
      : problem_(problem),
        window_(window, problem.mode),
        needs_(search_needs(problem.goal)),
        profile_(profile_in(problem.mode, problem.profile)),
        belief_(window.known_scene(), needs_, categories_of_use(problem.goal, needs_, problem.knowledge, profile_)),
        order_(window.known_scene(), problem.knowledge, problem.usual, needs_.shut, profile_),
        targets_(problem, needs_, profile_, belief_, order_),
        known_world_(problem.knowledge, problem.profile, window_),
        planner_(problem) {}

  std::optional<Trouble> run() {
    see();
    while (!gave_up_) {
      if (!planner_.rest().empty()) {
        if (follow()) return std::nullopt;
      } else if (!may_plan() || !make_plan()) {
        search();
      }
    }
    return trouble_;
  }

 private:
  /// M3: objects are named by pointing at them in the picture.
  bool points() const { return problem_.mode == Mode::M3; }
  int most_steps() const { return rules_of(problem_.mode).limits.steps; }
  int steps_left() const { return most_steps() - steps_; }
  void give_up(std::string why, Failure failure = Failure::NotSeenYet) {
    trouble_ = {std::move(why), failure};
    gave_up_ = true;
  }

  void see() {
    const std::vector<Node> view = window_.view();
    belief_.see(view, window_.body());
    for (const Node& node : view) order_.glimpsed(node, window_.known_scene());
    order_.stood(window_.body());
    if (!points()) return;
    in_picture_.clear();
    for (const Node& node : view) in_picture_.insert(node.id);
    for (const std::string& id : window_.body().held) in_picture_.erase(id);
    if (belief_.differed() || !known_world_.is_at(window_.body())) known_world_.believe(belief_.scene());
  }

  /// False when it could not be done.
  bool act(const Action& action) {
    const Outcome outcome = window_.act(action);
    if (!outcome.success) {
      trouble_ = {to_text(action) + ": " + outcome.feedback, outcome.failure};
      return false;
    }
    ++steps_;
    if (!points() || !acted_) known_world_.follow(action);
    if (acted_) foresee(action);
    window_.look();
    see();
    return true;
  }

  /// Of what the goal speaks of all of, where there may well be more and steps are left for that.
  std::vector<SearchTarget> overlooked(double most) const {
    return steps_ >= most * most_steps() ? std::vector<SearchTarget>{} : targets_.overlooked();
  }

  bool may_plan() {
    const bool news = planned_at_ != belief_.news();  // since it did not work
    return acted_ ? news : found_enough();
  }

  bool make_plan(bool anew = false) {
    planned_at_ = belief_.news();
    if (planner_.make(belief_, known_world_.home(), steps_left(), opened_, anew)) return true;
    trouble_ = planner_.trouble();
    return false;
  }

  /// One step of the plan; true when it was the last.
  bool follow() {
    if (concerns_plan()) {
      if (!make_plan() && !planner_.unfit()) planner_.drop();
      return false;
    }
    if (std::exchange(strayed_, false) && !points()) (void)make_plan();  // else on with what was planned elsewhere
    Action action = planner_.rest().front();
    if (action.type == ActionType::Stop && (look_for_more() || close_after_search())) return false;
    empty_.clear();  // the plan closes what was opened
    const bool looks_first = acts_on_presumed(action);
    if (looks_first) action = {ActionType::TurnTo, action.args};
    if (action.type == ActionType::Stop) {
      const Outcome end = window_.act(action);
      if (!end.success) give_up("for stop(): " + end.feedback, end.failure);
      return end.success;
    }
    if (points()) {
      acted_ = true;
      if (!come_to(action)) return closes_only_ ? planner_.only_stop() : plan_without(action), false;
    }
    if (!looks_first) planner_.advance();
    if (action.type == ActionType::TurnTo) looked_for_.insert(action.args.front());
    acted_ = act_as_planned(action);
    if (!acted_) give_up("for " + to_text(action) + ": " + trouble_.text, trouble_.failure);
    return false;
  }

  /// Plans anew, without what it cannot come to.
  void plan_without(const Action& action) {
    if (gave_up_) return;
    const std::string why = "for " + to_text(action) + ": " + trouble_.text;
    if (!action.args.empty()) planner_.avoid(action.args.front());
    if (++replans_ > kMostReplans || !make_plan(true)) give_up(why, trouble_.failure);
  }

  bool names_object(const Action& action) const {
    return !action.args.empty() && find_room(window_.known_scene(), action.args.front()) == nullptr;
  }
  bool can_say(const Action& action) const {
    return !names_object(action) || in_picture_.contains(action.args.front());
  }

  /// Brings the object of an action into the picture, from where the action works as far as is known. False when it
  /// does not know how, or something failed.
  bool come_to(const Action& action) {
    if (!names_object(action)) return known_world_.allows(action);
    std::size_t looks_left = kMostGlances;
    for (int tries = 0; tries < kMostApproaches; ++tries) {
      if (can_say(action) && known_world_.allows(action)) return true;
      const auto way = way_to(action, tries, looks_left);
      if (!way) break;
      for (const Action& step : *way) {
        if (!can_say(step)) break;  // something that it did not know of hides it
        if (!step_toward(step)) return false;
        if (strayed_ || (can_say(action) && known_world_.allows(action))) break;
      }
      strayed_ = false;
    }
    if (can_say(action) && known_world_.allows(action)) return true;
    trouble_ = {action.args.front() + " cannot be seen from where that works", Failure::NotSeenYet};
    return false;
  }

  std::optional<std::vector<Action>> way_to(const Action& action, int tries, std::size_t& looks_left) {
    const World* world = known_world_.world();
    if (world == nullptr) return std::nullopt;
    const std::string& id = action.args.front();
    const ModeEpisode episode(*world, problem_.mode);
    const Action approach{ActionType::GoTo, {id}};
    if (action.type == ActionType::GoTo) return way_to_see(episode, id, Viewpoint::Anywhere, &looks_left);
    if (tries == 0 && world->in_reach(id)) {
      if (auto way = way_to_see(episode, id, Viewpoint::Here, &looks_left)) return way;
    }
    if (tries <= 1) {
      if (can_say(approach)) return std::vector{approach};
      if (auto way = way_to_see(episode, id, Viewpoint::Anywhere, &looks_left)) {
        way->push_back(approach);
        return way;
      }
    }
    return way_to_see(episode, id, Viewpoint::InReach, &looks_left);
  }

  /// A step on the way to something; it may lead elsewhere than foreseen.
  bool step_toward(const Action& step) {
    if (acted_) {
      if (!act_as_planned(step)) give_up("to see more: " + trouble_.text, trouble_.failure);
      return !gave_up_;
    }
    if (!act(step)) return give_up("in search: " + trouble_.text, trouble_.failure), false;
    note_place(step);
    return true;
  }

  /// Whether it switches or moves a door of furniture whose state nobody has seen yet: that is looked at first.
  bool acts_on_presumed(const Action& action) {
    const bool depends = action.type == ActionType::TurnOn || action.type == ActionType::TurnOff ||
                         action.type == ActionType::Open || action.type == ActionType::Close;
    if (!depends || action.args.empty() || looked_for_.contains(action.args.front()) ||
        belief_.has_seen(action.args.front()))
      return false;
    const World* here = foreseen();
    if (here == nullptr) return false;
    World trial = *here;
    return trial.step({ActionType::TurnTo, action.args}).success;
  }

  /// The home as it should be after all that was done, the agent where that led; nullptr where it cannot be built. The
  /// planner's copy stands still in M3, where the way to each step is found here.
  World* foreseen() { return points() ? known_world_.world() : planner_.foreseen(); }

  /// All is done that was seen to be needed. One look more where there may well be more of what the goal speaks of all
  /// of; false when that is not worth it.
  bool look_for_more() {
    const auto targets = overlooked(kChecking);
    const auto look = targets.empty() || steps_left() <= kStepsForTheRest ? std::nullopt : next_look(targets);
    if (!look) return false;
    const int before = belief_.news();
    checks_ = true;
    if (!look_there(*look)) give_up("in search: " + trouble_.text, trouble_.failure);
    checks_ = false;
    left_open_ = stands_open();
    surprised_ = surprised_ || belief_.news() != before;
    return true;
  }

  /// Whether anything that was opened for a look is open.
  bool stands_open() const {
    return std::any_of(opened_.begin(), opened_.end(),
                       [this](const std::string& id) { return belief_.find(id)->states.has(Predicate::Open); });
  }

  /// Closes what the last looks opened, of which the plan knew nothing, or plans to; false where nothing is to be
  /// closed or it is not possible.
  bool close_after_search() {
    if (!std::exchange(left_open_, false)) return false;
    checks_ = true;
    if (!close_behind({})) give_up("in search: " + trouble_.text, trouble_.failure);
    checks_ = false;
    if (gave_up_ || !stands_open()) return true;
    closes_only_ = make_plan(true) && planner_.rest().size() > 1;
    return closes_only_;
  }

  /// Takes in what an action must have changed.
  void foresee(const Action& action) {
    World* const home = foreseen();
    if (home == nullptr) return;
    (void)home->step(action);
    planner_.did(action, home->changes());
    belief_.foresee(home->changes());
    window_.expect(home->changes());
  }

  /// Where it stands after a step.
  void note_place(const Action& action) {
    if (action.type == ActionType::GoTo) {
      at_ = action.args.front();
      order_.arrived(at_, window_.body().position);
    }
    if (info(action.type).group == ActionClass::Movement && action.args.empty()) at_.clear();
  }

  bool act_as_planned(const Action& action) {
    const Outcome outcome = window_.act(action);
    if (!outcome.success) {
      trouble_ = {outcome.feedback, outcome.failure};
      return false;
    }
    ++steps_;
    foresee(action);
    window_.look();
    note_place(action);
    const int before = belief_.news();
    const World* home = foreseen();
    const Vec2 expected = home == nullptr ? window_.body().position : home->agent().position;
    see();
    surprised_ = surprised_ || belief_.news() != before || in_the_way();
    strayed_ = (expected - window_.body().position).norm() > kStray_m;
    return true;
  }

  /// Something came into view where the plan puts something down.
  bool in_the_way() const {
    for (const Action& action : planner_.rest()) {
      if (action.type != ActionType::PlaceOn && action.type != ActionType::PlaceIn) continue;
      const Node* target = belief_.find(action.args.front());
      if (target == nullptr) continue;
      const Bounds there = bounds_of(target->pose, target->size);
      const auto is_there = [&](const std::string& id) {
        const Node& node = *belief_.find(id);
        return id != target->id && node.movable && !holds(window_.body().held, id) &&
               overlap(there, bounds_of(node.pose, node.size), kTouch_m);
      };
      if (std::any_of(belief_.moved().begin(), belief_.moved().end(), is_there)) return true;
    }
    return false;
  }

  /// News that the plan was not made for: of what the goal speaks of all of, of what the plan goes to, or of what is in
  /// its way.
  bool concerns_plan() {
    if (!std::exchange(surprised_, false)) return false;
    if (in_the_way()) return true;
    const Node* news = belief_.find(belief_.last_news());
    if (news == nullptr) return false;
    for (const SearchNeed& need : needs_.needs) {
      if (need.every && holds(need.categories, news->category)) return true;
    }
    const auto uses = [&](const Action& action) { return !action.args.empty() && action.args.front() == news->id; };
    return std::any_of(planner_.rest().begin(), planner_.rest().end(), uses);
  }

  /// Enough is known to try a plan that was not tried yet.
  bool found_enough() const {
    return planned_at_ != belief_.news() && targets_.missing().empty() && overlooked(kThorough).empty();
  }

  bool would_work(const SearchOrder::Look& look) {
    switch (known_world_.obstacle_to(look, order_.way_to(look, at_))) {
      case KnownWorld::Obstacle::None:
        return true;
      case KnownWorld::Obstacle::NoWay:
        order_.give_up(look.id);
        return false;
      case KnownWorld::Obstacle::Shut:
        order_.keep_shut(look.id);
        return false;
      case KnownWorld::Obstacle::NoView:
        order_.looked_at(look.id, belief_);
        return false;
    }
    return false;
  }
  /// Whether it was seen to be on and cannot be opened before it is off.
  bool runs(const std::string& id) const {
    return problem_.profile.open_needs_power_off && belief_.find(id)->states.has(Predicate::PowerOn);
  }

  /// The most promising look that would work, as far as is known.
  std::optional<SearchOrder::Look> next_look(const std::vector<SearchTarget>& targets) {
    const auto in_reach = [this](const std::string& id) {
      return (!points() || in_picture_.contains(id)) && known_world_.opens_from_here(id);
    };
    auto look = order_.next(targets, belief_, at_, in_reach);
    while (look && !would_work(*look)) look = order_.next(targets, belief_, at_, in_reach);
    return look;
  }

  /// One look where something needed may be.
  void search() {
    if (steps_left() <= kStepsForTheRest)
      return give_up("too long a search for " + names_of(targets_.missing()) + "; " + trouble_.text);
    auto targets = targets_.missing();
    if (targets.empty()) targets = overlooked(kThorough);
    if (targets.empty()) targets = targets_.all();
    const auto look = next_look(targets);
    if (!look) return give_up("nowhere left to look for " + names_of(targets) + "; " + trouble_.text);
    if (!look_there(*look)) give_up("in search: " + trouble_.text, trouble_.failure);
  }

  /// Closes what was opened last if it showed nothing of use and is not what comes next; false when that failed.
  bool close_behind(const std::string& next) {
    if (empty_.empty() || empty_ == next) return true;
    const Action close{ActionType::Close, {std::exchange(empty_, {})}};
    if (steps_left() <= (checks_ ? kStepsForTheRest : kStepsToBeTidy)) return true;
    if (points() ? !come_to(close) : !known_world_.allows(close)) return !gave_up_;
    if (!act(close)) return false;
    std::erase(opened_, close.args.front());
    return true;
  }

  /// False when something failed.
  bool look_there(const SearchOrder::Look& look) {
    if (!close_behind(look.id)) return false;
    const auto way = order_.way_to(look, at_);
    for (const Action& action : way) {
      if (points() && !come_to(action)) {
        order_.give_up(look.id);
        return !gave_up_;
      }
      if (!known_world_.allows(action)) break;
      if (!act(action)) return false;
      if (points()) note_place(action);
      if (!points() && action.type == ActionType::GoTo) at_ = action.args.front();
      if (found_enough()) break;
    }
    const bool opens = look.opens && (way.empty() || look.before > 0 || !found_enough());
    if (opens && !belief_.find(look.id)->states.has(Predicate::Open)) {
      const Action open{ActionType::Open, {look.id}}, stop{ActionType::TurnOff, {look.id}};
      if (points() && !come_to(runs(look.id) ? stop : open)) {
        order_.keep_shut(look.id);
        return !gave_up_;
      }
      if (runs(look.id) && !act(stop)) return false;
      const int before = belief_.news();
      if (!act(open)) return false;
      opened_.push_back(look.id);
      if (belief_.news() == before) empty_ = look.id;
    }
    look.from_here ? order_.peeked_into(look.id) : order_.looked_at(look.id, belief_);
    return true;
  }

  const SearchProblem& problem_;
  Recognition window_;
  SearchNeeds needs_;
  Profile profile_;
  Belief belief_;
  SearchOrder order_;
  SearchTargets targets_;
  KnownWorld known_world_;
  BeliefPlanner planner_;
  int planned_at_ = -1;                            // the news when a plan was made, or could not be made
  int replans_ = 0;                                // for want of a view
  std::set<std::string, std::less<>> in_picture_;  // M3: what can be pointed at
  std::set<std::string, std::less<>> looked_for_;  // furniture that was turned to before it was used

  std::string at_;                   // the place that it looked at last
  std::vector<std::string> opened_;  // for a look, and not closed since
  std::string empty_;                // of these the last, if it showed nothing of use
  int steps_ = 0;
  bool acted_ = false, gave_up_ = false;
  bool surprised_ = false, strayed_ = false;  // by the last step: something came into view; it led elsewhere
  bool checks_ = false;                       // whether there is more, when all is done
  bool left_open_ = false;                    // by such looks
  bool closes_only_ = false;                  // what is left of the plan, after those
  Trouble trouble_;
};

}  // namespace

std::optional<Trouble> reach_by_belief(const SearchProblem& problem, Window& window) {
  return BeliefExpert(problem, window).run();
}

}  // namespace unietp
