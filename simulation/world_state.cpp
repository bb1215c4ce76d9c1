#include "simulation/world_state.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "simulation/agent_moves.h"

namespace unietp {
namespace {

constexpr double kHandHeight_m = 1.0;

bool looks_alike(const Node& a, const Node& b) {
  return a.archetype == b.archetype && a.openable == b.openable && a.size == b.size && a.opening == b.opening &&
         a.boards == b.boards;
}

void add(Digester& digester, const Vec3& v) { digester.add(v.x()).add(v.y()).add(v.z()); }

Digest digest_of(std::size_t i, const Node& node) {
  Digester digester;
  digester.add(std::uint64_t{i}).add(node.id).add(node.category);
  digester.add(static_cast<std::uint64_t>(node.archetype)).add(std::uint64_t{node.boards.size()});
  add(digester, node.size);
  add(digester, node.pose.position);
  const Quat& turn = node.pose.rotation;
  digester.add(turn.x()).add(turn.y()).add(turn.z()).add(turn.w()).add(node.opening).add(node.mass);
  for (const State& state : node.states.all()) {
    digester.add(static_cast<std::uint64_t>(state.predicate)).add(state.symbol);
  }
  return digester.digest();
}

Digest digest_of(std::size_t i, const std::vector<Link>& links) {
  Digester digester;
  digester.add(~std::uint64_t{i});
  for (const Link& link : links) digester.add((static_cast<std::uint64_t>(link.relation) << 32) | link.to);
  return digester.digest();
}

Digest digest_of(const AgentState& state) {
  Digester digester;
  const Agent& agent = state.agent;
  digester.add(agent.position.x()).add(agent.position.y()).add(agent.yaw).add(agent.pitch);
  for (const std::string& id : agent.held) digester.add(id);
  digester.add(state.hand.ahead_m).add(state.hand.left_m).add(state.hand.turn);
  digester.add(std::uint64_t{state.stopped ? 1U : 0U});
  return digester.digest();
}

template <class T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

const Room* agents_room(const Scene& scene, const Agent& agent) { return room_at(scene, agent.position); }

}  // namespace

Result<WorldState> WorldState::of(Scene start, const Knowledge& knowledge, const Profile& profile,
                                  PhysicsWorld physics) {
  WorldState state;
  state.knowledge = &knowledge;
  state.profile = &profile;
  state.physics_ = std::move(physics);
  const std::vector<Edge> edges = std::move(start.edges);
  start.edges.clear();
  std::vector<Node> nodes = std::move(start.nodes);
  start.nodes.clear();
  state.scene_ = std::move(start);
  state.scene_.nodes.reserve(nodes.size() + 8);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    state.take_in(std::move(nodes[i]), state.physics_.share(static_cast<BodyId>(i)));
  }

  std::vector<std::size_t> held;
  for (const std::string& id : state.agent().held) {
    const auto i = state.index_of(id);
    if (!i) return Error{Error::Kind::Schema, state.scene_.id, {}, "the agent holds " + id + ", which does not exist"};
    held.push_back(*i);
  }
  // Which things the agent carries, and what is attached, is nowhere but in the edges.
  std::vector<std::vector<Link>> attached(state.count());
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
  for (std::size_t i = 0; i < state.count(); ++i) {
    std::vector<Link> links = links_of(state.scene_, state.physics_, i);
    if (std::binary_search(in_hand.begin(), in_hand.end(), i)) {
      for (const Link& link : state.links_[i]) {
        if (std::binary_search(in_hand.begin(), in_hand.end(), link.to)) links.push_back(link);
      }
    }
    for (const Link& link : attached[i]) {
      if (std::find(links.begin(), links.end(), Link{Predicate::On, link.to}) != links.end()) links.push_back(link);
    }
    sort_unique(links);
    state.exchange_links(i, links);
  }
  return state;
}

void WorldState::take_in(Node node, std::shared_ptr<const Collider> collider) {
  index_.emplace(node.id, count());
  colliders_.push_back(std::move(collider));
  links_.emplace_back();
  carried_.emplace_back();
  scene_.nodes.push_back(std::move(node));
}

Digest WorldState::digest() const {
  Digest sum = digest_of(AgentState{agent(), hand_, stopped_});
  for (std::size_t i = 0; i < count(); ++i) {
    sum += digest_of(i, node(i));
    sum += digest_of(i, links_[i]);
  }
  return sum;
}

