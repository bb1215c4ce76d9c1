#include <algorithm>
#include <array>

#include "akb/knowledge.h"
#include "grounding/make_node.h"
#include "grounding/place_object.h"
#include "grounding/scene_editor.h"
#include "grounding/small_objects.h"
#include "scene/size_and_nearness.h"
#include "scene/trace.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

constexpr double kBeside_m = 0.15;  // less than kNextTo_m of simulation/relations.h
constexpr std::size_t kNearHosts = 8;
constexpr int kPosesAHost = 3;
/// Of what has no models: shares of the typical box, in each direction. `usable` of akb/fit.h allows as much.
constexpr std::array kScales = {0.8, 0.87, 0.93, 1.0, 1.07, 1.15};
constexpr double kSmallestHolder = 0.9;

struct SizeChoice {
  Vec3 size;
  std::string asset;
};

std::vector<SizeChoice> boxes_of(const Category& category, const Knowledge& knowledge) {
  std::vector<SizeChoice> boxes;
  for (const Asset* asset : usable_assets(knowledge, category)) boxes.push_back({asset->size, asset->name});
  if (!boxes.empty()) return boxes;
  const bool holds = knowledge.has(category.name, "receptacle") || knowledge.has(category.name, "container");
  for (const double scale : kScales) {
    if (!holds || scale >= kSmallestHolder) boxes.push_back({category.size * scale, ""});
  }
  return boxes;
}

}  // namespace

bool SceneEditor::give_box(const std::string& id, const Vec3& size, const std::string& asset) {
  const Node before = workspace_.scene().nodes[*index_of(id)];
  const Category* category = workspace_.knowledge().find(before.category);
  if (category == nullptr || !before.movable || !before.boards.empty()) {
    return fail(RejectionReason::CannotEnforce, id + " cannot be had larger or smaller");
  }
  if (!clear_off(id)) return false;
  refresh();
  for (const Edge& edge : workspace_.current_state().edges_from(id)) {
    const bool holds = edge.relation == Predicate::On || edge.relation == Predicate::Inside;
    if (!holds || !index_of(edge.to)) continue;
    Node after = before;
    after.size = size;
    after.asset = asset;
    after.mass = category->mass * size.prod() / category->size.prod();
    const auto found =
        find_place(workspace_, after, *index_of(id), edge.relation, *index_of(edge.to), {.draws = draws_}, next_rng());
    if (!found.pose) continue;
    after.pose = *found.pose;
    workspace_.replace(*index_of(id), std::move(after));
    touched_.insert(id);
    stale_ = true;
    return true;
  }
  return fail(RejectionReason::NoFreePlace, before.category + " of another size finds no place where it was");
}

bool SceneEditor::resize(const std::string& id, const std::string& size, bool truth) {
  const std::string name = workspace_.scene().nodes[*index_of(id)].category;
  const Category* category = workspace_.knowledge().find(name);
  if (category == nullptr) return fail(RejectionReason::UnknownCategory, "the knowledge base has no category " + name);
  const auto volume_of = [&](const std::string& other) {
    return workspace_.scene().nodes[*index_of(other)].size.prod();
  };
  std::vector<std::string> rivals;
  for (const std::size_t i : workspace_.places().of(name)) {
    const Node& other = workspace_.scene().nodes[i];
    if (other.id != id) rivals.push_back(other.id);
  }
  auto boxes = boxes_of(*category, workspace_.knowledge());
  std::stable_sort(boxes.begin(), boxes.end(), [&](const SizeChoice& a, const SizeChoice& b) {
    return size == "large" ? a.size.prod() > b.size.prod() : a.size.prod() < b.size.prod();
  });
  const auto clear = [&](double own, double other) {
    return size == "large" ? own >= kClearlyLarger * other : kClearlyLarger * own <= other;
  };
  const auto says = std::string(truth ? " " : " not ") + size;
  // The most of it first, or, where it is not to be, the least; then the others the other way, where they are in its
  // way.
  const SizeChoice& own = truth ? boxes.front() : boxes.back();
  const SizeChoice& other_way = truth ? boxes.back() : boxes.front();
  if (rivals.empty() || !give_box(id, own.size, own.asset)) {
    return fail(RejectionReason::StateNotPossible, name + " cannot be" + says + " there");
  }
  for (const std::string& rival : rivals) {
    if (!truth || clear(own.size.prod(), volume_of(rival))) continue;
    if (!clear(own.size.prod(), other_way.size.prod()) || !give_box(rival, other_way.size, other_way.asset)) {
      return fail(RejectionReason::StateNotPossible, name + " cannot be" + says + " beside " + rival);
    }
  }
  return true;
}

