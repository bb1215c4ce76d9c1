#include "expert/exploration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "expert/poses.h"
#include "expert/rollout.h"
#include "simulation/agent_moves.h"
#include "simulation/solids.h"
#include "simulation/view.h"

namespace unietp {
namespace {

constexpr double kMostSteps = 16;         // of a search, from where it begins
constexpr std::size_t kMostPoses = 5000;  // looked from
constexpr int kMostNamings = 50;          // poses that it is come to, to see whether the object can be named there
constexpr std::size_t kMostLookouts = 5;
constexpr std::size_t kMostNearby = 12, kMostNear = 24;
constexpr double kNearby_m = 2, kNear_m = 3;
constexpr double kElsewhere = 0.5;  // penalty for looking from furniture that has nothing to do with the object

constexpr std::array kLooks{ActionType::TurnLeft, ActionType::TurnRight, ActionType::LookDown, ActionType::LookUp};
constexpr std::array kSteps{ActionType::MoveForward, ActionType::MoveBackward, ActionType::MoveLeft,
                            ActionType::MoveRight};

/// Poses a centimeter or a degree apart are the same.
Poses::Key key_of(const Agent& agent) {
  constexpr double kPlaces = 100, kAngles = 57.3;
  return {std::lround(agent.position.x() * kPlaces), std::lround(agent.position.y() * kPlaces),
          std::lround(agent.yaw * kAngles), std::lround(agent.pitch * kAngles)};
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

struct Range {
  double farthest_m;
  std::size_t most;
};

/// Ids of the nearest things around one that pass the test.
template <class Test>
std::vector<std::string> nearest(const World& world, const Node& to, const Range& range, const Test& test) {
  std::vector<std::pair<double, std::string>> found;
  for (const Node& node : world.nodes()) {
    const double away = (node.pose.position - to.pose.position).norm();
    if (node.id != to.id && away < range.farthest_m && test(node)) found.emplace_back(away, node.id);
  }
  std::sort(found.begin(), found.end());
  if (found.size() > range.most) found.resize(range.most);
  std::vector<std::string> ids;
  for (auto& [away, id] : found) ids.push_back(std::move(id));
  return ids;
}

class Search {
 public:
  Search(const ModeEpisode& episode, const Node& target, Viewpoint standing, std::size_t& looks_left)
      : episode_(episode),
        world_(episode.world()),
        target_(target),
        profile_(world_.profile()),
        standing_(standing),
        looks_left_(looks_left),
        radius_(sight_radius(target)),
        half_high_(radians(profile_.vertical_fov_deg) / 2),
        half_wide_(std::atan(std::tan(half_high_) * profile_.image_width / profile_.image_height)) {}

  /// `thorough`: also from small things nearby, where long steps and wide turns lead to few places.
  std::optional<std::vector<Action>> run(bool thorough) {
    add({world_.agent(), 0, 0, {}});
    if (thorough) begin_nearby();
    if (standing_ != Viewpoint::Here) begin_elsewhere();
    while (const auto at = poses_.next()) {
      if (looks_left_ == 0) break;
      --looks_left_;
      if (trials_ < kMostNamings && shows(poses_[*at].agent)) {
        if (auto steps = poses_.steps_to(*at); can_be_named_after(steps)) return steps;
      }
      if (poses_.size() < kMostPoses && poses_[*at].cost < kMostSteps) expand(*at);
    }
    return std::nullopt;
  }

 private:
  void begin_elsewhere() {
    if (const std::string room = world_.room_of(target_.id); !room.empty()) begin_with(room, 1);
    if (standing_ == Viewpoint::InReach) begin_with(target_.id, 1);
    double extra = 0;
    for (const std::string& id : lookouts_for(world_, target_.id)) {
      begin_with(id, 1 + extra);
      extra = kElsewhere;
    }
  }
  void add(ReachedPose pose) {
    const auto key = key_of(pose.agent);
    const double left = turns_left(pose.agent);
    poses_.add(std::move(pose), key, left);
  }
  /// Turns and tilts until some of the target may be in the picture.
  double turns_left(const Agent& agent) const {
    const Vec3 eye(agent.position.x(), agent.position.y(), profile_.camera_height_m);
    const double away = (target_.pose.position - eye).norm();
    if (away <= radius_ + profile_.step_m) return 0;  // a step may bring it anywhere
    const double own = std::asin(radius_ / away), by_a_step = std::asin(profile_.step_m / away);
    const auto steps = [&](double aside, double half, double by_deg) {
      return std::max(0.0, std::ceil((std::abs(aside) - half - own) / std::max(radians(by_deg), by_a_step)));
    };
    const Agent facing_it = facing(agent, target_.pose.position, profile_);
    return steps(std::remainder(facing_it.yaw - agent.yaw, 2 * std::numbers::pi), half_wide_, profile_.turn_deg) +
           steps(facing_it.pitch - agent.pitch, half_high_, profile_.look_deg);
  }
  void begin_with(const std::string& place, double cost) {
    const Action action{ActionType::GoTo, {place}};
    if (!episode_.command_for(action)) return;
    if (auto agent = world_.agent_after(world_.agent(), action)) add({std::move(*agent), cost, 0, action});
  }
  void begin_nearby() {
    const auto movable = [](const Node& node) { return node.movable; };
    for (const std::string& id : nearest(world_, target_, {kNearby_m, kMostNearby}, movable))
      begin_with(id, 1 + kElsewhere);
  }
  void expand(std::size_t at) {
    for (const ActionType type : kLooks) go_on(at, type);
    if (standing_ == Viewpoint::Here) return;
    for (const ActionType type : kSteps) go_on(at, type);
  }
  void go_on(std::size_t at, ActionType type) {
    const Action action{type, {}};
    const Agent from = poses_[at].agent;
    if (auto agent = world_.agent_after(from, action)) add({std::move(*agent), poses_[at].cost + 1, at, action});
  }
  bool shows(const Agent& agent) const {
    if (standing_ == Viewpoint::InReach && !world_.in_reach_from(agent.position, target_.id)) return false;
    if (episode_.rules().boxes) {
      const Vec3 eye(agent.position.x(), agent.position.y(), profile_.camera_height_m);
      if ((target_.pose.position - eye).norm() > profile_.sight_m) return false;
    }
    const auto box = world_.pictured_from(agent, target_.id);
    return box && (episode_.rules().boxes || shows_clearly(*box));
  }

  /// What lies before or behind it may have the same box in the picture, and be meant by it.
  bool can_be_named_after(const std::vector<Action>& steps) {
    ++trials_;
    ModeEpisode trial = episode_;
    const auto does = [&trial](const Action& step) { return do_in(trial, step).success; };
    return std::all_of(steps.begin(), steps.end(), does) && clearly_said(trial, {ActionType::GoTo, {target_.id}});
  }

  const ModeEpisode& episode_;
  const World& world_;
  const Node& target_;
  const Profile& profile_;
  Viewpoint standing_;
  std::size_t& looks_left_;
  double radius_, half_high_, half_wide_;  // of the target, meters; of the picture, radians
  int trials_ = 0;
  Poses poses_;
};

}  // namespace

std::vector<std::string> lookouts_for(const World& world, const std::string& id) {
  const Node* target = world.find(id);
  if (target == nullptr) return {};
  const std::string room = world.room_of(id);
  std::vector<std::tuple<bool, double, std::string>> found;
  for (const Node& node : world.nodes()) {
    if (node.movable || node.id == id) continue;
    const bool carries = world.linked(id, Predicate::On, node.id) || world.linked(id, Predicate::Inside, node.id);
    const double away = (node.pose.position - target->pose.position).head<2>().norm();
    if (!carries && (room.empty() || world.room_of(node.id) != room)) continue;
    found.emplace_back(!carries, away, node.id);
  }
  std::sort(found.begin(), found.end());
  if (found.size() > kMostLookouts) found.resize(kMostLookouts);
  std::vector<std::string> ids;
  for (auto& [other, away, name] : found) ids.push_back(std::move(name));
  return ids;
}

std::vector<std::string> things_near(const World& world, const std::string& id) {
  const Node* target = world.find(id);
  if (target == nullptr) return {};
  return nearest(world, *target, {kNear_m, kMostNear}, [&world](const Node& node) { return !world.holds(node.id); });
}

std::optional<std::vector<Action>> way_to_see(const ModeEpisode& episode, const std::string& id, Viewpoint standing,
                                              std::size_t* looks_left) {
  const Node* target = episode.world().find(id);
  if (target == nullptr) return std::nullopt;
  std::size_t all = std::numeric_limits<std::size_t>::max();
  const auto search = [&](bool thorough) {
    return Search(episode, *target, standing, looks_left != nullptr ? *looks_left : all).run(thorough);
  };
  auto way = search(false);
  return way || standing == Viewpoint::Here ? way : search(true);
}

}  // namespace unietp
