#include "simulation/world_state.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <span>

namespace unietp {
namespace {

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

}  // namespace

WorldState::Change WorldState::change(std::size_t since) const {
  std::map<std::size_t, const Node*> nodes_before;
  std::map<std::size_t, const std::vector<Link>*> links_before;
  const AgentState* agent_before = nullptr;
  std::size_t old_count = count();
  for (const Edit& edit : std::span(log_).subspan(since)) {
    if (const auto* of_node = std::get_if<NodeEdit>(&edit.what)) {
      nodes_before.try_emplace(of_node->node, &of_node->value);
    } else if (const auto* of_links = std::get_if<LinksEdit>(&edit.what)) {
      links_before.try_emplace(of_links->node, &of_links->value);
    } else if (std::holds_alternative<NodeAddition>(edit.what)) {
      --old_count;
    } else if (const auto* before = std::get_if<AgentState>(&edit.what)) {
      if (agent_before == nullptr) agent_before = before;
    }
  }
  Change change;
  for (const auto& [i, before] : nodes_before) {
    if (i >= old_count || *before == node(i)) continue;
    change.delta.nodes.push_back(node(i));
    change.digest_difference -= digest_of(i, *before);
    change.digest_difference += digest_of(i, node(i));
  }
  for (std::size_t i = old_count; i < count(); ++i) {
    change.delta.nodes.push_back(node(i));
    change.digest_difference += digest_of(i, node(i));
    if (!links_before.contains(i)) change.digest_difference += digest_of(i, links(i));
  }
  for (const auto& [i, before] : links_before) {
    if (i < old_count && *before == links(i)) continue;
    if (i < old_count) change.digest_difference -= digest_of(i, *before);
    change.digest_difference += digest_of(i, links(i));
    std::vector<Link> gone, fresh;
    std::set_difference(before->begin(), before->end(), links(i).begin(), links(i).end(), std::back_inserter(gone));
    std::set_difference(links(i).begin(), links(i).end(), before->begin(), before->end(), std::back_inserter(fresh));
    for (const Link& link : gone) change.delta.edges_removed.push_back(edge_of(scene_, i, link));
    for (const Link& link : fresh) change.delta.edges_added.push_back(edge_of(scene_, i, link));
  }
  const AgentState agent_now{agent(), hand_, stopped_};
  if (agent_before != nullptr && *agent_before != agent_now) {
    change.digest_difference -= digest_of(*agent_before);
    change.digest_difference += digest_of(agent_now);
    if (agent_before->agent != agent()) change.delta.agent = agent();
    const auto from = physics_.floor().at(agent_before->agent.position);
    const auto to = physics_.floor().at(agent().position);
    const auto edge_to = [&](std::uint32_t room) { return Edge{Predicate::InRoom, "agent", scene_.rooms[room].id}; };
    if (from != to && from) change.delta.edges_removed.push_back(edge_to(*from));
    if (from != to && to) change.delta.edges_added.push_back(edge_to(*to));
  }
  std::sort(change.delta.edges_removed.begin(), change.delta.edges_removed.end());
  std::sort(change.delta.edges_added.begin(), change.delta.edges_added.end());
  return change;
}

}  // namespace unietp
