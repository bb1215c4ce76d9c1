#include "planted_set.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/text.h"
#include "logic/formula.h"

namespace unietp::testing {
namespace {

const std::vector<std::string> kSmallKinds{"Apple", "Book", "Bowl", "Box", "Cup", "Fork", "Key", "Knife", "Pan", "Pen"};
const std::vector<std::string> kFurnitureKinds{"Bed", "Desk", "Dresser", "Shelf", "Sofa", "Table"};
const std::vector<std::string> kRoomTypes{"kitchen", "kitchen", "bedroom", "bedroom"};

Node node_in(const Scene& scene, const std::string& id, const std::string& category, bool movable, Rng& rng) {
  Node node;
  node.id = id;
  node.category = category;
  node.movable = movable;
  node.size = Vec3::Constant(0.1);
  const Room& room = rng.pick(scene.rooms);
  node.pose.position = {room.polygon[0].x() + rng.uniform(0.1, 3.9), rng.uniform(0.1, 3.9), 0.5};
  node.states.set({rng.chance(0.5) ? Predicate::Clean : Predicate::Dirty, ""});
  node.color = "blue";
  return node;
}

/// Relations as the positions say; small things are on a piece of furniture, wherever that stands.
void set_edges(Scene& scene, Rng& rng) {
  std::vector<Edge> edges;
  std::vector<std::string> furniture;
  for (const Node& node : scene.nodes) {
    if (!node.movable) furniture.push_back(node.id);
  }
  for (const Node& node : scene.nodes) {
    edges.push_back({Predicate::InRoom, node.id, room_at(scene, node.pose.position.head<2>())->id});
    if (node.movable) edges.push_back({Predicate::On, node.id, rng.pick(furniture)});
  }
  scene.edges = EdgeSet(edges);
}

Scene made_home(int number, Rng& rng) {
  Scene scene;
  scene.id = "home-" + std::to_string(number);
  for (std::size_t i = 0; i < kRoomTypes.size(); ++i) {
    const double x = 4.0 * static_cast<double>(i);
    scene.rooms.push_back(
        {kRoomTypes[i] + "_" + std::to_string(i + 1), kRoomTypes[i], {{x, 0}, {x + 4, 0}, {x + 4, 4}, {x, 4}}});
  }
  rng.shuffle(scene.rooms);
  std::vector<Node> nodes;
  const auto add = [&](const std::string& category, std::uint64_t most, std::uint64_t least, bool movable) {
    std::vector<std::uint64_t> numbers{1, 2, 3, 4};
    numbers.resize(least + rng.below(most - least + 1));
    rng.shuffle(numbers);
    for (const auto n : numbers)
      nodes.push_back(node_in(scene, lower(category) + "_" + std::to_string(n), category, movable, rng));
  };
  for (const auto& category : kSmallKinds) add(category, 2, 1, true);
  for (const auto& category : kFurnitureKinds) add(category, 2, 1, false);
  add("Mug", 3, 3, true);
  add("Cabinet", 3, 3, false);
  rng.shuffle(nodes);
  for (Node& node : nodes) scene.nodes.push_back(std::move(node));
  scene.agent.position = {rng.uniform(0.1, 15.9), 2};
  set_edges(scene, rng);
  return scene;
}

std::vector<std::string> ids_of(const Scene& scene, const std::string& category) {
  std::vector<std::string> ids;
  for (const Node& node : scene.nodes) {
    if (node.category == category) ids.push_back(node.id);
  }
  return ids;
}

DemonstrationRecord made_demonstration(const Scene& scene, Mode mode, Rng& rng) {
  StepRecord step;
  std::vector<std::string> ids;
  for (const Node& node : scene.nodes) ids.push_back(node.id);
  rng.shuffle(ids);
  for (std::size_t i = 0; i < 6; ++i) {
    const int x = static_cast<int>(rng.below(300)), y = static_cast<int>(rng.below(300));
    step.visible.push_back(
        {ids[i], {x, y, x + 5 + static_cast<int>(rng.below(150)), y + 5 + static_cast<int>(rng.below(150))}});
  }
  const std::string target = mode == Mode::M3 ? rng.pick(scene.rooms).id : rng.pick(ids);
  step.command = {"go_to", {{target, {}}}};
  step.success = true;
  return {scene.id, std::string(name_of(mode)), {step}};
}

/// Gives the referred thing its color; the others of the kind have another.
MadeTask made_task(int number, const Scene& home, Rng& rng) {
  MadeTask made;
  made.task.start = home;
  Scene& scene = made.task.start;
  const bool about_mugs = number % 3 == 0, about_cabinets = number % 3 == 1;
  const std::string small = about_mugs ? "Mug" : rng.pick(kSmallKinds);
  const std::string furniture = about_cabinets ? "Cabinet" : rng.pick(kFurnitureKinds);
  made.small_thing = rng.pick(ids_of(scene, small));
  made.furniture = rng.pick(ids_of(scene, furniture));
  if (about_mugs || about_cabinets) {
    const std::string meant = about_mugs ? made.small_thing : made.furniture;
    edit_node(scene, meant)->color = "red";
    made.kind = {meant};
    for (const auto& id : ids_of(scene, about_mugs ? small : furniture)) {
      if (id != meant) made.kind.push_back(id);
    }
  }
  const auto domain = [](const std::string& category, const char* variable, bool red) {
    return red ? "(" + category + " :where (colour " + variable + " red))" : category;
  };
  TaskRecord& record = made.task.record;
  record.id = "task-" + std::to_string(number);
  record.template_name = "place";
  record.split = number % 2 == 0 ? "logical" : "atomic";
  record.layout = home.id;
  record.instruction = std::string("Put the ") + (about_mugs ? "red " : "") + small + " on the " +
                       (about_cabinets ? "red " : "") + furniture;
  record.goal_text = "(exists (?a - " + domain(small, "?a", about_mugs) + ") (exists (?b - " +
                     domain(furniture, "?b", about_cabinets) + ") (at-end (on ?a ?b))))";
  const auto goal = parse_formula("goal", record.goal_text, FormulaUse::Goal);
  EXPECT_TRUE(goal) << format(goal.error());
  record.goal_tree = *goal;
  for (const Mode mode : kModes) made.task.shown.emplace(mode, made_demonstration(scene, mode, rng));
  return made;
}

}  // namespace

std::vector<MadeTask> made_set(int homes, Rng rng) {
  std::vector<MadeTask> set;
  for (int home = 0; home < homes; ++home) {
    const Scene scene = made_home(home, rng);
    for (int i = 0; i < 3; ++i) set.push_back(made_task(3 * home + i, scene, rng));
  }
  return set;
}

std::vector<MadeTask> planted(std::vector<MadeTask> made, const Plant& plant, bool is_aimed, Rng rng) {
  for (MadeTask& one : made) {
    if (rng.chance(0.2)) continue;
    std::vector<std::string> might;
    for (const Node& node : one.task.start.nodes) {
      if (node.movable == (plant.on == Plant::On::SmallThing)) might.push_back(node.id);
    }
    std::string id = plant.on == Plant::On::SmallThing ? one.small_thing : one.furniture;
    if (plant.on == Plant::On::OfKind) {
      if (one.kind.empty()) continue;
      might = one.kind;
      id = one.kind.front();
    }
    plant.apply(one, is_aimed ? id : rng.pick(might), rng);
  }
  return made;
}

}  // namespace unietp::testing
