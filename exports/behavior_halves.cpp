#include "exports/behavior_halves.h"

#include <algorithm>
#include <set>

#include "scene/trace.h"

namespace unietp {
namespace {

/// Whether a formula has an atom or a domain that is about things being cut. `pieces`: categories that cutting gives.
bool speaks_of_cutting(const Formula& f, const std::set<std::string>& pieces) {
  const bool atom = f.op == Formula::Op::Atom && (f.predicate == Predicate::Sliced || f.predicate == Predicate::Whole ||
                                                  f.predicate == Predicate::SliceOf);
  const auto& members = f.domain.members;
  const auto inside = [&](const Formula& part) { return speaks_of_cutting(part, pieces); };
  return atom ||
         std::any_of(members.begin(), members.end(),
                     [&](const auto& one) { return one.slice || pieces.contains(one.category); }) ||
         std::any_of(f.children.begin(), f.children.end(), inside) ||
         std::any_of(f.domain.where.begin(), f.domain.where.end(), inside);
}

/// The first half of a thing that is cut: what remains of it, by another name.
Node first_half(const Node& whole, const Halves& halves) {
  Node half = whole;
  half.id = halves.first;
  half.category = halves.category;
  half.slice_of = whole.id;
  half.whole_category = whole.category;
  half.states = {};
  for (const State& state : whole.states.all()) {
    if (state.predicate != Predicate::Sliced) half.states.set(state);
  }
  return half;
}

/// Adds the first half of each cut thing to a change: as it is, and where it lies. `after`: the scene after the change.
void add_first_halves(Delta& change, const Scene& after, const std::map<std::string, Halves>& halves,
                      std::set<std::string>& cut) {
  for (const Node& whole : std::vector<Node>(change.nodes)) {
    const auto its = halves.find(whole.id);
    if (its == halves.end() || !whole.states.has(Predicate::Sliced)) continue;
    change.nodes.push_back(first_half(whole, its->second));
    if (!cut.insert(whole.id).second) continue;
    for (const Edge& edge : after.edges) {
      if (edge.from == whole.id) change.edges_added.push_back({edge.relation, its->second.first, edge.to});
    }
  }
  const auto copied = [&](std::vector<Edge>& edges) {
    for (const Edge& edge : std::vector<Edge>(edges)) {
      if (cut.contains(edge.from)) edges.push_back({edge.relation, halves.at(edge.from).first, edge.to});
    }
  };
  copied(change.edges_added);
  copied(change.edges_removed);
  if (change.agent) {
    for (const std::string& id : std::vector<std::string>(change.agent->held)) {
      if (cut.contains(id)) change.agent->held.push_back(halves.at(id).first);
    }
  }
}

}  // namespace

HalvedTrace halved_trace(const FinishedTask& task, const Knowledge& knowledge) {
  const DemonstrationRecord& shown = task.shown.at(Mode::M1);
  HalvedTrace made;
  std::set<std::string> pieces;
  for (const Node& node : task.start.nodes) {
    for (const Effect* cuts : knowledge.effects_on(node.category, Treatment::Slices)) pieces.insert(cuts->gives);
  }
  const Formula& goal = task.record.goal_tree;
  if (speaks_of_cutting(goal, pieces)) {
    for (const Node& node : task.start.nodes) {
      const auto cuts = knowledge.effects_on(node.category, Treatment::Slices);
      if (cuts.empty()) continue;
      made.halves[node.id] = {cuts.front()->gives, node.id + "_half_1", node.id + "_half_2"};
    }
  }
  for (const auto& step : shown.steps) {
    for (const Node& node : step.changes.nodes) {
      const auto whole = made.halves.find(node.slice_of);
      if (whole != made.halves.end()) whole->second.second = node.id;
    }
  }
  std::vector<Delta> changes = changes_by_moment(shown);
  std::set<std::string> cut;
  Scene scene = task.start;
  for (Delta& change : changes) {
    scene = apply(std::move(scene), change);
    add_first_halves(change, scene, made.halves, cut);
  }
  // Halves of what is never cut are entities of the start that never exist.
  Scene start = task.start;
  std::vector<std::string> never;
  for (const auto& [id, halves] : made.halves) {
    if (cut.contains(id)) continue;
    for (const std::string& half : {halves.first, halves.second}) {
      Node node = first_half(*find_node(task.start, id), halves);
      node.id = half;
      start.nodes.push_back(std::move(node));
      never.push_back(half);
    }
  }
  made.trace = to_logic(start, changes, reads_comparisons(goal));
  for (const std::string& half : never) {
    for (std::size_t i = 0; i < made.trace.entities.size(); ++i) {
      if (made.trace.entities[EntityIndex(i)].id != half) continue;
      for (Facts& facts : made.trace.states) facts.forget(EntityIndex(i));
    }
  }
  return made;
}

}  // namespace unietp