bool SceneEditor::bring_near(const std::string& id, const std::string& other) {
  const auto index = index_of(id), target = index_of(other);
  if (!index || !target || id == other || !workspace_.scene().nodes[*index].movable) {
    return fail(RejectionReason::CannotEnforce, id + " cannot be brought near to " + other);
  }
  if (!clear_off(id)) return false;
  const Vec3 aim = workspace_.scene().nodes[*index_of(other)].pose.position;
  const auto away = [&](const Node& node) { return (node.pose.position - aim).norm(); };
  const Node node = workspace_.scene().nodes[*index_of(id)];
  std::optional<double> rival;
  for (const std::size_t i : workspace_.places().of(node.category)) {
    const Node& one = workspace_.scene().nodes[i];
    if (one.id == id || one.id == other) continue;
    rival = std::min(rival.value_or(away(one)), away(one));
  }
  auto hosts = hosts_for(workspace_, node);
  const auto avoided = avoid_.find(node.category);
  std::erase_if(hosts, [&](const Host& host) {
    const Node& there = workspace_.scene().nodes[host.node];
    const bool shut = host.relation == Predicate::Inside && there.openable && there.opening < 0.5;
    return shut || there.movable || (avoided != avoid_.end() && avoided->second.contains(there.category));
  });
  const auto distance = [&](const Host& host) { return away(workspace_.scene().nodes[host.node]); };
  std::stable_sort(hosts.begin(), hosts.end(), [&](const Host& a, const Host& b) { return distance(a) < distance(b); });
  if (hosts.size() > kNearHosts) hosts.resize(kNearHosts);
  for (const Host& host : hosts) {
    for (int tried = 0; tried < kPosesAHost; ++tried) {
      const auto place =
          find_place(workspace_, node, *index_of(id), host.relation, host.node, {.draws = draws_ / 2}, next_rng());
      if (!place.pose) break;
      if (rival && !clearly_nearer((place.pose->position - aim).norm(), *rival)) continue;
      return move_to(id, *place.pose);
    }
  }
  return fail(RejectionReason::NoFreePlace, node.category + " finds no place that is clearly the nearest to " + other);
}

bool SceneEditor::place_near(const std::string& id, const std::string& other) {
  refresh();
  const Node object = workspace_.scene().nodes[*index_of(id)];
  const Node beside = workspace_.scene().nodes[*index_of(other)];
  const auto around = [&](double gap) {
    Bounds area = bounds_of(beside.pose, beside.size);
    area.low.head<2>().array() -= gap;
    area.high.head<2>().array() += gap;
    return area;
  };
  for (const Edge& edge : workspace_.current_state().edges_from(other)) {
    if (edge.relation != Predicate::On && edge.relation != Predicate::Inside) continue;
    const auto host = index_of(edge.to);
    if (!host) continue;
    const auto place = find_place(workspace_, object, *index_of(id), edge.relation, *host,
                                  {.draws = 4 * draws_, .within = around(kBeside_m)}, next_rng());
    if (!place.pose) continue;
    return move_to(id, *place.pose);
  }
  if (bounds_of(beside.pose, beside.size).low.z() < kTouch_m) {
    const Bounds area = around(kBeside_m + object.size.head<2>().maxCoeff());
    const auto place = find_place_on_floor(workspace_, object, *index_of(id), area, {.draws = 2 * draws_}, next_rng());
    if (place.pose) {
      return move_to(id, *place.pose);
    }
  }
  return fail(RejectionReason::NoFreePlace, object.category + " finds no place next to " + other);
}

}  // namespace unietp
