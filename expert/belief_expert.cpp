#include "expert/belief_expert.h"

#include <algorithm>
#include <memory>
#include <set>
#include <span>
#include <utility>

#include "expert/belief.h"
#include "expert/execution.h"
#include "expert/known_world.h"
#include "expert/search_order.h"
#include "expert/search_tools.h"
#include "expert/tidying.h"

namespace unietp {
namespace {

constexpr double kEnough = 0.05;        // of the chances to find more of what the goal speaks of all of
constexpr int kMostThoroughSteps = 20;  // spent on that before something is done
constexpr int kMostCheckingSteps = 30;  // of all, when more is looked for at the end
constexpr int kStepsForTheRest = 4;     // at least, after what is needed was found
constexpr int kStepsToBeTidy = 25;      // left, else nothing is closed while something is looked for
constexpr std::size_t kLongestRun = 3;

/// Looks, plans and acts behind a window.
class BeliefExpert {
 public:
  BeliefExpert(const SearchProblem& problem, Window& window)
      : problem_(problem),
        window_(window),
        needs_(search_needs(problem.goal)),
        profile_(profile_of_m2(problem.profile)),
        belief_(window.known_scene(), needs_, relevant()),
        order_(window.known_scene(), problem.knowledge, problem.usual, needs_.shut, profile_.turn_deg),
        known_world_(problem.knowledge, problem.profile, window) {}

  std::optional<Trouble> run() {
    see();
    while (!gave_up_) {
      if (has_plan()) {
        if (follow()) return std::nullopt;
      } else if (!may_plan() || !make_plan()) {
        search();
      }
    }
    return trouble_;
  }

 private:
  int steps_left() const { return rules_of(Mode::M2).limits.steps - steps_; }
  bool has_plan() const { return next_ < plan_.size(); }
  void give_up(std::string why, Failure failure = Failure::NotSeenYet) {
    trouble_ = {std::move(why), failure};
    gave_up_ = true;
  }

  std::set<std::string> relevant() const {
    std::set<std::string> all;
    for (const std::string& category : categories_of(problem_.goal)) all.insert(category);
    for (const WantedState& wanted : needs_.states) {
      if (wanted.stated) continue;
      for (const std::string& category : wanted.categories) {
        for (std::string& tool : tools_for(wanted, category, problem_.knowledge, profile_)) all.insert(std::move(tool));
      }
    }
    return all;
  }

  void see() {
    const std::vector<Node> view = window_.view();
    belief_.see(view, window_.body());
    for (const Node& node : view) order_.glimpsed(node.id);
  }

  /// False when it could not be done.
  bool act(const Action& action) {
    const Outcome outcome = window_.act(action);
    if (!outcome.success) {
      trouble_ = {to_text(action) + ": " + outcome.feedback, outcome.failure};
      return false;
    }
    ++steps_;
    known_world_.follow(action);
    if (acted_) foresee(action);
    see();
    return true;
  }

  bool is_known(const std::string& category) const {
    if (belief_.count(category) > 0) return true;
    const auto& rooms = belief_.scene().rooms;
    return std::any_of(rooms.begin(), rooms.end(), [&](const Room& room) { return room.type == category; });
  }
  int known_of(const std::vector<std::string>& categories) const {
    int known = 0;
    for (const std::string& category : categories) {
      known += belief_.count(category);
      for (const Room& room : belief_.scene().rooms) known += room.type == category ? 1 : 0;
    }
    return known;
  }
  bool is_movable(const std::string& category) const {
    const Category* known = problem_.knowledge.find(category);
    return known != nullptr && known->movable;
  }

  void add_targets(std::vector<SearchTarget>& targets, const SearchNeed& need) const {
    for (const std::string& category : need.categories) {
      if (is_movable(category)) targets.push_back({category, need.places, need.rooms, need.floor, need.near});
    }
  }

  /// What has to be found before it is worth while to plan; empty when nothing has.
  std::vector<SearchTarget> missing() const {
    std::vector<SearchTarget> targets;
    for (const SearchNeed& need : needs_.needs) {
      if (known_of(need.categories) < need.at_least) add_targets(targets, need);
    }
    if (!targets.empty()) return targets;
    for (const WantedState& wanted : needs_.states) {
      if (wanted.stated) continue;
      for (const std::string& category : wanted.categories) {
        const auto tools = tools_for(wanted, category, problem_.knowledge, profile_);
        if (tools.empty() ||
            std::any_of(tools.begin(), tools.end(), [this](const auto& tool) { return is_known(tool); }))
          continue;
        for (const std::string& tool : tools) targets.push_back({tool});
      }
    }
    return targets;
  }

