#include "simulation/world_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace unietp {
namespace {

constexpr double kHandHeight_m = 1.0;

bool looks_alike(const Node& a, const Node& b) {
  return a.archetype == b.archetype && a.openable == b.openable && a.size == b.size && a.opening == b.opening &&
         a.boards == b.boards;
}

}  // namespace

void WorldState::log_node(std::size_t i) { log(NodeEdit{i, node(i)}); }
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
  return scene_.nodes.edit(i).states;
}

void WorldState::put_body(std::size_t i) {
  const Node& here = node(i);
  physics_.set(BodyId::node(i), colliders_[i], here.pose, here.movable ? here.mass : 0);
}

/// Updates the node's collider and body, and marks it for the grid.
void WorldState::update_body(std::size_t i, const Node& before) {
  const Node& now = node(i);
  const bool moved = !(now.pose == before.pose), other = !looks_alike(now, before);
  if (!moved && !other) return;
  moved_.push_back(i);
  if (other) colliders_.edit(i) = colliders_made_.of(now);
  if (!physics_.has(BodyId::node(i))) return;
  if (other) {
    put_body(i);
  } else {
    physics_.move(BodyId::node(i), now.pose);
  }
}

void WorldState::move(std::size_t i, const Pose& pose) {
  if (node(i).pose == pose) return;
  log_node(i);
  scene_.nodes.edit(i).pose = pose;
  moved_.push_back(i);
  if (physics_.has(BodyId::node(i))) physics_.move(BodyId::node(i), pose);
}

void WorldState::set_opening(std::size_t i, double opening) {
  Node changed = node(i);
  changed.opening = opening;
  replace(i, std::move(changed));
}

void WorldState::replace(std::size_t i, Node changed) {
  std::swap(scene_.nodes.edit(i), changed);
  update_body(i, changed);
  log(NodeEdit{i, std::move(changed)});
}

std::size_t WorldState::add(Node node) {
  const std::size_t i = count();
  auto collider = colliders_made_.of(node);
  append(std::move(node), std::move(collider));
  log(NodeAddition{});
  lay(i);
  return i;
}

void WorldState::lift(std::size_t i) {
  physics_.remove(BodyId::node(i));
  moved_.push_back(i);
  log(BodyToggle{i});
}

void WorldState::lay(std::size_t i) {
  put_body(i);
  moved_.push_back(i);
  log(BodyToggle{i});
}

void WorldState::attach(std::size_t i, std::size_t to) {
  std::vector<Link> links = this->links(i);
  links.push_back({Predicate::Attached, static_cast<std::uint32_t>(to)});
  sort_unique(links);
  links_.exchange(i, links);
  log(LinksEdit{i, std::move(links)});
}

void WorldState::refresh(std::span<const Bounds> touched, std::span<const std::size_t> changed) {
  const std::vector<std::size_t> hand = in_hand();
  const auto is_in_hand = [&](std::size_t i) { return std::binary_search(hand.begin(), hand.end(), i); };
  for (const std::size_t i : affected_by(physics_, touched, changed)) {
    std::vector<Link> links = links_of(scene_, physics_, i);
    for (const Link& link : this->links(i)) {
      if (carries(link) && is_in_hand(i) && is_in_hand(link.to)) links.push_back(link);
      // An attached object stays attached while it lies on what it was attached to.
      const Link on{Predicate::On, link.to};
      if (link.relation == Predicate::Attached && std::find(links.begin(), links.end(), on) != links.end()) {
        links.push_back(link);
      }
    }
    sort_unique(links);
    if (links == this->links(i)) continue;
    links_.exchange(i, links);
    log(LinksEdit{i, std::move(links)});
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
  if (auto* of_node = std::get_if<NodeEdit>(&edit.what)) {
    std::swap(scene_.nodes.edit(of_node->node), of_node->value);
    update_body(of_node->node, of_node->value);
  } else if (auto* of_links = std::get_if<LinksEdit>(&edit.what)) {
    links_.exchange(of_links->node, of_links->value);
  } else if (const auto* lifted = std::get_if<BodyToggle>(&edit.what)) {
    moved_.push_back(lifted->node);
    if (physics_.has(BodyId::node(lifted->node))) {
      physics_.remove(BodyId::node(lifted->node));
    } else {
      put_body(lifted->node);
    }
  } else if (auto* added = std::get_if<NodeAddition>(&edit.what)) {
    if (added->value) {
      auto collider = colliders_made_.of(*added->value);
      append(std::move(*added->value), std::move(collider));
      added->value.reset();
    } else {
      places_.remove(count() - 1, scene_.nodes.back());
      added->value = scene_.nodes.back();
      scene_.nodes.pop_back();
      colliders_.pop_back();
      links_.resize(count());
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

}  // namespace unietp
