#include "expert/repositioning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "expert/poses.h"
#include "simulation/spots.h"
#include "simulation/standing.h"

namespace unietp {
namespace {

constexpr std::size_t kMostBeginnings = 12;  // objects that are gone to first
constexpr double kHighest_m = 3;             // no floor has anything farther above or below it
constexpr std::size_t kMostFootings = 800;   // looked at
constexpr int kLongestWay = 10;              // of one way
constexpr int kMostTrials = 16;              // poses from which the action is done
constexpr int kMostDrops = 60;               // the same for letting fall

constexpr std::array kFlatMoves{ActionType::MoveForward, ActionType::MoveLeft, ActionType::MoveRight,
                                ActionType::MoveBackward};
constexpr std::array kTurns{ActionType::TurnLeft, ActionType::TurnRight};  // what is dropped falls straight ahead

/// Where one may begin to come to an object from another side: itself, then what is nearest; or in a room: that, then
/// its furniture.
std::vector<std::string> beginnings(const World& world, const std::string& about) {
  std::vector<std::string> ids{about};
  const Node* object = world.find(about);
  if (object == nullptr) {
    const Room* room = world.find_room(about);
    if (room == nullptr) return ids;
    for (const std::size_t place : world.places_near(room_bounds(*room, kHighest_m), kHighest_m)) {
      const Node& node = world.nodes()[place];
      if (!node.movable && world.room_of(node.id) == about && ids.size() < kMostBeginnings) ids.push_back(node.id);
    }
    return ids;
  }
  const Node target = *object;
  std::vector<std::tuple<double, std::string>> found;
  const std::string room = world.room_of(about);
  const double farthest = target.size.head<2>().norm() / 2 + 2 * world.profile().reach_m;
  const Vec3 middle = target.pose.position;
  for (const std::size_t place : world.places_near({middle, middle}, farthest + kHighest_m)) {
    const Node& node = world.nodes()[place];
    const double away = (node.pose.position - target.pose.position).head<2>().norm();
    if (away > farthest || node.id == target.id || world.holds(node.id)) continue;
    const bool rests_there = world.linked(node.id, Predicate::On, target.id) ||
                             world.linked(node.id, Predicate::Inside, target.id) ||
                             world.linked(target.id, Predicate::On, node.id);
    const bool stands_by = !node.movable && world.room_of(node.id) == room;
    if ((rests_there || stands_by) && world.closed_around(node.id).empty()) found.emplace_back(away, node.id);
  }
  std::sort(found.begin(), found.end());
  for (auto& [away, id] : found) {
    if (ids.size() < kMostBeginnings) ids.push_back(std::move(id));
  }
  return ids;
}

class FootingSearch {
 public:
  FootingSearch(const World& world, const Action& action, const std::string& about, const Postcondition& aim)
      : world_(world), action_(action), about_(about), aim_(aim) {
    if (const Node* object = world.find(about)) object_ = *object;
    places_ = action.type == ActionType::PlaceOn || action.type == ActionType::PlaceIn;
    if (places_) spots_ = world.free_spots(action.args.front(), action.type == ActionType::PlaceIn);
  }

  std::optional<std::vector<Action>> run() {
    if (places_ && spots_.empty()) return std::nullopt;
    poses_.add({world_.agent(), 0, 0, {}}, {0, 0, 0, 1});  // what leads back to it may stand a little otherwise
    if (!object_) poses_.next();                           // one has to come to the room first
    for (const std::string& id : beginnings(world_, about_)) {
      const Action go{ActionType::GoTo, {id}};
      if (auto agent = world_.agent_after(world_.agent(), go)) add({std::move(*agent), 1, 0, go});
    }
    while (trials_ < (drops() ? kMostDrops : kMostTrials)) {
      const auto at = poses_.next();
      if (!at) break;
      if (promises(poses_[*at].agent)) {
        if (auto steps = poses_.steps_to(*at); does(steps)) return steps;
      }
      if (poses_.size() < kMostFootings && poses_[*at].cost < kLongestWay) expand(*at);
    }
    return std::nullopt;
  }

 private:
  void add(ReachedPose pose) {
    constexpr double kPlaces = 20, kAngles = 12;  // poses within 5 cm and 5 degrees of one another are the same
    const Vec2 place = pose.agent.position * kPlaces;
    const long turned = drops() ? std::lround(pose.agent.yaw * kAngles) : 0;
    poses_.add(std::move(pose), {std::lround(place.x()), std::lround(place.y()), turned, 0});
  }
  void expand(std::size_t at) {
    const auto step = [&](ActionType type) {
      const ReachedPose from = poses_[at];
      if (auto agent = world_.agent_after(from.agent, {type, {}}))
        add({std::move(*agent), from.cost + 1, at, {type, {}}});
    };
    for (const ActionType type : kFlatMoves) step(type);
    if (!drops()) return;
    for (const ActionType type : kTurns) step(type);
  }
  bool drops() const { return action_.type == ActionType::Drop; }
  /// Whether it is worth a trial: all is in reach and, of what is put down, the spot that will be taken is one.
  bool promises(const Agent& agent) const {
    const Profile& profile = world_.profile();
    if (drops()) return !aim_.at || aim_.at(held_at(agent));
    if (object_ && reach_distance(*object_, agent.position, profile) > profile.reach_m) return false;
    if (!places_) return true;
    const Pose* easiest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Pose& spot : spots_) {
      const double arm = arm_length(spot.position, agent.position, profile);
      if (arm > profile.reach_m) continue;
      const double one = effort(spot.position, arm);
      if (one >= least) continue;
      least = one;
      easiest = &spot;
    }
    return easiest != nullptr && (!aim_.at || aim_.at(*easiest));
  }
  /// Where what the hand holds now would be.
  Pose held_at(const Agent& agent) const {
    const auto stand = [](const Agent& one) { return upright(Vec3(one.position.x(), one.position.y(), 0), one.yaw); };
    const Pose& held = world_.find(world_.agent().held.front())->pose;
    return stand(agent) * inverse(stand(world_.agent())) * held;
  }
  bool does(const std::vector<Action>& steps) {
    ++trials_;
    World trial = world_;
    const bool there = std::all_of(steps.begin(), steps.end(), [&](const Action& s) { return trial.step(s).success; });
    return there && trial.step(action_).success && (!aim_.reached || aim_.reached(trial));
  }

  const World& world_;
  const Action& action_;
  const std::string& about_;
  std::optional<Node> object_;  // that it is
  const Postcondition& aim_;
  bool places_ = false;
  std::vector<Pose> spots_;
  int trials_ = 0;
  Poses poses_;
};

}  // namespace

std::optional<std::vector<Action>> steps_to_act(const World& world, const Action& action, const std::string& about,
                                                const Postcondition& aim) {
  if (world.holds(about)) return std::nullopt;
  return FootingSearch(world, action, about, aim).run();
}

}  // namespace unietp