  /// Of what the goal speaks of all of, where there may well be more.
  std::vector<SearchTarget> overlooked(int most_steps) const {
    std::vector<SearchTarget> targets;
    if (steps_ >= most_steps) return targets;
    for (const SearchNeed& need : needs_.needs) {
      if (!need.every) continue;
      std::vector<SearchTarget> all;
      add_targets(all, need);
      for (SearchTarget& target : all) {
        if (order_.unseen_share(target, belief_) > kEnough) targets.push_back(std::move(target));
      }
    }
    return targets;
  }

  bool may_plan() {
    const bool news = planned_at_ != belief_.news();  // since it did not work
    return acted_ ? news : found_enough();
  }

  /// What is believed of the home as it was when the first plan was made: with what has come into view since, as it is
  /// unless the agent itself has changed it.
  Scene believed_before() const {
    if (done_.empty()) return belief_.scene();
    Scene before = *believed_scene_;
    NodeIndex places(before.nodes);
    for (const Node& node : belief_.scene().nodes) {
      if (touched_.contains(node.id)) continue;
      if (const auto place = places.find(node.id)) {
        if (before.nodes[*place] != node) before.nodes.edit(*place) = node;
      } else if (node.slice_of.empty()) {
        before.nodes.push_back(node);
      }
    }
    return before;
  }

  /// A world made of what is believed, where the agent does again what it has done since the first plan, and how to go
  /// on from there: the rest of the present plan if it still works, else another.
  bool make_plan() {
    planned_at_ = belief_.news();
    auto scene = std::make_unique<Scene>(believed_before());
    KnownStart known = known_world_.home().of(*scene);
    auto made = ExecutionTree::of(problem_.goal, *scene, problem_.knowledge, problem_.profile, std::move(known));
    if (!made) return false;
    auto tree = std::make_unique<ExecutionTree>(std::move(*made));
    ModeRules rules = rules_of(Mode::M2);
    rules.movables = true;  // all that is believed was seen
    rules.limits.steps = steps_left() + static_cast<int>(done_.size());
    Rollout again(*tree, rules);
    again.go_on(done_);
    unfit_ = again.done().size() != done_.size();
    if (unfit_) {
      trouble_ = {"what was done does not fit what was seen"};
      return false;
    }
    std::optional<std::vector<Action>> plan = done_.empty() ? std::nullopt : the_rest(again);
    if (!plan) plan = another_plan(*tree, rules);
    if (!plan) return false;
    if (plan->size() == 1 && !acted_) {
      trouble_ = {"all that was seen is as it should be", Failure::NotSeenYet};
      return false;  // there must be something to do: it was not seen yet
    }
    plan_ = std::move(*plan);
    next_ = 0;
    foreseen_ = std::make_unique<World>(tree->world());
    for (const Action& action : done_) (void)foreseen_->step(action);
    believed_ = std::move(tree);
    believed_scene_ = std::move(scene);
    return true;
  }

  /// What is left of the plan, if it reaches the goal.
  std::optional<std::vector<Action>> the_rest(Rollout rollout) const {
    const std::span left = std::span(plan_).subspan(std::min(next_, plan_.size()));
    if (left.empty()) return std::nullopt;
    rollout.go_on(left);
    if (rollout.done().size() != done_.size() + left.size() || !rollout.reaches_goal()) return std::nullopt;
    return std::vector(left.begin(), left.end());
  }

