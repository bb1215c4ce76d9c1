#include "grounding/scene_editor.h"

#include <algorithm>
#include <array>
#include <functional>

#include "grounding/floor_plan.h"
#include "grounding/furnish.h"
#include "grounding/likelihood.h"
#include "grounding/make_node.h"
#include "grounding/place_object.h"
#include "grounding/reachability.h"
#include "grounding/small_objects.h"

namespace unietp {
namespace {

constexpr double kMovableSpread = 0.04;
constexpr double kFurnitureSpread = 0.08;
constexpr double kClosedPenalty = 0.5;  // rather not behind a door
constexpr int kHostsTried = 8;
constexpr double kWallMargin_m = 0.15;

/// Kinds of place for a piece that no recipe speaks of, the most usual first.
std::vector<FurniturePosition> usual_places(const Node& node) {
  const bool hangs = node.archetype == Archetype::Panel ||
                     (node.archetype == Archetype::Fixture && node.size.z() < 1.0) ||
                     (node.archetype == Archetype::Shelf && node.size.z() < 0.5);
  std::vector<FurniturePosition> places;
  for (const auto kind :
       {FurniturePosition::Kind::Wall, FurniturePosition::Kind::Corner, FurniturePosition::Kind::Center})
    places.push_back({.kind = kind, .host = {}, .height_m = {}});
  if (hangs) places = {{.kind = FurniturePosition::Kind::WallHung, .host = {}, .height_m = {}}};
  return places;
}

}  // namespace

SceneEditor::SceneEditor(Workspace& workspace, GoalPlaces avoid, const Profile& profile, int draws, Rng rng)
    : workspace_(workspace), avoid_(std::move(avoid)), profile_(profile), draws_(draws), rng_(rng) {}

void SceneEditor::refresh() {
  if (stale_) workspace_.read_edges();
  stale_ = false;
}

bool SceneEditor::fail(RejectionReason reason, std::string detail) {
  failure_ = {reason, std::move(detail), {}};
  return false;
}

std::optional<std::size_t> SceneEditor::index_of(const std::string& id) const { return workspace_.places().find(id); }

Rng SceneEditor::next_rng() { return rng_.fork("edit", edit_number_++); }

void SceneEditor::temper(Node& node, Predicate relation, const Node& receptacle) const {
  if (workspace_.household() == nullptr) return;
  const auto likely = workspace_.household()->states_of(node.category, relation, receptacle.category);
  for (const StateGroup& group : state_groups()) {
    for (const Predicate cold : {Predicate::Cool, Predicate::Frozen}) {
      if (std::find(group.predicates.begin(), group.predicates.end(), cold) == group.predicates.end()) continue;
      const bool always = std::any_of(likely.begin(), likely.end(), [&](const LikelyState& one) {
        return one.state.predicate == cold && one.share >= 1 &&
               (node.states.has(one.state) || can_be(node, workspace_.knowledge(), one.state));
      });
      if (always) {
        node.states.set({cold, {}});
      } else if (node.states.has(cold)) {
        node.states.set({group.predicates.front(), {}});
      }
    }
  }
}

bool SceneEditor::settle_somewhere(Node node, const std::function<bool(const Node&)>& accept) {
  const Scene& scene = workspace_.scene();
  const auto known = avoid_.find(node.category);
  static const std::set<std::string> kNone;
  const std::set<std::string>& avoided = known == avoid_.end() ? kNone : known->second;
  const auto avoided_rooms = workspace_.rooms_with([&](const std::string& type) { return avoided.contains(type); });
  const auto is_avoided = [&](const Host& host) {
    return workspace_.is_in(host.node, avoided_rooms) || avoided.contains(scene.nodes[host.node].category);
  };
  std::vector<Host> hosts = hosts_for(workspace_, node);
  std::erase_if(hosts, [&](const Host& host) { return !accept(scene.nodes[host.node]); });
  if (hosts.empty()) {
    return fail(RejectionReason::NoFreePlace, "the home has no receptacle that the knowledge allows for " +
                                                  node.category + " other than where it must not be");
  }
  const auto is_apart = [&](const Host& host) {
    const auto* household = workspace_.household();
    if (household == nullptr || !household->stores(scene.nodes[host.node].category)) return false;
    refresh();
    return is_kept_apart_in(workspace_, node, host.relation, host.node);
  };
  Rng rng = next_rng();
  const std::size_t index = index_of(node.id).value_or(scene.nodes.size());
  std::string obstacle;
  std::vector<Host> last;
  if (!avoided.empty()) {
    const auto split = std::stable_partition(hosts.begin(), hosts.end(), std::not_fn(is_avoided));
    last.assign(split, hosts.end());
    hosts.erase(split, hosts.end());
  }
  for (std::vector<Host>& left : std::array{std::ref(hosts), std::ref(last)}) {
    std::vector<double> weights;
    for (const Host& host : left) {
      const Node& there = scene.nodes[host.node];
      const bool shut = host.relation == Predicate::Inside && there.openable && there.opening < 0.5;
      const double likely = likelihood_of_states(workspace_, node, {host.relation, there.category});
      weights.push_back(host.weight * (shut ? kClosedPenalty : 1) * likely);
    }
    for (int tried = 0; tried < kHostsTried && !left.empty(); ++tried) {
      const std::size_t at = rng.weighted(weights);
      const Host host = left[at];
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
      weights.erase(weights.begin() + static_cast<std::ptrdiff_t>(at));
      if (is_apart(host)) {
        obstacle = node.category + " is not kept with what is there";
        continue;
      }
      const auto place =
          find_place(workspace_, node, index, host.relation, host.node, {.draws = std::max(4, draws_ / 4)}, next_rng());
      if (!place.pose) {
        obstacle = node.category + " " + place.obstacle;
        continue;
      }
      node.pose = *place.pose;
      temper(node, host.relation, scene.nodes[host.node]);
      touched_.insert(node.id);
      if (index < scene.nodes.size()) {
        workspace_.replace(index, std::move(node));
      } else {
        workspace_.add(std::move(node));
      }
      stale_ = true;
      return true;
    }
  }
  return fail(RejectionReason::NoFreePlace, obstacle);
}

std::optional<std::string> SceneEditor::add_object(const std::string& category,
                                                   const std::function<bool(const Node&)>& accept) {
  const Category* known = workspace_.knowledge().find(category);
  if (known == nullptr) {
    fail(RejectionReason::UnknownCategory, "the knowledge base has no category " + category);
    return std::nullopt;
  }
  Rng rng = next_rng();
  Node node = make_node(workspace_, *known, kMovableSpread, rng);
  const std::string id = node.id;
  if (!settle_somewhere(std::move(node), accept)) return std::nullopt;
  return id;
}

std::optional<std::string> SceneEditor::add_furniture(const std::string& category, std::size_t room) {
  const Category* known = workspace_.knowledge().find(category);
  if (known == nullptr) {
    fail(RejectionReason::UnknownCategory, "the knowledge base has no category " + category);
    return std::nullopt;
  }
  Rng rng = next_rng();
  Node node = make_node(workspace_, *known, kFurnitureSpread, rng);
  const std::string id = node.id, room_id = workspace_.scene().rooms[room].id;
  // Small appliances stand on what the knowledge allows; the rest goes to a wall.
  for (const Host& host : hosts_for(workspace_, node)) {
    const Node& there = workspace_.scene().nodes[host.node];
    if (host.relation != Predicate::On || there.movable) continue;
    if (!contains(workspace_.scene().rooms[room].polygon, there.pose.position.head<2>())) continue;
    const auto place = find_place(workspace_, node, workspace_.scene().nodes.size(), Predicate::On, host.node,
                                  {.draws = draws_, .aligned = true}, next_rng());
    if (!place.pose) continue;
    node.pose = *place.pose;
    touched_.insert(id);
    workspace_.add(std::move(node));
    stale_ = true;
    return id;
  }
  FurnishOptions options;
  options.draws = 2 * draws_;
  auto keep_outs = keep_outs_of(workspace_, options, room);
  const auto places = usual_places(node);
  const bool placed = std::any_of(places.begin(), places.end(), [&](const FurniturePosition& where) {
    return place_furniture(workspace_, keep_outs, room, node, where, options, next_rng());
  });
  stale_ = true;
  if (placed) {
    return id;
  }
  fail(RejectionReason::LacksFurniture, "the home lacks " + category + " and " + room_id + " has no place for it");
  return std::nullopt;
}

bool SceneEditor::leaves_rooms_open() {
  const auto room = newly_unreached(*workspace_.home(), workspace_.scene(), workspace_.walk());
  return !room || fail(RejectionReason::NotReachable, *room + " cannot be walked to any more");
}

bool SceneEditor::clear_off(const std::string& id) {
  // Two things of a home from a file may rest on each other: the one that is being cleared already is left unchanged.
  const auto index = index_of(id);
  if (!index || !clearing_.insert(id).second) return true;
  refresh();
  bool cleared = true;
  for (const std::string& carried : workspace_.carried_by(*index)) {
    if (!index_of(carried)) continue;
    const bool moved = relocate(carried, [&](const Node& host) { return host.id != id; });
    cleared = moved || (!reserved_.contains(carried) && remove(carried));
    if (!cleared) break;
    refresh();
  }
  clearing_.erase(id);
  return cleared;
}

bool SceneEditor::remove(const std::string& id) {
  if (reserved_.contains(id)) return fail(RejectionReason::CannotEnforce, id + " is needed and cannot be removed");
  const auto own = workspace_.home()->places.find(id);
  if (own && !workspace_.home()->scene.nodes[*own].movable)
    return fail(RejectionReason::CannotEnforce, id + " is part of the home and cannot be removed");
  if (!clear_off(id)) return false;
  const auto index = index_of(id);
  if (!index) return fail(RejectionReason::CannotEnforce, id + " is not in the scene");
  workspace_.remove(*index);
  touched_.erase(id);
  stale_ = true;
  return true;
}

void SceneEditor::replace(Node node) {
  if (const auto index = index_of(node.id)) {
    workspace_.replace(*index, std::move(node));
  } else {
    touched_.insert(node.id);
    workspace_.add(std::move(node));
  }
  stale_ = true;
}

bool SceneEditor::relocate(const std::string& id, const std::function<bool(const Node&)>& accept) {
  const auto index = index_of(id);
  if (!index || !workspace_.scene().nodes[*index].movable) {
    return fail(RejectionReason::CannotEnforce, id + " cannot be moved");
  }
  if (!clear_off(id)) return false;
  return settle_somewhere(workspace_.scene().nodes[*index_of(id)], accept);
}

bool SceneEditor::move_to(const std::string& id, const Pose& pose) {
  const std::size_t index = *index_of(id);
  Node node = workspace_.scene().nodes[index];
  node.pose = pose;
  workspace_.replace(index, std::move(node));
  touched_.insert(id);
  stale_ = true;
  return true;
}

bool SceneEditor::put(const std::string& id, Predicate relation, const std::string& receptacle) {
  const auto index = index_of(id);
  if (!index || !workspace_.scene().nodes[*index].movable) {
    return fail(RejectionReason::CannotEnforce, id + " cannot be moved");
  }
  if (!index_of(receptacle) || receptacle == id) {
    return fail(RejectionReason::CannotEnforce, "nothing can be put " + std::string(info(relation).name) + " itself");
  }
  if (!clear_off(id)) return false;
  if (relation == Predicate::NextTo) return place_near(id, receptacle);
  if (relation == Predicate::Under) return place_under(id, receptacle);
  std::string obstacle;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const Node node = workspace_.scene().nodes[*index_of(id)];
    const auto place =
        find_place(workspace_, node, *index_of(id), relation, *index_of(receptacle), {.draws = draws_}, next_rng());
    if (place.pose) {
      Node there = node;
      there.pose = *place.pose;
      temper(there, relation, workspace_.scene().nodes[*index_of(receptacle)]);
      touched_.insert(id);
      replace(std::move(there));
      return true;
    }
    obstacle = place.obstacle;
    // Make room: something there that nobody needs goes elsewhere.
    refresh();
    bool made_room = false;
    for (const std::string& there : workspace_.carried_by(*index_of(receptacle))) {
      if (there == id || reserved_.contains(there)) continue;
      made_room = relocate(there, [&](const Node& host) { return host.id != receptacle; });
      if (made_room) break;
    }
    if (!made_room) break;
  }
  const std::string category = workspace_.scene().nodes[*index_of(id)].category;
  return fail(RejectionReason::NoFreePlace,
              category + " finds no place " + std::string(info(relation).name) + " " + receptacle + ": it " + obstacle);
}

