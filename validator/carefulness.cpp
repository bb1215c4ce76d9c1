#include "validator/carefulness.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "logic/evaluate.h"
#include "simulation/mode_episode.h"

namespace unietp {
namespace {

constexpr double kElsewhere_m = 0.05;
constexpr double kNearer_m = 1;

bool lets_go(ActionType type) {
  return type == ActionType::PlaceOn || type == ActionType::PlaceIn || type == ActionType::Drop;
}

bool is_on_the_way(ActionType type) {
  const ActionClass group = info(type).group;
  return group == ActionClass::Movement || group == ActionClass::Reach;
}

bool uses_a_device(ActionType type) { return type == ActionType::TurnOn || info(type).group == ActionClass::Composite; }

class CarefulReader {
 public:
  CarefulReader(const Formula& goal, const World& start, const TraceMaker& traces, const std::vector<Action>& plan)
      : goal_(goal), start_(start), traces_(traces), plan_(plan), named_(categories_of(goal)) {}

  Carelessness read() {
    ModeEpisode episode = beginning();
    World done = episode.world();  // when something was last done
    for (std::size_t i = 0; i < plan_.size(); ++i) {
      if (uses_a_device(plan_[i].type)) look_for_nearer(done, plan_[i].args.front());
      note_in_hand(i, episode.world());
      (void)episode.step(by_ids(plan_[i]));
      if (!is_on_the_way(plan_[i].type)) done = episode.world();
    }
    look_at_the_end(episode.world());
    Carelessness careless;
    for (auto& [kind, ids] : found_) careless[kind] = {ids.begin(), ids.end()};
    return careless;
  }

 private:
  ModeEpisode beginning() const {
    ModeRules rules = rules_of(Mode::M1);
    rules.limits.steps = rules.limits.failures = static_cast<int>(plan_.size()) + 3;
    return ModeEpisode(start_, rules);
  }

  /// Done by one who is told everything; what fails is left out.
  bool reaches_goal(const std::vector<Action>& plan) const {
    ModeEpisode episode = beginning();
    std::vector<Delta> changes;
    for (const Action& action : plan) {
      if (!episode.step(by_ids(action)).success) continue;
      for (Delta& change : episode.world().changes_by_moment()) changes.push_back(std::move(change));
    }
    return holds(goal_, traces_.of(changes));
  }

  bool is_named(const std::string& category) const {
    return std::find(named_.begin(), named_.end(), category) != named_.end();
  }

  /// What is done with the things that the hand holds, and what was taken, put down and taken again.
  void note_in_hand(std::size_t i, const World& now) {
    const Action& action = plan_[i];
    if (action.type == ActionType::PickUp) {
      const std::string& id = action.args.front();
      const auto before = parked_.find(id);
      if (before != parked_.end() && before->second < last_taken_) found_[CarelessKind::Parked].insert(id);
      last_taken_ = i;
      if (start_.find(id) != nullptr) taken_.insert(id);
    }
    for (const std::string& id : now.agent().held) {
      if (action.type == ActionType::PlaceOn || action.type == ActionType::Drop) parked_[id] = i;
      if (lets_go(action.type) || is_on_the_way(action.type) || is_for_the_hand(action.type)) continue;
      used_.insert(id);
    }
  }

  static bool is_for_the_hand(ActionType type) {
    return type == ActionType::PickUp || type == ActionType::Open || type == ActionType::Close;
  }

  /// `before`: when something was last done before the device is used.
  void look_for_nearer(const World& before, const std::string& id) {
    const Node* device = before.find(id);
    if (device == nullptr || device->movable || is_named(device->category)) return;
    const double far = before.walking_distance(id);
    const std::string category = device->category, room = before.room_of(id);
    std::vector<std::string> nearer;
    for (const Node& node : before.nodes()) {
      if (node.category == category && node.id != id && before.walking_distance(node.id) < far - kNearer_m)
        nearer.push_back(node.id);
    }
    for (const std::string& other : nearer) {
      if (before.room_of(other) == room || !reaches_goal(with(id, other))) continue;
      found_[CarelessKind::FarAway].insert(id);
      return;
    }
  }

  std::vector<Action> with(const std::string& id, const std::string& other) const {
    std::vector<Action> plan;
    for (Action action : plan_) {
      const bool is_it = !action.args.empty() && action.args.front() == id;
      if (is_it) action.args.front() = other;
      if (is_it && !is_on_the_way(action.type)) plan.push_back({ActionType::GoTo, {other}});
      plan.push_back(std::move(action));
    }
    return plan;
  }

  void look_at_the_end(const World& end) {
    for (const std::string& id : taken_) {
      const Vec3 before = start_.find(id)->pose.position;
      const Node* node = end.find(id);
      if (node == nullptr || used_.contains(id) || is_named(node->category)) continue;
      if ((node->pose.position - before).norm() < kElsewhere_m || end.holds(id)) continue;
      found_[CarelessKind::Moved].insert(id);
      if (reaches_goal(without(id))) found_[CarelessKind::MovedFreely].insert(id);
    }
    for (const Action& action : plan_) {
      const bool opens = action.type == ActionType::Open;
      if (!opens && action.type != ActionType::TurnOn) continue;
      const std::string& id = action.args.front();
      const Predicate state = opens ? Predicate::Open : Predicate::PowerOn;
      if (has(start_, id, state) || !has(end, id, state)) continue;
      auto longer = plan_;
      longer.push_back({ActionType::GoTo, {id}});
      longer.push_back({opens ? ActionType::Close : ActionType::TurnOff, {id}});
      ModeEpisode episode = beginning();
      for (const Action& one : longer) (void)episode.step(by_ids(one));
      if (!has(episode.world(), id, state) && reaches_goal(longer)) found_[CarelessKind::LeftOpenOrOn].insert(id);
    }
  }

  static bool has(const World& world, const std::string& id, Predicate state) {
    const Node* node = world.find(id);
    return node != nullptr && node->states.has(state);
  }

  /// The plan in which a thing is never taken, nor put down.
  std::vector<Action> without(const std::string& id) const {
    std::vector<Action> plan;
    bool in_hand = false;
    for (const Action& action : plan_) {
      if (action.type == ActionType::PickUp && action.args.front() == id) {
        in_hand = true;
        continue;
      }
      if (in_hand && lets_go(action.type)) {
        in_hand = false;
        continue;
      }
      plan.push_back(action);
    }
    return plan;
  }

  const Formula& goal_;
  const World& start_;
  const TraceMaker& traces_;
  const std::vector<Action>& plan_;
  std::vector<std::string> named_;
  std::map<CarelessKind, std::set<std::string>> found_;
  std::set<std::string> taken_, used_;         // of the start, what was picked up; what something was done with
  std::map<std::string, std::size_t> parked_;  // when what was put down last
  std::size_t last_taken_ = 0;                 // when something was picked up last
};

}  // namespace

std::string_view name_of(CarelessKind kind) {
  switch (kind) {
    case CarelessKind::Parked:
      return "things put down for another and fetched again";
    case CarelessKind::Moved:
      return "bystanders left elsewhere";
    case CarelessKind::MovedFreely:
      return "bystanders left elsewhere without need";
    case CarelessKind::FarAway:
      return "devices in another room though a nearer one would do";
    case CarelessKind::LeftOpenOrOn:
      return "things left open or on that could be set back";
  }
  return "";
}

Carelessness carelessness_of(const Formula& goal, const World& start, const TraceMaker& traces,
                             const std::vector<Action>& plan) {
  return CarefulReader(goal, start, traces, plan).read();
}

}  // namespace unietp