  std::optional<std::vector<Action>> another_plan(ExecutionTree& tree, const ModeRules& rules) {
    const ExpertOptions options{.max_steps = rules.limits.steps, .mode = Mode::M2};
    auto found = find_plan_from(tree, {done_, {}, false}, options);
    if (auto* why = std::get_if<Rejection>(&found)) {
      trouble_ = {std::string(name_of(why->reason)) + ": " + why->detail, why->failure};
      return std::nullopt;
    }
    std::vector<Action> whole = done_;
    const auto& rest = std::get<std::vector<Action>>(found);
    whole.insert(whole.end(), rest.begin(), rest.end());
    auto explored = explore(rules, tree, std::move(whole), options);
    if (auto* why = std::get_if<Trouble>(&explored)) {
      trouble_ = std::move(*why);
      return std::nullopt;
    }
    auto& done = std::get<std::vector<Action>>(explored);
    done.push_back({ActionType::Stop, {}});
    if (done.size() <= done_.size() || !std::equal(done_.begin(), done_.end(), done.begin())) {
      trouble_ = {"what was done does not fit what was seen"};
      return std::nullopt;
    }
    const auto plan = without_needless(tree, rules, std::move(done), kLongestRun, done_.size());
    if (!plan) return std::nullopt;
    const auto careful = tidied(tree, rules, *plan, done_.size(), opened_);
    return std::vector(careful.begin() + static_cast<std::ptrdiff_t>(done_.size()), careful.end());
  }

  /// One step of the plan; true when it was the last.
  bool follow() {
    if (concerns_plan()) {
      if (!make_plan() && !unfit_) plan_.clear();
      return false;
    }
    if (std::exchange(strayed_, false)) (void)make_plan();  // else on with what was planned for another spot
    if (plan_[next_].type == ActionType::Stop) {
      if (look_for_more()) return false;
      if (!close_behind()) give_up("in search: " + trouble_.text, trouble_.failure);
      if (gave_up_) return false;
    }
    Action action = plan_[next_];
    if (acts_on_presumed(action)) {
      action = {ActionType::TurnTo, action.args};
    } else {
      ++next_;
    }
    if (action.type == ActionType::Stop) return window_.act(action).success;
    if (action.type == ActionType::TurnTo) looked_for_.insert(action.args.front());
    if (!act_as_planned(action)) {
      give_up("for " + to_text(action) + ": " + trouble_.text, trouble_.failure);
      return false;
    }
    acted_ = true;
    return false;
  }

  /// Whether it switches or moves a door of furniture whose state nobody has seen yet: that is looked at first.
  bool acts_on_presumed(const Action& action) const {
    const bool depends = action.type == ActionType::TurnOn || action.type == ActionType::TurnOff ||
                         action.type == ActionType::Open || action.type == ActionType::Close;
    if (!depends || action.args.empty() || looked_for_.contains(action.args.front()) ||
        belief_.has_seen(action.args.front()))
      return false;
    World trial = *foreseen_;
    return trial.step({ActionType::TurnTo, action.args}).success;
  }

  /// All is done that was seen to be needed. One look more where there may well be more of what the goal speaks of all
  /// of; false when that is not worth it.
  bool look_for_more() {
    const auto targets = overlooked(kMostCheckingSteps);
    const auto look = targets.empty() || steps_left() <= kStepsForTheRest ? std::nullopt : next_look(targets);
    if (!look) return false;
    const int before = belief_.news();
    if (!look_there(*look)) give_up("in search: " + trouble_.text, trouble_.failure);
    surprised_ = surprised_ || belief_.news() != before;
    return true;
  }

  /// Takes in what an action must have changed.
  void foresee(const Action& action) {
    done_.push_back(action);
    (void)foreseen_->step(action);
    for (const Node& node : foreseen_->changes().nodes) touched_.insert(node.id);
    belief_.foresee(foreseen_->changes());
  }

  bool act_as_planned(const Action& action) {
    const Outcome outcome = window_.act(action);
    if (!outcome.success) {
      trouble_ = {outcome.feedback, outcome.failure};
      return false;
    }
    ++steps_;
    if (action.type == ActionType::GoTo) at_ = action.args.front();
    if (info(action.type).group == ActionClass::Movement && action.args.empty()) at_.clear();
    foresee(action);
    const int before = belief_.news();
    see();
    surprised_ = surprised_ || belief_.news() != before || in_the_way();
    strayed_ = (foreseen_->agent().position - window_.body().position).norm() > kStray_m;
    return true;
  }

