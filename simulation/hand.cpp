#include <algorithm>

#include "simulation/spots.h"
#include "simulation/world_state.h"

namespace unietp {
namespace {

constexpr int kMostSettles = 6;  // free spots that are tried before giving up
constexpr std::size_t kMostHidden =
    200;                               // free spots that are postponed because the object could not be picked up there
constexpr double kTouching_m = 0.003;  // bodies nearer than this may support one another
constexpr double kSunk_m = 0.003;      // resting contacts sink by up to this much
constexpr double kKnocked_m = 0.05;    // neighbors that move farther than this have been knocked over

Bounds group_bounds(const WorldState& state, const std::vector<std::size_t>& group) {
  Bounds all = state.physics().bounds(BodyId::node(group.front()));
  for (const std::size_t i : group) {
    const Bounds one = state.physics().bounds(BodyId::node(i));
    all.low = all.low.cwiseMin(one.low);
    all.high = all.high.cwiseMax(one.high);
  }
  return all;
}

/// Movable bodies that touch the bounds, with all that rests on or in them, without `group`. Sorted.
std::vector<BodyId> neighbors(const WorldState& state, const Bounds& bounds, const std::vector<std::size_t>& group) {
  std::vector<BodyId> found;
  for (const BodyId id : state.physics().near(bounds, kTouching_m)) {
    if (!id.is_node() || !state.node(id.index()).movable) continue;
    for (const std::size_t member : state.group_of(id.index())) {
      if (std::find(group.begin(), group.end(), member) == group.end()) found.push_back(BodyId::node(member));
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Moves bodies and nodes to their settled poses; returns the largest displacement of those in `watched`.
double apply(WorldState& state, const Settled& settled, const std::vector<BodyId>& watched) {
  double farthest = 0;
  for (const SettledBody& body : settled.bodies) {
    const Node& node = state.node(body.body.index());
    if (std::find(watched.begin(), watched.end(), body.body) != watched.end()) {
      farthest = std::max(farthest, (node.pose.position - body.pose.position).norm());
    }
    state.move(body.body.index(), body.pose);
  }
  return farthest;
}

struct FreeSpot {
  Pose pose;      // of the object, W
  double effort;  // meters
};

struct Spots {
  std::vector<FreeSpot> spots;  // in reach, easiest first
  SurfaceFit offer;
};

/// Adds a top surface for attached objects where nothing else can be placed: a camera on a tripod.
void add_top(Shape& shape, const Vec3& size) {
  const bool open =
      std::any_of(shape.surfaces.begin(), shape.surfaces.end(), [](const Surface& s) { return s.cavity < 0; });
  constexpr double kClearance_m = 2.0;
  if (!open) shape.surfaces.push_back({Vec3(0, 0, size.z() / 2), size.head<2>() / 2, kClearance_m, -1, -1});
}

Spots spots_on(const WorldState& state, std::size_t target, const Vec3& size, bool inside, bool alone, bool attaches) {
  Spots result;
  const Node& receptacle = state.node(target);
  Shape shape = state.collider(target).shape;
  if (attaches) add_top(shape, receptacle.size);
  const Vec2 agent = state.agent().position;
  result.offer = for_each_spot(receptacle, shape, size, inside, alone, [&](const Pose& pose) {
    const double arm = arm_length(pose.position, agent, *state.profile);
    if (arm <= state.profile->reach_m) result.spots.push_back({pose, effort(pose.position, arm)});
    return true;
  });
  std::stable_sort(result.spots.begin(), result.spots.end(),
                   [](const FreeSpot& a, const FreeSpot& b) { return a.effort < b.effort; });
  return result;
}

bool free_at(const WorldState& state, const std::vector<std::size_t>& group, const Pose& motion) {
  return std::none_of(group.begin(), group.end(), [&](std::size_t i) {
    const Node& node = state.node(i);
    return state.physics().overlap(state.collider(i), motion * node.pose, {}).has_value();
  });
}

/// Whether the agent could pick the object up from a pose without moving.
bool in_grasp(const WorldState& state, const std::vector<std::size_t>& group, const Pose& pose) {
  const Vec2& place = state.agent().position;
  Node thing = state.node(group.front());
  thing.pose = pose;
  if (reach_distance(thing, place, *state.profile) > state.profile->reach_m) return false;
  const std::vector<BodyId> held = bodies_of(group);
  return sees(thing, held.front(), state.physics(), *state.profile, place, held);
}

}  // namespace

ActionResult pick_up(WorldState& state, std::size_t i) {
  const std::string id = state.node(i).id;
  if (state.held(id)) return failed(FailureCause::AlreadyInHand, state.reference(i));
  if (!state.node(i).movable || !state.knowledge->has(state.node(i).category, "pickupable")) {
    return failed(FailureCause::NotPickupable, state.reference(i));
  }
  if (state.node(i).states.has(Predicate::SatOn) || state.node(i).states.has(Predicate::LainOn))
    return failed(state.node(i).states.has(Predicate::LainOn) ? FailureCause::LiesOn : FailureCause::SitsOn,
                  state.reference(i));
  if (static_cast<int>(state.agent().held.size()) >= state.profile->hands) {
    return failed(FailureCause::HandsFull, state.reference(*state.index_of(state.agent().held.front())));
  }
  if (auto blocked = access_failure(state, i)) return *blocked;
  const std::vector<std::size_t> group = state.group_of(i);
  double mass = 0;
  for (const std::size_t member : group) mass += state.node(member).mass;
  if (mass > state.profile->max_pick_mass_kg) return failed(FailureCause::TooHeavy, state.reference(i));

  look_at(state, state.node(i).pose.position);
  const Bounds before = group_bounds(state, group);
  const auto left_behind = neighbors(state, before, group);
  for (const std::size_t member : group) state.lift(member);
  state.edit_agent().held.push_back(id);
  state.set_hand({});
  state.carry_along();
  std::vector<Bounds> touched{before};
  std::vector<std::size_t> changed = nodes_of(left_behind);
  if (!left_behind.empty()) {
    apply(state, state.physics().settle(left_behind), {});
    touched.push_back(group_bounds(state, changed));
  }
  changed.insert(changed.end(), group.begin(), group.end());
  state.refresh(touched, changed);
  return succeeded();
}

ActionResult place(WorldState& state, std::size_t target, bool inside, bool within_grasp) {
  if (state.agent().held.empty()) return failed(FailureCause::HandsEmpty);
  const std::string id = state.agent().held.front();
  const std::size_t i = *state.index_of(id);
  const std::vector<std::size_t> group = state.group_of(i);
  if (std::find(group.begin(), group.end(), target) != group.end()) {
    return failed(FailureCause::InHand, state.reference(target));
  }
  if (auto blocked = access_failure(state, target)) return *blocked;
  const Node& receptacle = state.node(target);
  if (inside && receptacle.openable && !receptacle.states.has(Predicate::Open)) {
    return failed(FailureCause::ReceptacleClosed, state.reference(target));
  }
  const bool attaches =
      !inside && state.profile->attaching &&
      state.knowledge->effect(receptacle.category, Treatment::Attaches, state.node(i).category) != nullptr;
  const Spots spots = spots_on(state, target, state.node(i).size, inside, group.size() == 1, attaches);
  if (!spots.offer.any_surface) {
    return failed(inside ? FailureCause::NoInside : FailureCause::NoSurface, state.reference(target));
  }
  if (!spots.offer.any_fit)
    return failed(inside ? FailureCause::DoesNotFitInto : FailureCause::DoesNotFitOn, state.reference(i),
                  state.reference(target));

  int settles = 0;
  const std::size_t before = state.mark();
  const auto rests_at = [&](const Pose& pose) {
    ++settles;
    const Pose motion = pose * inverse(state.node(i).pose);
    for (const std::size_t member : group) {
      state.move(member, member == i ? pose : motion * state.node(member).pose);
      state.lay(member);
    }
    look_at(state, state.node(i).pose.position);
    const Bounds let_go = group_bounds(state, group);
    const auto beside = neighbors(state, let_go, group);
    std::vector<BodyId> loose = bodies_of(group);
    loose.insert(loose.end(), beside.begin(), beside.end());
    const Settled settled = state.physics().settle(loose);
    const double knocked = apply(state, settled, beside);
    if (!settled.calm || knocked > kKnocked_m) return false;
    std::erase(state.edit_agent().held, id);
    const std::vector<std::size_t> changed = nodes_of(loose);
    const Bounds touched[] = {let_go, group_bounds(state, changed)};
    state.refresh(touched, changed);
    if (!state.linked(i, inside ? Predicate::Inside : Predicate::On, target)) return false;
    if (within_grasp && access_failure(state, i)) return false;
    if (attaches) state.attach(i, target);
    run_processes(state, target);
    return true;
  };
  // Spots where the object would be out of sight, such as behind the near wall of a basin, come last.
  std::vector<const Pose*> hidden;
  for (const FreeSpot& spot : spots.spots) {
    if (settles == kMostSettles) break;
    state.back_to(before);
    if (!free_at(state, group, spot.pose * inverse(state.node(i).pose))) continue;
    if ((inside || within_grasp) && hidden.size() < kMostHidden && !in_grasp(state, group, spot.pose)) {
      hidden.push_back(&spot.pose);
    } else if (rests_at(spot.pose)) {
      return succeeded();
    }
  }
  for (const Pose* pose : hidden) {
    if (within_grasp || settles == kMostSettles) break;
    state.back_to(before);
    if (rests_at(*pose)) return succeeded();
  }
  if (settles > 0) return failed(FailureCause::DidNotRest, state.reference(i));
  return failed(inside ? FailureCause::NoFreePlaceInside : FailureCause::NoFreePlaceOn, state.reference(target));
}

std::vector<Pose> free_spots(const WorldState& state, std::size_t i, std::size_t target, bool inside) {
  std::vector<Pose> free;
  const std::vector<std::size_t> group = state.group_of(i);
  if (std::find(group.begin(), group.end(), target) != group.end()) return free;
  for_each_spot(state.node(target), state.collider(target).shape, state.node(i).size, inside, group.size() == 1,
                [&](const Pose& pose) {
                  if (free_at(state, group, pose * inverse(state.node(i).pose))) free.push_back(pose);
                  return true;
                });
  return free;
}

namespace {

/// Whether a body came to rest overlapping another one, which can happen after a fall.
bool any_sunk(const WorldState& state, const std::vector<std::size_t>& bodies) {
  return std::any_of(bodies.begin(), bodies.end(), [&](std::size_t i) {
    const BodyId self[] = {BodyId::node(i)};
    const Node& node = state.node(i);
    return state.physics().overlap(state.collider(i), node.pose, self, kSunk_m).has_value();
  });
}

}  // namespace

ActionResult drop(WorldState& state) {
  if (state.agent().held.empty()) return failed(FailureCause::HandsEmpty);
  const std::string id = state.agent().held.front();
  const std::vector<std::size_t> group = state.group_of(*state.index_of(id));
  if (!free_at(state, group, Pose{Vec3::Zero(), Quat::Identity()}))
    return failed(FailureCause::NoRoomToFall, state.reference(group.front()));
  for (const std::size_t member : group) state.lay(member);
  const Bounds let_go = group_bounds(state, group);
  // Anything below may be hit.
  Bounds below = let_go;
  below.low.z() = 0;
  const auto hit = neighbors(state, below, group);
  std::vector<BodyId> loose = bodies_of(group);
  loose.insert(loose.end(), hit.begin(), hit.end());
  const Settled settled = state.physics().settle(loose);
  apply(state, settled, {});
  const std::vector<std::size_t> changed = nodes_of(loose);
  const bool in_a_room = std::all_of(changed.begin(), changed.end(), [&](std::size_t i) {
    return room_at(state.scene(), state.node(i).pose.position.head<2>()) != nullptr;
  });
  if (!settled.calm || !in_a_room || any_sunk(state, changed))
    return failed(FailureCause::WouldNotRest, state.reference(group.front()));
  std::erase(state.edit_agent().held, id);
  const Bounds touched[] = {below, group_bounds(state, changed)};
  state.refresh(touched, changed);
  return succeeded();
}

}  // namespace unietp
