#include "grounding/workspace.h"

#include <algorithm>
#include <utility>

#include "grounding/floor_plan.h"
#include "simulation/relations.h"
#include "simulation/shape.h"

namespace unietp {
bool allowed(const Knowledge& knowledge, const Node& object, Predicate relation, const Node& receptacle) {
  return knowledge.placement(object.category, relation == Predicate::Inside ? Predicate::Inside : Predicate::On,
                             receptacle.category) != nullptr;
}

Workspace::Workspace(Scene scene, const Knowledge& knowledge)
    : scene_(std::move(scene)), knowledge_(&knowledge), physics_(physics_of(scene_)) {
  set_walls(checker_, scene_);
  for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
    const Node& node = scene_.nodes[i];
    const Shape shape = shape_of(node);
    checker_.set(BodyId::node(i), shape, node.pose, node.opening);
    bounds_.push_back(bounds_of(shape, node.pose, node.opening));
    sweeps_.push_back(node.movable ? std::nullopt : sweep_of(node));
    farthest_sweep_ = std::max(farthest_sweep_, goes_beyond(sweeps_.back(), bounds_.back()));
    rooms_.push_back(room_number(physics_, node.pose.position.head<2>()));
  }
  places_ = NodeIndex(scene_.nodes);
}

Workspace::Workspace(const Home& home, const Knowledge& knowledge)
    : scene_(without_edges(home.scene)),
      knowledge_(&knowledge),
      home_(&home),
      physics_(home.physics),
      checker_(home.solids),
      sweeps_(home.sweeps),
      farthest_sweep_(home.farthest_sweep),
      bounds_(home.bounds),
      places_(home.places),
      rooms_(home.rooms),
      current_state_(home) {}

void Workspace::note(std::size_t index) {
  if (current_state_) current_state_->touch(scene_.nodes[index].id, physics_.bounds(BodyId::node(index)));
}

void Workspace::place(std::size_t index, Node node) {
  const Shape shape = shape_of(node);
  const auto body = BodyId::node(index);
  physics_.set(body, shape, node.pose, node.opening, node.mass);
  checker_.set(body, shape, node.pose, node.opening);
  bounds_.edit(index) = bounds_of(shape, node.pose, node.opening);
  sweeps_.edit(index) = node.movable ? std::nullopt : sweep_of(node);
  farthest_sweep_ = std::max(farthest_sweep_, goes_beyond(sweeps_[index], bounds_[index]));
  rooms_[index] = room_number(physics_, node.pose.position.head<2>());
  Node& here = scene_.nodes.edit(index);
  if (here.id != node.id || here.category != node.category) {
    places_.remove(index, here);
    places_.add(index, node);
  }
  here = std::move(node);
  moved_.push_back(index);
  note(index);
}

std::size_t Workspace::add(Node node) {
  const std::size_t index = scene_.nodes.size();
  scene_.nodes.emplace_back();
  sweeps_.emplace_back();
  bounds_.emplace_back();
  rooms_.emplace_back();
  place(index, std::move(node));
  return index;
}

void Workspace::replace(std::size_t index, Node node) {
  if (current_state_ && same_body(scene_.nodes[index], node)) {
    current_state_->touch(node.id);
    scene_.nodes.edit(index) = std::move(node);
    return;
  }
  note(index);
  place(index, std::move(node));
}

void Workspace::remove(std::size_t index) {
  const std::size_t last = scene_.nodes.size() - 1;
  note(index);
  Node moved = scene_.nodes[last];
  places_.remove(last, moved);
  if (index != last) place(index, std::move(moved));
  moved_.push_back(last);
  physics_.remove(BodyId::node(last));
  checker_.remove(BodyId::node(last));
  scene_.nodes.pop_back();
  sweeps_.pop_back();
  bounds_.pop_back();
  rooms_.pop_back();
}

void Workspace::read_edges() {
  ++reading_;
  if (current_state_) {
    current_state_->read(scene_, places_, physics_);
  } else {
    scene_.edges = read_relations(scene_, physics_);
  }
}