  /// Something came into view where the plan puts something down.
  bool in_the_way() const {
    for (auto action = plan_.begin() + static_cast<std::ptrdiff_t>(next_); action != plan_.end(); ++action) {
      if (action->type != ActionType::PlaceOn && action->type != ActionType::PlaceIn) continue;
      const Node* target = belief_.find(action->args.front());
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
    return std::any_of(plan_.begin() + static_cast<std::ptrdiff_t>(next_), plan_.end(), uses);
  }

  /// Enough is known to try a plan that was not tried yet.
  bool found_enough() const {
    return planned_at_ != belief_.news() && missing().empty() && overlooked(kMostThoroughSteps).empty();
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
    const auto in_reach = [this](const std::string& id) { return known_world_.opens_from_here(id); };
    auto look = order_.next(targets, belief_, at_, in_reach);
    while (look && !would_work(*look)) look = order_.next(targets, belief_, at_, in_reach);
    return look;
  }

  /// One look where something needed may be.
  void search() {
    if (steps_left() <= kStepsForTheRest)
      return give_up("too long a search for " + names_of(missing()) + "; " + trouble_.text);
    auto targets = missing();
    if (targets.empty()) targets = overlooked(kMostThoroughSteps);
    if (targets.empty()) {
      for (const SearchNeed& need : needs_.needs) {
        for (const std::string& category : need.categories)
          targets.push_back({category, need.places, need.rooms, need.floor, need.near});
      }
    }
    const auto look = next_look(targets);
    if (!look) return give_up("nowhere left to look for " + names_of(targets) + "; " + trouble_.text);
    if (!look_there(*look)) give_up("in search: " + trouble_.text, trouble_.failure);
  }

  /// Closes what was opened last if it showed nothing of use and is not what comes next; false when that failed.
  bool close_behind(const std::string& next = {}) {
    if (empty_.empty() || empty_ == next) return true;
    const Action close{ActionType::Close, {std::exchange(empty_, {})}};
    if (steps_left() <= kStepsToBeTidy || !known_world_.allows(close)) return true;
    if (!act(close)) return false;
    std::erase(opened_, close.args.front());
    return true;
  }

  /// False when something failed.
  bool look_there(const SearchOrder::Look& look) {
    if (!close_behind(look.id)) return false;
    const auto way = order_.way_to(look, at_);
    for (const Action& action : way) {
      if (!known_world_.allows(action)) break;
      if (!act(action)) return false;
      at_ = action.type == ActionType::GoTo ? action.args.front() : at_;
      if (action != way.back() && found_enough()) break;
    }
    const bool opens = look.opens && (way.empty() || look.before > 0 || !found_enough());
    if (opens && !belief_.find(look.id)->states.has(Predicate::Open)) {
      if (runs(look.id) && !act({ActionType::TurnOff, {look.id}})) return false;
      const int before = belief_.news();
      if (!act({ActionType::Open, {look.id}})) return false;
      opened_.push_back(look.id);
      if (belief_.news() == before) empty_ = look.id;
    }
    look.from_here ? order_.peeked_into(look.id) : order_.looked_at(look.id, belief_);
    return true;
  }

  const SearchProblem& problem_;
  Window& window_;
  SearchNeeds needs_;
  Profile profile_;
  Belief belief_;
  SearchOrder order_;
  KnownWorld known_world_;

  std::vector<Action> plan_;
  std::size_t next_ = 0;
  bool unfit_ = false;   // no plan was made, since what was done does not work in the home that is believed now
  int planned_at_ = -1;  // the news when it was made, or could not be made
  std::unique_ptr<Scene> believed_scene_;  // before the first plan
  std::unique_ptr<ExecutionTree> believed_;
  std::unique_ptr<World> foreseen_;                // where the plan should have led by now
  std::vector<Action> done_;                       // since the first plan
  std::set<std::string, std::less<>> touched_;     // what that changed
  std::set<std::string, std::less<>> looked_for_;  // furniture that was turned to before it was used

  std::string at_;                   // the place that it looked at last
  std::vector<std::string> opened_;  // for a look, and not closed since
  std::string empty_;                // of these the last, if it showed nothing of use
  int steps_ = 0;
  bool acted_ = false, gave_up_ = false;
  bool surprised_ = false, strayed_ = false;  // by the last step: something came into view; it led elsewhere
  Trouble trouble_;
};

}  // namespace

std::optional<Trouble> reach_by_belief(const SearchProblem& problem, Window& window) {
  return BeliefExpert(problem, window).run();
}

}  // namespace unietp
