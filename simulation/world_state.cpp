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
  state.grid_ = std::move(known.grid);
  const std::vector<Edge> edges = std::exchange(start.edges, {});
  state.scene_ = std::move(start);
  const std::size_t count = state.count();
  state.places_ = known.places ? std::move(*known.places) : NodeIndex(state.scene_.nodes);
  state.colliders_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) state.colliders_.push_back(state.physics_.share(static_cast<BodyId>(i)));
  state.links_.resize(count);
  state.carried_.resize(count);

  std::vector<std::size_t> held;
  for (const std::string& id : state.agent().held) {
    const auto i = state.index_of(id);
    if (!i) return Error{Error::Kind::Schema, state.scene_.id, {}, "the agent holds " + id + ", which does not exist"};
    held.push_back(*i);
  }
  // Which things the agent carries, and what is attached, is nowhere but in the edges.
  std::map<std::size_t, std::vector<Link>> attached;
  for (const Edge& edge : edges) {
    const bool contact = edge.relation == Predicate::On || edge.relation == Predicate::Inside;
    if (edge.relation != Predicate::Attached && (held.empty() || !contact)) continue;
    const auto from = state.index_of(edge.from), to = state.index_of(edge.to);
    if (!from || !to) continue;
    const Link link{edge.relation, static_cast<std::uint32_t>(*to)};
    if (contact) {
      std::vector<Link> links = state.links_[*from];
      links.push_back(link);
      sort_unique(links);
      state.exchange_links(*from, links);
    } else {
      attached[*from].push_back(link);
    }
  }
  const std::vector<std::size_t> in_hand = state.in_hand();
  for (const std::size_t i : in_hand) state.physics_.remove(static_cast<BodyId>(i));
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Link> links = known.links ? std::move((*known.links)[i]) : links_of(state.scene_, state.physics_, i);
    if (std::binary_search(in_hand.begin(), in_hand.end(), i)) {
      for (const Link& link : state.links_[i]) {
        if (std::binary_search(in_hand.begin(), in_hand.end(), link.to)) links.push_back(link);
      }
    }
    if (const auto here = attached.find(i); here != attached.end()) {
      for (const Link& link : here->second) {
        if (std::find(links.begin(), links.end(), Link{Predicate::On, link.to}) != links.end()) links.push_back(link);
      }
    }
    sort_unique(links);
    state.begin_with(i, std::move(links));
  }
  return state;
}

/// Gives a node its first links but for those that its hold in a hand gave it.
void WorldState::begin_with(std::size_t i, std::vector<Link> links) {
  if (!links_[i].empty()) return exchange_links(i, links);
  const auto rider = static_cast<std::uint32_t>(i);
  for (const Link& link : links) {
    if (!carries(link)) continue;
    auto& riders = carried_[link.to];
    const auto at = std::lower_bound(riders.begin(), riders.end(), rider);
    if (at == riders.end() || *at != rider) riders.insert(at, rider);
  }
  links_[i] = std::move(links);
}

void WorldState::take_in(Node node, std::shared_ptr<const Collider> collider) {
  places_.add(count(), node);
  colliders_.push_back(std::move(collider));
  links_.emplace_back();
  carried_.emplace_back();
  scene_.nodes.push_back(std::move(node));
}

bool WorldState::held(std::string_view id) const {
  const auto& held = agent().held;
  return std::find(held.begin(), held.end(), id) != held.end();
}

bool WorldState::linked(std::size_t from, Predicate relation, std::size_t to) const {
  const Link link{relation, static_cast<std::uint32_t>(to)};
  return std::binary_search(links_[from].begin(), links_[from].end(), link);
}

std::optional<std::size_t> WorldState::closed_around(std::size_t i) const {
  std::optional<std::size_t> outermost;
  for (const Link& link : links_[i]) {
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
    for (const std::uint32_t rider : carried_[group[at]]) {
      if (std::find(group.begin(), group.end(), rider) == group.end()) group.push_back(rider);
    }
  }
  std::sort(group.begin() + 1, group.end());
  return group;
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

std::vector<std::size_t> WorldState::hidden() const {
  std::vector<std::size_t> hidden = in_hand();
  for (std::size_t i = 0; i < count(); ++i) {
    if (carried_[i].empty() || !node(i).openable || node(i).states.has(Predicate::Open)) continue;
    for (const std::uint32_t rider : carried_[i]) {
      if (linked(rider, Predicate::Inside, i)) hidden.push_back(rider);
    }
  }
  sort_unique(hidden);
  return hidden;
}

Scene WorldState::whole_scene() const {
  Scene scene = scene_;
  for (std::size_t i = 0; i < count(); ++i) {
    for (const Link& link : links_[i]) scene.edges.push_back(edge_of(scene, i, link));
  }
  if (const Room* room = room_at(scene, scene.agent.position)) {
    scene.edges.push_back({Predicate::InRoom, "agent", room->id});
  }
  sort_unique(scene.edges);
  return scene;
}

std::optional<Outcome> out_of_hands_way(const WorldState& state, std::size_t node) {
  return out_of_hands_way(state, node, state.agent().position);
}

std::optional<Outcome> out_of_hands_way(const WorldState& state, std::size_t node, const Vec2& place) {
  const std::string& id = state.node(node).id;
  if (const auto container = state.closed_around(node)) {
    return failed(Failure::InsideClosed, id + " is inside " + state.node(*container).id + ", which is closed.");
  }
  if (reach_distance(state.node(node), place, *state.profile) > state.profile->reach_m) {
    return failed(Failure::TooFar, id + " is out of reach; go to it first.");
  }
  if (!sees(state.scene(), state.physics(), *state.profile, place, node)) {
    return failed(Failure::NotVisible, id + " is not in sight from here.");
  }
  return std::nullopt;
}

void look_at(WorldState& state, const Vec3& point) {
  Agent& agent = state.edit_agent();
  agent = facing(agent, point, *state.profile);
}

}  // namespace unietp