std::vector<std::string> Workspace::carried_by(std::size_t index) const {
  constexpr double kNear_m = 0.02;  // more than what counts as touching
  const FactReader& reader = current_state_->reader();
  const Facts& facts = current_state_->now().states.front();
  std::vector<std::size_t> found{index};
  for (std::size_t at = 0; at < found.size(); ++at) {
    const auto carrier = reader.find(scene_.nodes[found[at]].id);
    if (!carrier) continue;
    for (const BodyId body : physics_.near(physics_.bounds(BodyId::node(found[at])), kNear_m)) {
      if (!body.is_node()) continue;
      const std::size_t near = body.index();
      if (std::find(found.begin(), found.end(), near) != found.end()) continue;
      const auto thing = reader.find(scene_.nodes[near].id);
      const bool rests =
          thing && (facts.holds(Predicate::On, *thing, *carrier) || facts.holds(Predicate::Inside, *thing, *carrier));
      if (rests) found.push_back(near);
    }
  }
  found.erase(found.begin());
  std::sort(found.begin(), found.end());
  std::vector<std::string> ids;
  for (const std::size_t i : found) ids.push_back(scene_.nodes[i].id);
  return ids;
}

Delta Workspace::changes() const {
  Delta changes;
  std::vector<std::size_t> gone;
  for (const std::string& id : current_state_->ever_touched()) {
    const auto place = places_.find(id), before = home_->places.find(id);
    if (place && !(before && home_->scene.nodes[*before] == scene_.nodes[*place]))
      changes.nodes.push_back(scene_.nodes[*place]);
    if (!place && before) gone.push_back(*before);
  }
  std::sort(gone.begin(), gone.end());
  for (const std::size_t i : gone) changes.removed.push_back(home_->scene.nodes[i].id);
  EdgeChange edges = current_state_->since_home();
  changes.edges_added = std::move(edges.added);
  changes.edges_removed = std::move(edges.removed);
  if (scene_.agent != home_->scene.agent) changes.agent = scene_.agent;
  return changes;
}

const Room* Workspace::room_of(std::size_t index) const {
  return rooms_[index] < 0 ? nullptr : &scene_.rooms[static_cast<std::size_t>(rooms_[index])];
}

std::vector<std::size_t> Workspace::nodes_in(std::size_t room) const {
  constexpr double kAbove_m = 1;  // the walls
  std::vector<std::size_t> nodes;
  for (const BodyId body : physics_.near(room_bounds(scene_.rooms[room], scene_.wall_height), kAbove_m)) {
    const std::size_t i = body.index();
    if (body.is_node() && i < rooms_.size() && rooms_[i] == static_cast<std::int32_t>(room)) nodes.push_back(i);
  }
  return nodes;
}

std::vector<std::size_t> Workspace::nodes_in(const std::vector<bool>& rooms) const {
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    if (rooms_[i] < 0 ? rooms.back() : rooms[static_cast<std::size_t>(rooms_[i])]) nodes.push_back(i);
  }
  return nodes;
}

std::string Workspace::name_of(BodyId body) const {
  if (body.is_node()) return scene_.nodes[body.index()].id;
  return body == kFloor ? "the floor" : "a wall";
}

TrialNode::TrialNode(Workspace& workspace, Node node, std::size_t index)
    : workspace_(workspace), index_(index), shape_(shape_of(node)) {
  workspace_.physics_.set(body(), shape_, node.pose, node.opening, node.mass);
  auto& nodes = workspace_.scene_.nodes;
  if (index == nodes.size()) {
    nodes.push_back(std::move(node));
  } else {
    before_ = std::exchange(nodes.edit(index), std::move(node));
  }
}

TrialNode::~TrialNode() {
  auto& nodes = workspace_.scene_.nodes;
  if (!before_) {
    workspace_.physics_.remove(body());
    nodes.pop_back();
    return;
  }
  workspace_.physics_.set(body(), shape_of(*before_), before_->pose, before_->opening, before_->mass);
  nodes.edit(index_) = std::move(*before_);
}

void TrialNode::move(const Pose& pose) {
  workspace_.physics_.move(body(), pose);
  workspace_.scene_.nodes.edit(index_).pose = pose;
}

}  // namespace unietp
