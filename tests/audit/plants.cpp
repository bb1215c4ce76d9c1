#include <algorithm>

#include "core/text.h"
#include "planted_set.h"
#include "scene/telling_order.h"

namespace unietp::testing {
namespace {

using On = Plant::On;

Scene& scene_of(MadeTask& made) { return made.task.start; }
Node& node_of(MadeTask& made, const std::string& id) { return *edit_node(made.task.start, id); }

/// The order in which a home is told is drawn from its name: another name, by which the order fits.
template <class Fits>
void name_so_that(MadeTask& made, const Fits& fits) {
  Scene& scene = scene_of(made);
  const std::string name = scene.id;
  for (int i = 0;; ++i) {
    scene.id = name + "-" + std::to_string(i);
    if (fits(telling_order(scene))) return;
  }
}
void to_end(MadeTask& made, const std::string& id, Rng&) {
  name_so_that(made, [&](const TellingOrder& order) { return scene_of(made).nodes[order.nodes.back()].id == id; });
}
void to_front(MadeTask& made, const std::string& id, Rng&) {
  name_so_that(made, [&](const TellingOrder& order) { return scene_of(made).nodes[order.nodes.front()].id == id; });
}

void rename(std::string& id, const std::string& from, const std::string& to) {
  if (id == from) id = to;
}

/// A new id wherever the old one stands.
void rename_in(MadeTask& made, const std::string& from, const std::string& to) {
  node_of(made, from).id = to;
  std::vector<Edge> edges(scene_of(made).edges.begin(), scene_of(made).edges.end());
  for (Edge& edge : edges) rename(edge.from, from, to), rename(edge.to, from, to);
  scene_of(made).edges = EdgeSet(edges);
  for (auto& [mode, shown] : made.task.shown) {
    for (StepRecord& step : shown.steps) {
      for (VisibleObject& seen : step.visible) rename(seen.id, from, to);
      for (Argument& argument : step.command.args) rename(argument.id, from, to);
    }
  }
  rename(made.small_thing, from, to), rename(made.furniture, from, to);
  for (auto& id : made.kind) rename(id, from, to);
}
void number_9(MadeTask& made, const std::string& id, Rng&) { rename_in(made, id, id.substr(0, id.find('_')) + "_9"); }
void number_0(MadeTask& made, const std::string& id, Rng&) { rename_in(made, id, id.substr(0, id.find('_')) + "_0"); }

/// More things like this one, of its sort and kind, which bear its relations.
void add_alike(MadeTask& made, const std::string& id, int count) {
  const Node node = node_of(made, id);
  std::vector<Edge> edges(scene_of(made).edges.begin(), scene_of(made).edges.end());
  const auto own = edges;
  for (int i = 0; i < count; ++i) {
    Node more = node;
    more.id += "0" + std::to_string(i + 1);
    more.color = "blue";
    for (Edge edge : own) {
      if (edge.from != id) continue;
      edge.from = more.id;
      edges.push_back(edge);
    }
    scene_of(made).nodes.push_back(more);
  }
  scene_of(made).edges = EdgeSet(edges);
}
void five_more(MadeTask& made, const std::string& id, Rng&) { add_alike(made, id, 5); }

/// The thing becomes the only one of its kind, and of other kinds there are several.
void the_only_one(MadeTask& made, const std::string& id, Rng&) {
  const std::string kind = node_of(made, id).category;
  std::vector<std::string> firsts;
  std::vector<std::string> seen;
  for (const Node& node : scene_of(made).nodes) {
    if (node.category == kind || std::find(seen.begin(), seen.end(), node.category) != seen.end()) continue;
    seen.push_back(node.category);
    firsts.push_back(node.id);
  }
  for (const auto& first : firsts) add_alike(made, first, 1);
  erase_if(scene_of(made).nodes, [&](const Node& node) { return node.category == kind && node.id != id; });
}

void odd_kind(MadeTask& made, const std::string& id, Rng&) {
  const std::string from = node_of(made, id).category, to = from + "Of" + made.task.record.id;
  for (std::size_t i = 0; i < scene_of(made).nodes.size(); ++i) {
    Node& node = scene_of(made).nodes.edit(i);
    if (node.category == from) node.category = to;
  }
  Formula& goal = made.task.record.goal_tree;
  goal = substitute_names(goal, {{from, {to}}});
}

void broken(MadeTask& made, const std::string& id, Rng&) { node_of(made, id).states.set({Predicate::Broken, ""}); }
void only_dirty(MadeTask& made, const std::string& id, Rng&) {
  for (const auto& other : made.kind) node_of(made, other).states.set({Predicate::Clean, ""});
  node_of(made, id).states.set({Predicate::Dirty, ""});
}
void with_model(MadeTask& made, const std::string& id, Rng&) { node_of(made, id).asset = "model"; }

void relate(MadeTask& made, Edge edge) {
  std::vector<Edge> edges(scene_of(made).edges.begin(), scene_of(made).edges.end());
  std::erase_if(edges, [&](const Edge& old) {
    return old.from == edge.from && (old.relation == Predicate::InRoom) == (edge.relation == Predicate::InRoom);
  });
  edges.push_back(edge);
  scene_of(made).edges = EdgeSet(edges);
}
void in_a_box(MadeTask& made, const std::string& id, Rng&) {
  const auto& nodes = scene_of(made).nodes;
  const auto box = std::find_if(nodes.begin(), nodes.end(),
                                [&](const Node& node) { return node.category == "Box" && node.id != id; });
  if (box != nodes.end()) relate(made, {Predicate::Inside, id, box->id});
}
void in_the_garage(MadeTask& made, const std::string& id, Rng&) {
  scene_of(made).rooms.push_back({"garage_1", "garage", {{16, 0}, {20, 0}, {20, 4}, {16, 4}}});
  relate(made, {Predicate::InRoom, id, "garage_1"});
}
void at_the_start(MadeTask& made, const std::string& id, Rng&) {
  scene_of(made).agent.position = node_of(made, id).pose.position.head<2>();
}

/// The instruction tells apart the highest number from the lowest.
void name_number(MadeTask& made, const std::string& id, Rng& rng) {
  const bool high = rng.chance(0.5);
  made.task.record.instruction += high ? " at last" : " please";
  high ? number_9(made, id, rng) : number_0(made, id, rng);
}

std::string room_of(MadeTask& made, const std::string& id) {
  for (const Edge& edge : scene_of(made).edges) {
    if (edge.from == id && edge.relation == Predicate::InRoom) return edge.to;
  }
  return "";
}
void put_room_first(MadeTask& made, const std::string& id) {
  name_so_that(made, [&](const TellingOrder& order) { return scene_of(made).rooms[order.rooms.front()].id == id; });
}
void room_first(MadeTask& made, const std::string& id, Rng&) { put_room_first(made, room_of(made, id)); }
void room_last(MadeTask& made, const std::string& id, Rng&) {
  const std::string room = room_of(made, id);
  name_so_that(made, [&](const TellingOrder& order) { return scene_of(made).rooms[order.rooms.back()].id == room; });
}
/// In one of the kitchens, which becomes the first of the rooms.
void in_the_first_kitchen(MadeTask& made, const std::string& id, Rng& rng) {
  const std::string kitchen = "kitchen_" + std::to_string(1 + rng.below(2));
  relate(made, {Predicate::InRoom, id, kitchen});
  put_room_first(made, kitchen);
}

/// Puts the thing into the first picture in some way.
template <class Change>
void change_view(MadeTask& made, const std::string& id, const Change& change) {
  for (auto& [mode, shown] : made.task.shown) {
    auto& seen = shown.steps.front().visible;
    std::erase_if(seen, [&](const VisibleObject& object) { return object.id == id; });
    change(seen);
  }
}
void seen_first(MadeTask& made, const std::string& id, Rng&) {
  change_view(made, id, [&](auto& seen) { seen.insert(seen.begin(), {id, {10, 10, 60, 60}}); });
}
void seen_last(MadeTask& made, const std::string& id, Rng&) {
  change_view(made, id, [&](auto& seen) { seen.push_back({id, {10, 10, 60, 60}}); });
}
void seen_large(MadeTask& made, const std::string& id, Rng& rng) {
  change_view(made, id, [&](auto& seen) {
    seen.insert(seen.begin() + static_cast<std::ptrdiff_t>(rng.below(seen.size())), {id, {0, 0, 400, 400}});
  });
}
void seen_low(MadeTask& made, const std::string& id, Rng& rng) {
  change_view(made, id, [&](auto& seen) {
    seen.insert(seen.begin() + static_cast<std::ptrdiff_t>(rng.below(seen.size())), {id, {9, 505, 29, 511}});
  });
}

void begin_with(MadeTask& made, const std::string& id) {
  for (auto& [mode, shown] : made.task.shown) shown.steps.front().command = {"go_to", {{id, {}}}};
}
template <class Which>
std::string last_listed(MadeTask& made, const Which& which) {
  std::string last;
  for (const std::size_t i : telling_order(scene_of(made)).nodes) {
    if (which(scene_of(made).nodes[i])) last = scene_of(made).nodes[i].id;
  }
  return last;
}
void begin_with_last(MadeTask& made, const std::string&, Rng&) {
  begin_with(made, last_listed(made, [](const Node& node) { return !node.movable; }));
}
void begin_with_last_cabinet(MadeTask& made, const std::string&, Rng&) {
  begin_with(made, last_listed(made, [](const Node& node) { return node.category == "Cabinet"; }));
}

}  // namespace

const std::vector<Plant>& plants() {
  static const std::vector<Plant> all{
      {"last-listed", On::SmallThing, to_end},
      {"first-listed", On::SmallThing, to_front},
      {"highest-number", On::SmallThing, number_9},
      {"rarest-kind", On::SmallThing, the_only_one},
      {"commonest-kind", On::SmallThing, five_more},
      {"more-than-elsewhere", On::SmallThing, five_more},
      {"fewer-than-elsewhere", On::SmallThing, the_only_one},
      {"kind-of-no-other-home", On::SmallThing, odd_kind},
      {"unusual-state", On::SmallThing, broken},
      {"unusual-place", On::SmallThing, in_a_box},
      {"unusual-room", On::SmallThing, in_the_garage},
      {"unusual-model", On::SmallThing, with_model},
      {"nearest-to-start", On::SmallThing, at_the_start},
      {"named-then-last", On::OfKind, to_end},
      {"named-then-first", On::OfKind, to_front},
      {"goal-of-template", On::OfKind, to_end},
      {"usual-goal", On::OfKind, to_end},
      {"list-classifier", On::SmallThing, to_end},
      {"last-furniture", On::Furniture, to_end},
      {"first-furniture", On::Furniture, to_front},
      {"furniture-of-no-other-home", On::Furniture, odd_kind},
      {"more-furniture-than-elsewhere", On::Furniture, five_more},
      {"furniture-in-unusual-room", On::Furniture, in_the_garage},
      {"unusual-furniture-model", On::Furniture, with_model},
      {"unusual-furniture-state", On::Furniture, broken},
      {"named-furniture-then-last", On::OfKind, to_end},
      {"lowest-number-of-kind", On::OfKind, number_0},
      {"highest-number-of-kind", On::OfKind, number_9},
      {"first-of-kind", On::OfKind, to_front},
      {"last-of-kind", On::OfKind, to_end},
      {"nearest-of-kind", On::OfKind, at_the_start},
      {"only-one-in-its-state", On::OfKind, only_dirty},
      {"unusual-state-of-kind", On::OfKind, broken},
      {"unusual-place-of-kind", On::OfKind, in_a_box},
      {"unusual-model-of-kind", On::OfKind, with_model},
      {"nearest-instruction", On::OfKind, name_number},
      {"text-classifier", On::OfKind, name_number},
      {"kind-classifier", On::OfKind, number_9},
      {"first-room", On::SmallThing, room_first},
      {"last-room", On::SmallThing, room_last},
      {"room-of-start", On::SmallThing, at_the_start},
      {"usual-room", On::SmallThing, in_the_first_kitchen},
      {"first-in-view", On::SmallThing, seen_first},
      {"last-in-view", On::SmallThing, seen_last},
      {"largest-in-view", On::SmallThing, seen_large},
      {"lowest-in-view", On::SmallThing, seen_low},
      {"usual-first-object", On::Furniture, begin_with_last_cabinet},
      {"first-object-last-listed", On::Furniture, begin_with_last},
  };
  return all;
}

}  // namespace unietp::testing
