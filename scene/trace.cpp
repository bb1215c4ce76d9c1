#include "scene/trace.h"

#include <algorithm>
#include <compare>
#include <iterator>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "scene/size_and_nearness.h"

namespace unietp {
namespace {

/// Finds nodes by id. Fast when asked in the order of the list: two scenes in a row mostly have the same order.
class NodeFinder {
 public:
  explicit NodeFinder(const SharedList<Node>& nodes) : nodes_(nodes) {}

  const Node* find(std::string_view id) {
    if (next_ < nodes_.size() && nodes_[next_].id == id) return &nodes_[next_++];
    if (index_.empty()) {
      for (std::size_t i = 0; i < nodes_.size(); ++i) index_.emplace(nodes_[i].id, i);
    }
    const auto found = index_.find(id);
    if (found == index_.end()) return nullptr;
    next_ = found->second + 1;
    return &nodes_[found->second];
  }

 private:
  const SharedList<Node>& nodes_;
  std::size_t next_ = 0;
  std::unordered_map<std::string_view, std::size_t> index_;  // made when the orders first differ; never iterated
};

/// In the order in which facts are kept.
struct Relation {
  EntityIndex first;
  Predicate predicate = Predicate::Open;
  EntityIndex second;
  auto operator<=>(const Relation&) const = default;
};

bool is_comparison(const Formula& formula) {
  return formula.op == Formula::Op::Atom &&
         (formula.predicate == Predicate::Size || formula.predicate == Predicate::Nearest);
}

}  // namespace

bool reads_comparisons(const Formula& formula) {
  return is_comparison(formula) || std::any_of(formula.children.begin(), formula.children.end(), reads_comparisons) ||
         std::any_of(formula.domain.where.begin(), formula.domain.where.end(), reads_comparisons);
}

bool reads_later_comparisons(const Formula& formula) {
  return is_comparison(formula) ||
         std::any_of(formula.children.begin(), formula.children.end(), reads_later_comparisons);
}

bool Delta::empty() const {
  return nodes.empty() && removed.empty() && edges_added.empty() && edges_removed.empty() && !agent;
}

Delta difference(const Scene& before, const Scene& after) {
  Delta delta;
  NodeFinder old_nodes(before.nodes);
  for (const Node& node : after.nodes) {
    const Node* old = old_nodes.find(node.id);
    if (old == nullptr || *old != node) delta.nodes.push_back(node);
  }
  NodeFinder new_nodes(after.nodes);
  for (const Node& node : before.nodes) {
    if (new_nodes.find(node.id) == nullptr) delta.removed.push_back(node.id);
  }
  std::set_difference(after.edges.begin(), after.edges.end(), before.edges.begin(), before.edges.end(),
                      std::back_inserter(delta.edges_added));
  std::set_difference(before.edges.begin(), before.edges.end(), after.edges.begin(), after.edges.end(),
                      std::back_inserter(delta.edges_removed));
  if (before.agent != after.agent) delta.agent = after.agent;
  return delta;
}

Scene apply(Scene before, const Delta& delta) {
  Scene& scene = before;
  if (!delta.removed.empty()) {
    const std::unordered_set<std::string_view> gone(delta.removed.begin(), delta.removed.end());
    erase_if(scene.nodes, [&](const Node& node) { return gone.contains(node.id); });
  }
  for (const Node& node : delta.nodes) {
    if (Node* old = edit_node(scene, node.id)) {
      *old = node;
    } else {
      scene.nodes.push_back(node);
    }
  }
  for (const Edge& edge : delta.edges_removed) scene.edges.erase(edge);
  for (const Edge& edge : delta.edges_added) scene.edges.insert(edge);
  if (delta.agent) scene.agent = *delta.agent;
  return before;
}

FactReader::FactReader(bool with_comparisons) : with_comparisons_(with_comparisons) {
  index_of(Entity{Entity::Kind::Agent, "agent", "agent", ""});
}

std::optional<EntityIndex> FactReader::find(std::string_view id) const {
  if (const auto shared = entities_.find_shared(id)) return shared;
  const auto found = by_id_.find(std::string(id));
  return found == by_id_.end() ? std::nullopt : std::optional(found->second);
}

void FactReader::share() {
  entities_.share();
  by_id_ = std::unordered_map<std::string, EntityIndex>();  // `= {}` keeps the buckets, which every copy would clear
}

EntityIndex FactReader::index_of(Entity entity) {
  if (const auto shared = entities_.find_shared(entity.id)) return *shared;
  const auto [place, fresh] = by_id_.try_emplace(entity.id, EntityIndex(entities_.size()));
  if (fresh) entities_.push_back(std::move(entity));
  return place->second;
}

/// The node exists, with its states and attributes.
EntityIndex FactReader::add_node(const Node& node, Facts& facts) {
  const auto known = find(node.id);
  const EntityIndex index =
      known ? *known : index_of(Entity{Entity::Kind::Object, node.id, node.category, node.whole_category});
  facts.set_exists(index);
  for (const State& state : node.states.all()) {
    if (state.symbol.empty()) {
      facts.set(state.predicate, index);
    } else {
      facts.set(state.predicate, index, state.symbol);
    }
  }
  if (!node.color.empty()) facts.set(Predicate::Color, index, node.color);
  if (!node.material.empty()) facts.set(Predicate::Material, index, node.material);
  return index;
}

Facts FactReader::read(const Scene& scene) {
  Facts facts;
  facts.set_exists(index_of(Entity{Entity::Kind::Agent, "agent", "agent", ""}));
  for (const Room& room : scene.rooms) {
    const auto known = find(room.id);
    facts.set_exists(known ? *known : index_of(Entity{Entity::Kind::Room, room.id, room.type, ""}));
  }
  std::vector<EntityIndex> index_of_node;
  index_of_node.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) index_of_node.push_back(add_node(node, facts));
  for (const std::string& id : scene.agent.held) {
    if (const auto held = find(id); held && facts.exists(*held)) facts.set(Predicate::Held, *held);
  }
  std::vector<Relation> relations;
  relations.reserve(scene.edges.size());
  std::string_view last_from;  // edges come in runs of one thing
  std::optional<EntityIndex> first;
  const auto relate = [&](Predicate relation, std::string_view from, std::string_view to) {
    if (from != last_from || last_from.empty()) {
      first = find(from);
      last_from = from;
    }
    const auto second = find(to);
    if (!first || !second || !facts.exists(*first) || !facts.exists(*second)) return;
    relations.push_back({*first, relation, *second});
  };
  for (const Edge& edge : scene.edges) relate(edge.relation, edge.from, edge.to);
  for (const Node& node : scene.nodes) {
    if (!node.slice_of.empty()) relate(Predicate::SliceOf, node.id, node.slice_of);
  }
  std::sort(relations.begin(), relations.end());  // in this order each fact is appended at the end
  if (with_comparisons_) {
    const auto edges = static_cast<std::ptrdiff_t>(relations.size());
    std::vector<std::size_t> all(scene.nodes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (const NearestPair& pair : nearest_pairs(scene.nodes, all))
      relations.push_back({index_of_node[pair.winner], Predicate::Nearest, index_of_node[pair.other]});
    const auto nearest = relations.begin() + edges;
    if (!std::is_sorted(nearest, relations.end())) std::sort(nearest, relations.end());  // stored in another order
    std::inplace_merge(relations.begin(), nearest, relations.end());
    for (const auto& [i, size] : sizes_of(scene.nodes, all)) facts.set(Predicate::Size, index_of_node[i], size);
  }
  for (const Relation& relation : relations) facts.set(relation.predicate, relation.first, relation.second);
  return facts;
}

Facts FactReader::read(Facts before, const Delta& change) {
  Facts& facts = before;
  const auto related = [&](const Edge& edge) -> std::optional<std::pair<EntityIndex, EntityIndex>> {
    const auto from = find(edge.from), to = find(edge.to);
    if (!from || !to) return std::nullopt;
    return std::pair(*from, *to);
  };
  for (const Edge& edge : change.edges_removed) {
    if (const auto ends = related(edge)) facts.clear(edge.relation, ends->first, ends->second);
  }
  for (const std::string& id : change.removed) {
    if (const auto gone = find(id)) facts.forget(*gone);
  }
  for (const Node& node : change.nodes) {
    const auto known = find(node.id);
    if (known) {
      const bool held = facts.holds(Predicate::Held, *known);
      const bool large = facts.holds(Predicate::Size, *known, "large"),
                 small = facts.holds(Predicate::Size, *known, "small");
      facts.clear_states(*known);
      if (held) facts.set(Predicate::Held, *known);
      if (large) facts.set(Predicate::Size, *known, "large");
      if (small) facts.set(Predicate::Size, *known, "small");
    }
    const EntityIndex index = add_node(node, facts);
    if (const auto whole = node.slice_of.empty() ? std::nullopt : find(node.slice_of)) {
      facts.set(Predicate::SliceOf, index, *whole);
    }
  }
  for (const Edge& edge : change.edges_added) {
    const auto ends = related(edge);
    if (ends && facts.exists(ends->first) && facts.exists(ends->second)) {
      facts.set(edge.relation, ends->first, ends->second);
    }
  }
  if (change.agent) {
    for (const EntityIndex held : facts.with(Predicate::Held)) facts.clear(Predicate::Held, held);
    for (const std::string& id : change.agent->held) {
      if (const auto held = find(id); held && facts.exists(*held)) facts.set(Predicate::Held, *held);
    }
  }
  return before;
}

Trace to_logic(const Scene& start, const std::vector<Delta>& deltas, bool with_comparisons) {
  FactReader reader(with_comparisons);
  Trace trace;
  trace.states.reserve(deltas.size() + 1);
  trace.states.push_back(reader.read(start));
  Scene scene;  // only comparisons need all things as they are
  if (with_comparisons && !deltas.empty()) scene = start;
  for (const Delta& delta : deltas) {
    if (with_comparisons) {
      scene = apply(std::move(scene), delta);
      trace.states.push_back(reader.read(scene));
    } else {
      trace.states.push_back(reader.read(trace.states.back(), delta));
    }
  }
  trace.entities = reader.entities();
  return trace;
}

}  // namespace unietp
