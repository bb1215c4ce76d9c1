#include "grounding/home_faults.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/limits.h"
#include "grounding/reach.h"
#include "grounding/reachability.h"
#include "scene/near_room.h"
#include "simulation/drift.h"
#include "simulation/relations.h"
#include "simulation/touch.h"

namespace unietp {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kFaultNames{
    {{"blocked", "its door, lid or drawer meets something fixed on its way"},
     {"cut-off", "the agent cannot walk to most of this room's free floor"},
     {"floating", "furniture that touches no floor, wall, ceiling or other furniture"},
     {"frozen", "a person could pick it up, but it is fixed in place"},
     {"out-of-reach", "the agent has no place to stand from which it reaches and sees it"},
     {"outside-rooms", "it is more than half a meter from every room"},
     {"overlap", "two objects are in one another"},
     {"restless", "it does not stay where it is for two seconds of physics"},
     {"sunk", "it is below the floor"},
     {"unknown-category", "the knowledge base has no such category: no task can be about it"}}};

constexpr double kIntoEachOther_m = 0.002;  // physics lets resting bodies sink into one another by less
constexpr double kMoves_m = 0.005;          // what `validate` allows
constexpr double kHangs_m = 0.05;           // nearer to something it can be fixed to that
constexpr double kBelowCeiling_m = 0.3;     // lamps hang so far below

class Checkup {
 public:
  Checkup(const Scene& scene, const Knowledge& knowledge, const Profile& profile)
      : scene_(scene), knowledge_(knowledge), profile_(profile), world_(physics_of(scene)) {}

  std::vector<HomeFinding> findings() {
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) check(i);
    std::size_t work = limits::kMostWork;
    for (const Drift& drift : drifting(scene_, world_, kMoves_m, work))
      add(HomeFault::Restless, drift.node, "", drift.moved_m);
    const Walk walk = walk_in(scene_, profile_);
    for (const std::string& id : unreached_rooms(scene_, walk)) {
      found_.push_back({HomeFault::CutOff, id, find_room(scene_, id)->type, "", 0});
    }
    for (const std::size_t i : unreached_furniture(scene_, world_, profile_, walk)) add(HomeFault::OutOfReach, i);
    std::stable_sort(found_.begin(), found_.end(),
                     [](const HomeFinding& a, const HomeFinding& b) { return a.fault < b.fault; });
    return std::move(found_);
  }

 private:
  void add(HomeFault fault, std::size_t node, std::string other = "", double by_m = 0) {
    found_.push_back({fault, scene_.nodes[node].id, scene_.nodes[node].category, std::move(other), by_m});
  }

  std::string name_of_body(BodyId id) const {
    if (id.is_node()) return scene_.nodes[id.index()].id;
    return id.is_wall() ? "wall" : "floor";
  }

  void check(std::size_t i) {
    const Node& node = scene_.nodes[i];
    const Category* category = knowledge_.find(node.category);
    if (category == nullptr) add(HomeFault::UnknownCategory, i);
    if (category != nullptr && category->movable && !node.movable) add(HomeFault::Frozen, i);
    if (!is_near_a_room(scene_, node.pose.position.head<2>())) add(HomeFault::OutsideRooms, i);
    const Bounds bounds = world_.bounds(BodyId::node(i));
    if (bounds.low.z() < -kIntoEachOther_m) add(HomeFault::Sunk, i, "floor", -bounds.low.z());
    if (!node.movable && floats(i, bounds)) add(HomeFault::Floating, i, "", bounds.low.z());
    if (const auto met = what_blocks(scene_, world_, i)) add(HomeFault::Blocked, i, name_of_body(*met));
    check_overlaps(i, bounds);
  }

  bool floats(std::size_t i, const Bounds& bounds) const {
    if (bounds.low.z() < kHangs_m || bounds.high.z() > scene_.wall_height - kBelowCeiling_m) return false;
    const auto near = world_.near(bounds, kHangs_m);
    return std::none_of(near.begin(), near.end(), [&](BodyId id) {
      return id != BodyId::node(i) && (!id.is_node() || !scene_.nodes[id.index()].movable);
    });
  }

  std::vector<Convex> solids_of(std::size_t i) const {
    return world_.collider(BodyId::node(i)).placed(scene_.nodes[i].pose);
  }

  void check_overlaps(std::size_t i, const Bounds& bounds) {
    std::vector<Convex> own;
    for (const BodyId id : world_.near(bounds, 0)) {
      if (!id.is_node() || id.index() <= i) continue;
      if (own.empty()) own = solids_of(i);
      double deepest = 0;
      for (const Convex& other : solids_of(id.index())) {
        for (const Convex& one : own) {
          if (!unietp::overlap(one.bounds, other.bounds)) continue;
          if (const auto touching = touch(one, other)) deepest = std::max(deepest, touching->depth);
        }
      }
      if (deepest > kIntoEachOther_m) add(HomeFault::Overlap, i, scene_.nodes[id.index()].id, deepest);
    }
  }

  const Scene& scene_;
  const Knowledge& knowledge_;
  const Profile& profile_;
  PhysicsWorld world_;
  std::vector<HomeFinding> found_;
};

}  // namespace

std::string_view name_of(HomeFault fault) { return kFaultNames[static_cast<std::size_t>(fault)].first; }
std::string_view meaning_of(HomeFault fault) { return kFaultNames[static_cast<std::size_t>(fault)].second; }

std::vector<HomeFinding> faults_of(const Scene& scene, const Knowledge& knowledge, const Profile& profile) {
  return Checkup(scene, knowledge, profile).findings();
}

}  // namespace unietp