std::optional<std::size_t> WorldState::index_of(std::string_view id) const {
  const auto found = index_.find(id);
  return found == index_.end() ? std::nullopt : std::optional(found->second);
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

std::vector<std::string> WorldState::hidden() const {
  std::vector<std::string> ids;
  for (const std::size_t i : in_hand()) ids.push_back(node(i).id);
  for (std::size_t i = 0; i < count(); ++i) {
    if (!node(i).openable || node(i).states.has(Predicate::Open)) continue;
    for (const std::uint32_t rider : carried_[i]) {
      if (linked(rider, Predicate::Inside, i)) ids.push_back(node(rider).id);
    }
  }
  sort_unique(ids);
  return ids;
}

Scene WorldState::whole_scene() const {
  Scene scene = scene_;
  for (std::size_t i = 0; i < count(); ++i) {
    for (const Link& link : links_[i]) scene.edges.push_back(edge_of(scene, i, link));
  }
  if (const Room* room = agents_room(scene, scene.agent)) {
    scene.edges.push_back({Predicate::InRoom, "agent", room->id});
  }
  sort_unique(scene.edges);
  return scene;
}

const NavigationGrid& WorldState::grid() const {
  if (!grid_) {
    grid_.emplace(scene_, *profile);
  } else {
    for (const std::size_t i : moved_) {
      const bool there = i < count() && physics_.has(static_cast<BodyId>(i));
      grid_->update(i, there ? &node(i) : nullptr, there ? &collider(i).shape : nullptr);
    }
  }
  moved_.clear();
  return *grid_;
}

namespace {

NavigationGrid::Cell cell_of(const Agent& agent, const NavigationGrid& grid) {
  const auto cell = grid.cell_at(agent.position);
  return grid.free(cell) ? cell : grid.nearest_free(agent.position).value_or(cell);
}

}  // namespace

const std::vector<std::int32_t>& WorldState::walk() const {
  const NavigationGrid& now = grid();
  const auto from = cell_of(agent(), now);
  // Who can be walked to from a cell can be walked to from all its neighbours.
  const bool known =
      !walk_.to.empty() && walk_.grid_version == now.version() && now.free(from) && walk_.to[now.index(from)] >= 0;
  if (!known) walk_ = {now.distances(from), now.version(), from};
  return walk_.to;
}

const std::vector<std::int32_t>& WorldState::steps() const {
  const NavigationGrid& now = grid();
  const auto from = cell_of(agent(), now);
  if (steps_.to.empty() || steps_.grid_version != now.version() || steps_.from != from) {
    steps_ = {now.distances(from), now.version(), from};
  }
  return steps_.to;
}

void WorldState::log_node(std::size_t i) { log(NodeWas{i, node(i)}); }
void WorldState::log_agent() { log(AgentState{agent(), hand_, stopped_}); }

Agent& WorldState::edit_agent() {
  log_agent();
  return scene_.agent;
}

void WorldState::set_hand(const HandPose& hand) {
  log_agent();
  hand_ = hand;
}

void WorldState::stop() {
  log_agent();
  stopped_ = true;
}

StateSet& WorldState::edit_states(std::size_t i) {
  log_node(i);
  return scene_.nodes[i].states;
}

void WorldState::put_body(std::size_t i) {
  const Node& here = node(i);
  physics_.set(static_cast<BodyId>(i), colliders_[i], here.pose, here.movable ? here.mass : 0);
}

/// Brings the node's collider, its body and the grid in line with what it is now.
void WorldState::follow(std::size_t i, const Node& before) {
  const Node& now = node(i);
  const bool moved = !(now.pose == before.pose), other = !looks_alike(now, before);
  if (!moved && !other) return;
  moved_.push_back(i);
  if (other) colliders_[i] = book_.of(now);
  if (!physics_.has(static_cast<BodyId>(i))) return;
  if (other) {
    put_body(i);
  } else {
    physics_.move(static_cast<BodyId>(i), now.pose);
  }
}

void WorldState::move(std::size_t i, const Pose& pose) {
  if (node(i).pose == pose) return;
  log_node(i);
  scene_.nodes[i].pose = pose;
  moved_.push_back(i);
  if (physics_.has(static_cast<BodyId>(i))) physics_.move(static_cast<BodyId>(i), pose);
}

void WorldState::set_opening(std::size_t i, double opening) {
  Node changed = node(i);
  changed.opening = opening;
  replace(i, std::move(changed));
}

void WorldState::replace(std::size_t i, Node changed) {
  std::swap(scene_.nodes[i], changed);
  follow(i, changed);
  log(NodeWas{i, std::move(changed)});
}

std::size_t WorldState::add(Node node) {
  const std::size_t i = count();
  auto collider = book_.of(node);
  take_in(std::move(node), std::move(collider));
  log(Added{});
  lay(i);
  return i;
}

void WorldState::lift(std::size_t i) {
  physics_.remove(static_cast<BodyId>(i));
  moved_.push_back(i);
  log(Lifted{i});
}

void WorldState::lay(std::size_t i) {
  put_body(i);
  moved_.push_back(i);
  log(Lifted{i});
}

void WorldState::attach(std::size_t i, std::size_t to) {
  std::vector<Link> links = links_[i];
  links.push_back({Predicate::Attached, static_cast<std::uint32_t>(to)});
  sort_unique(links);
  exchange_links(i, links);
  log(LinksWere{i, std::move(links)});
}

/// Gives the node other links, and takes the present ones away in `links`.
void WorldState::exchange_links(std::size_t i, std::vector<Link>& links) {
  const auto rider = static_cast<std::uint32_t>(i);
  const auto carriers_of = [](const std::vector<Link>& of) {
    std::vector<std::uint32_t> carriers;
    for (const Link& link : of) {
      if (carries(link)) carriers.push_back(link.to);
    }
    sort_unique(carriers);
    return carriers;
  };
  const auto before = carriers_of(links_[i]), after = carriers_of(links);
  for (const std::uint32_t carrier : before) {
    if (!std::binary_search(after.begin(), after.end(), carrier)) std::erase(carried_[carrier], rider);
  }
  for (const std::uint32_t carrier : after) {
    if (std::binary_search(before.begin(), before.end(), carrier)) continue;
    auto& riders = carried_[carrier];
    riders.insert(std::lower_bound(riders.begin(), riders.end(), rider), rider);
  }
  std::swap(links_[i], links);
}

void WorldState::refresh(std::span<const Bounds> touched, std::span<const std::size_t> changed) {
  const std::vector<std::size_t> hand = in_hand();
  const auto is_in_hand = [&](std::size_t i) { return std::binary_search(hand.begin(), hand.end(), i); };
  for (const std::size_t i : affected_by(physics_, touched, changed)) {
    std::vector<Link> links = links_of(scene_, physics_, i);
    for (const Link& link : links_[i]) {
      if (carries(link) && is_in_hand(i) && is_in_hand(link.to)) links.push_back(link);
      // Attached stays what still lies on what it was attached to.
      const Link on{Predicate::On, link.to};
      if (link.relation == Predicate::Attached && std::find(links.begin(), links.end(), on) != links.end()) {
        links.push_back(link);
      }
    }
    sort_unique(links);
    if (links == links_[i]) continue;
    exchange_links(i, links);
    log(LinksWere{i, std::move(links)});
  }
}

void WorldState::carry_along() {
  if (agent().held.empty()) return;
  const Vec2 ahead(std::cos(agent().yaw), std::sin(agent().yaw));
  const Vec2 left(-ahead.y(), ahead.x());
  const Vec2 at = agent().position + hand_.ahead_m * ahead + hand_.left_m * left;
  std::vector<std::size_t> moved;
  for (const std::string& id : agent().held) {
    const auto i = index_of(id);
    if (!i) continue;
    const Pose grip = upright(Vec3(at.x(), at.y(), kHandHeight_m), agent().yaw + hand_.turn);
    const Pose motion = grip * inverse(node(*i).pose);
    for (const std::size_t member : group_of(*i)) {
      move(member, member == *i ? grip : motion * node(member).pose);
      moved.push_back(member);
    }
  }
  refresh({}, moved);
}

void WorldState::exchange(Edit& edit) {
  if (auto* of_node = std::get_if<NodeWas>(&edit.what)) {
    std::swap(scene_.nodes[of_node->node], of_node->value);
    follow(of_node->node, of_node->value);
  } else if (auto* of_links = std::get_if<LinksWere>(&edit.what)) {
    exchange_links(of_links->node, of_links->value);
  } else if (const auto* lifted = std::get_if<Lifted>(&edit.what)) {
    moved_.push_back(lifted->node);
    if (physics_.has(static_cast<BodyId>(lifted->node))) {
      physics_.remove(static_cast<BodyId>(lifted->node));
    } else {
      put_body(lifted->node);
    }
  } else if (auto* added = std::get_if<Added>(&edit.what)) {
    if (added->value) {
      auto collider = book_.of(*added->value);
      take_in(std::move(*added->value), std::move(collider));
      added->value.reset();
    } else {
      index_.erase(scene_.nodes.back().id);
      added->value = std::move(scene_.nodes.back());
      scene_.nodes.pop_back();
      colliders_.pop_back();
      links_.pop_back();
      carried_.pop_back();
    }
  } else if (auto* agent_state = std::get_if<AgentState>(&edit.what)) {
    std::swap(scene_.agent, agent_state->agent);
    std::swap(hand_, agent_state->hand);
    std::swap(stopped_, agent_state->stopped);
  }
}

void WorldState::back_to(std::size_t mark) {
  while (log_.size() > mark) {
    exchange(log_.back());
    log_.pop_back();
  }
}

std::vector<Edit> WorldState::take_log() { return std::exchange(log_, {}); }

void WorldState::redo(std::vector<Edit>& log) {
  for (Edit& edit : log) exchange(edit);
}

void WorldState::undo(std::vector<Edit>& log) {
  for (auto edit = log.rbegin(); edit != log.rend(); ++edit) exchange(*edit);
}

WorldState::Change WorldState::change() const {
  std::map<std::size_t, const Node*> nodes_before;
  std::map<std::size_t, const std::vector<Link>*> links_before;
  const AgentState* agent_before = nullptr;
  std::size_t old_count = count();
  for (const Edit& edit : log_) {
    if (const auto* of_node = std::get_if<NodeWas>(&edit.what)) {
      nodes_before.try_emplace(of_node->node, &of_node->value);
    } else if (const auto* of_links = std::get_if<LinksWere>(&edit.what)) {
      links_before.try_emplace(of_links->node, &of_links->value);
    } else if (std::holds_alternative<Added>(edit.what)) {
      --old_count;
    } else if (const auto* before = std::get_if<AgentState>(&edit.what)) {
      if (agent_before == nullptr) agent_before = before;
    }
  }
  Change change;
  for (const auto& [i, before] : nodes_before) {
    if (i >= old_count || *before == node(i)) continue;
    change.seen.nodes.push_back(node(i));
    change.gained -= digest_of(i, *before);
    change.gained += digest_of(i, node(i));
  }
  for (std::size_t i = old_count; i < count(); ++i) {
    change.seen.nodes.push_back(node(i));
    change.gained += digest_of(i, node(i));
    if (!links_before.contains(i)) change.gained += digest_of(i, links_[i]);
  }
  for (const auto& [i, before] : links_before) {
    if (i < old_count && *before == links_[i]) continue;
    if (i < old_count) change.gained -= digest_of(i, *before);
    change.gained += digest_of(i, links_[i]);
    std::vector<Link> gone, fresh;
    std::set_difference(before->begin(), before->end(), links_[i].begin(), links_[i].end(), std::back_inserter(gone));
    std::set_difference(links_[i].begin(), links_[i].end(), before->begin(), before->end(), std::back_inserter(fresh));
    for (const Link& link : gone) change.seen.edges_removed.push_back(edge_of(scene_, i, link));
    for (const Link& link : fresh) change.seen.edges_added.push_back(edge_of(scene_, i, link));
  }
  const AgentState agent_now{agent(), hand_, stopped_};
  if (agent_before != nullptr && *agent_before != agent_now) {
    change.gained -= digest_of(*agent_before);
    change.gained += digest_of(agent_now);
    if (agent_before->agent != agent()) change.seen.agent = agent();
    const Room *from = agents_room(scene_, agent_before->agent), *to = agents_room(scene_, agent());
    if (from != to && from != nullptr) change.seen.edges_removed.push_back({Predicate::InRoom, "agent", from->id});
    if (from != to && to != nullptr) change.seen.edges_added.push_back({Predicate::InRoom, "agent", to->id});
  }
  std::sort(change.seen.edges_removed.begin(), change.seen.edges_removed.end());
  std::sort(change.seen.edges_added.begin(), change.seen.edges_added.end());
  return change;
}

std::optional<Outcome> out_of_hands_way(const WorldState& state, std::size_t node) {
  const std::string& id = state.node(node).id;
  if (const auto container = state.closed_around(node)) {
    return failed(Failure::InsideClosed, id + " is inside " + state.node(*container).id + ", which is closed.");
  }
  if (reach_distance(state.node(node), state.agent().position, *state.profile) > state.profile->reach_m) {
    return failed(Failure::TooFar, id + " is out of reach; go to it first.");
  }
  if (!sees(state.scene(), state.physics(), *state.profile, state.agent().position, node)) {
    return failed(Failure::NotVisible, id + " is not in sight from here.");
  }
  return std::nullopt;
}

void look_at(WorldState& state, const Vec3& point) {
  Agent& agent = state.edit_agent();
  agent = facing(agent, point, *state.profile);
}

}  // namespace unietp