bool SceneEditor::place_under(const std::string& id, const std::string& other) {
  const Node object = workspace_.scene().nodes[*index_of(id)];
  const Node above = workspace_.scene().nodes[*index_of(other)];
  const auto place = find_place_on_floor(workspace_, object, *index_of(id), bounds_of(above.pose, above.size),
                                         {.draws = 2 * draws_}, next_rng());
  if (!place.pose)
    return fail(RejectionReason::NoFreePlace, object.category + " under " + other + " " + place.obstacle);
  return move_to(id, *place.pose);
}

bool SceneEditor::put_on_floor(const std::string& id, const std::string& room) {
  const Room* where = find_room(workspace_.scene(), room);
  const auto index = index_of(id);
  if (where == nullptr || !index || !workspace_.scene().nodes[*index].movable) {
    return fail(RejectionReason::CannotEnforce, id + " cannot be put on the floor of " + room);
  }
  if (!clear_off(id)) return false;
  Bounds area = room_bounds(*where, workspace_.scene().wall_height);
  area.low.head<2>().array() += kWallMargin_m;
  area.high.head<2>().array() -= kWallMargin_m;
  const Node object = workspace_.scene().nodes[*index_of(id)];
  const auto place = find_place_on_floor(workspace_, object, *index_of(id), area, {.draws = 2 * draws_}, next_rng());
  if (!place.pose) {
    return fail(RejectionReason::NoFreePlace, object.category + " on the floor of " + room + " " + place.obstacle);
  }
  return move_to(id, *place.pose);
}

bool SceneEditor::move_agent(const std::string& room, bool into) {
  const Scene& scene = workspace_.scene();
  const auto other = workspace_.other_grid();
  const NavigationGrid& grid = other ? *other : workspace_.home()->walk->grid;
  for (const Room& candidate : scene.rooms) {
    if ((candidate.id == room) != into) continue;
    const Bounds bounds = room_bounds(candidate, 0);
    const auto cell = grid.nearest_free(((bounds.low + bounds.high) / 2).head<2>());
    if (!cell || !contains(candidate.polygon, grid.center(*cell))) continue;
    workspace_.agent().position = grid.center(*cell);
    stale_ = true;
    return true;
  }
  return fail(RejectionReason::CannotEnforce,
              "the agent cannot start " + std::string(into ? "in " : "outside ") + room);
}

}  // namespace unietp
