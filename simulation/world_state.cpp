#include "simulation/world_state.h"

#include <algorithm>
#include <map>
#include <utility>

#include "simulation/agent_moves.h"

namespace unietp {

Result<WorldState> WorldState::of(Scene start, const Knowledge& knowledge, const Profile& profile, KnownStart known) {
  WorldState state;
  state.knowledge = &knowledge;
  state.profile = &profile;
  state.physics_ = std::move(known.physics);
  if (known.walk != nullptr) {
    state.grid_ = known.walk->grid;
    state.floods_ = FloodCache(std::move(known.walk));
  }
  const EdgeSet edges = std::exchange(start.edges, {});
  state.scene_ = std::move(start);
  const std::size_t count = state.count();
  state.places_ = std::move(*known.places);
  if (known.colliders) {
    state.colliders_ = std::move(*known.colliders);
  } else {
    for (std::size_t i = 0; i < count; ++i) state.colliders_.push_back(state.physics_.share(BodyId::node(i)));
  }
  for (const std::string& id : state.agent().held) {
    if (!state.index_of(id))
      return Error{Error::Kind::Schema, state.scene_.id, {}, "the agent holds " + id + ", which does not exist"};
  }
  if (known.links) {
    state.links_ = std::move(*known.links);
  } else {
    state.read_links(edges);
  }
  // Attachment is stored in the edges only.
  const auto attached = edges.partition_point([](const Edge& edge) { return edge.relation < Predicate::Attached; });
  for (auto place = attached; place != edges.end() && place->relation == Predicate::Attached; ++place) {
    const Edge& edge = *place;
    const auto from = state.index_of(edge.from), to = state.index_of(edge.to);
    if (from && to && state.linked(*from, Predicate::On, *to))
      state.add_link(*from, {edge.relation, static_cast<std::uint32_t>(*to)});
  }
  return state;
}

/// All links from physics, and those of what the agent carries from the edges.
void WorldState::read_links(const EdgeSet& edges) {
  links_.resize(count());
  std::vector<std::size_t> in_hand;
  if (!agent().held.empty()) {
    for (const Edge& edge : edges) {
      if (edge.relation != Predicate::On && edge.relation != Predicate::Inside) continue;
      const auto from = index_of(edge.from), to = index_of(edge.to);
      // What is fixed is carried by nothing, even where a hand is held under it.
      if (from && to && node(*from).movable) add_link(*from, {edge.relation, static_cast<std::uint32_t>(*to)});
    }
    in_hand = this->in_hand();
    for (const std::size_t i : in_hand) physics_.remove(BodyId::node(i));
  }
  const auto held = [&](std::size_t i) { return std::binary_search(in_hand.begin(), in_hand.end(), i); };
  for (std::size_t i = 0; i < count(); ++i) {
    std::vector<Link> links = links_of(scene_, physics_, i);
    for (const Link& link : links_.of(i)) {
      if (held(i) && held(link.to)) links.push_back(link);
    }
    sort_unique(links);
    links_.set(i, std::move(links));
  }
}

void WorldState::add_link(std::size_t i, const Link& link) {
  std::vector<Link> links = links_.of(i);
  links.push_back(link);
  sort_unique(links);
  links_.set(i, std::move(links));
}

void WorldState::append(Node node, std::shared_ptr<const Collider> collider) {
  places_.add(count(), node);
  colliders_.push_back(std::move(collider));
  links_.resize(count() + 1);
  scene_.nodes.push_back(std::move(node));
}

bool WorldState::held(std::string_view id) const {
  const auto& held = agent().held;
  return std::find(held.begin(), held.end(), id) != held.end();
}

bool WorldState::linked(std::size_t from, Predicate relation, std::size_t to) const {
  const Link link{relation, static_cast<std::uint32_t>(to)};
  return std::binary_search(links(from).begin(), links(from).end(), link);
}

std::optional<std::size_t> WorldState::closed_around(std::size_t i) const {
  std::optional<std::size_t> outermost;
  for (const Link& link : links(i)) {
    if (link.relation != Predicate::Inside) continue;
    const Node& container = node(link.to);
    if (!container.openable || container.states.has(Predicate::Open)) continue;
    if (!outermost || container.size.prod() > node(*outermost).size.prod()) outermost = link.to;
  }
  return outermost;
}

std::vector<std::size_t> WorldState::group_of(std::size_t i) const {
  std::vector<std::size_t> group{i};
  for (std::size_t at = 0; at < group.size(); ++at) {
    for (const std::uint32_t rider : carried(group[at])) {
      if (std::find(group.begin(), group.end(), rider) == group.end()) group.push_back(rider);
    }
  }
  std::sort(group.begin() + 1, group.end());
  return group;
}

FailureReference WorldState::reference(std::size_t i) const {
  const Category* category = knowledge->find(node(i).category);
  return {node(i).id, "the " + (category != nullptr ? category->display : "object")};
}

FailureReference WorldState::reference_to_body(BodyId body) const {
  if (body.is_node()) return reference(body.index());
  return in_words(body == kFloor ? "the floor" : "a wall");
}

std::vector<std::size_t> WorldState::in_hand() const {
  std::vector<std::size_t> all;
  for (const std::string& id : agent().held) {
    if (const auto i = index_of(id)) {
      const auto group = group_of(*i);
      all.insert(all.end(), group.begin(), group.end());
    }
  }
  sort_unique(all);
  return all;
}

ViewedScene WorldState::viewed() const {
  const auto hidden = [this, hand = in_hand()](std::size_t i) {
    return std::binary_search(hand.begin(), hand.end(), i) || closed_around(i).has_value();
  };
  const auto near = [this](const Bounds& bounds) {
    std::vector<std::size_t> nodes;
    for (const BodyId body : physics_.near(bounds, 0)) {
      if (body.is_node()) nodes.push_back(body.index());
    }
    return nodes;
  };
  return {scene_, hidden, near};
}

Scene WorldState::whole_scene() const {
  Scene scene = scene_;
  scene.edges = links_.edges(scene);
  return scene;
}

std::optional<ActionResult> access_failure(const WorldState& state, std::size_t node) {
  return access_failure(state, node, state.agent().position);
}

std::optional<ActionResult> access_failure(const WorldState& state, std::size_t node, const Vec2& place) {
  if (const auto container = state.closed_around(node)) {
    return failed(FailureCause::InsideClosed, state.reference(node), state.reference(*container));
  }
  if (reach_distance(state.node(node), place, *state.profile) > state.profile->reach_m) {
    return failed(FailureCause::OutOfReach, state.reference(node));
  }
  if (!sees(state.scene(), state.physics(), *state.profile, place, node)) {
    return failed(FailureCause::OutOfSight, state.reference(node));
  }
  return std::nullopt;
}

void look_at(WorldState& state, const Vec3& point) {
  Agent& agent = state.edit_agent();
  agent = facing(agent, point, *state.profile);
}

}  // namespace unietp
