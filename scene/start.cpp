#include "scene/start.h"

#include <algorithm>
#include <utility>

#include "scene/edge_change.h"
#include "scene/json_parse.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

std::string said(const Edge& edge) {
  return std::string(info(edge.relation).name) + " from " + in_quotes(edge.from) + " to " + in_quotes(edge.to);
}

/// The part of a change that does not fit the home, in words; "" when all fits.
std::string misfit(const Scene& home, const Delta& changes) {
  for (const std::string& id : changes.removed) {
    if (find_node(home, id) == nullptr) return "no object " + in_quotes(id) + " in the home that could be gone";
  }
  for (const Edge& edge : changes.edges_removed) {
    if (!home.edges.contains(edge)) return "the home has no edge " + said(edge) + " that could be gone";
  }
  for (const Edge& edge : changes.edges_added) {
    if (home.edges.contains(edge)) return "the home has the edge " + said(edge) + " already";
  }
  return "";
}

void sort_by_id(std::vector<Node>& nodes) {
  std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.id < b.id; });
}

}  // namespace

Delta changes_of(const Scene& home, const Scene& scene) {
  Delta changes = difference(home, scene);
  sort_by_id(changes.nodes);
  return changes;
}

Scene start_in(Scene home, const NodeIndex& places, const Delta& changes) {
  Scene& start = home;
  NodeIndex now = places;
  std::vector<Node> changed = changes.nodes;
  sort_by_id(changed);
  for (Node& node : changed) {
    if (const auto place = now.find(node.id)) {
      start.nodes.edit(*place) = std::move(node);
    } else {
      now.add(start.nodes.size(), node);
      start.nodes.push_back(std::move(node));
    }
  }
  for (const std::string& id : changes.removed) {
    const std::size_t gone = now.find(id).value(), last = start.nodes.size() - 1;
    now.remove(gone, start.nodes[gone]);
    if (gone != last) {
      Node moved = start.nodes[last];
      now.remove(last, moved);
      now.add(gone, moved);
      start.nodes.edit(gone) = std::move(moved);
    }
    start.nodes.pop_back();
  }
  start.edges = EdgeChange{changes.edges_added, changes.edges_removed}.applied_to(std::move(start.edges));
  if (changes.agent) start.agent = *changes.agent;
  return home;
}

Scene start_in(const Scene& home, const Delta& changes) { return start_in(home, NodeIndex(home.nodes), changes); }

Result<Scene> start_in(std::string_view where, const Scene& home, const Delta& changes, const std::string& id) {
  if (const auto wrong = misfit(home, changes); !wrong.empty())
    return Error{Error::Kind::Schema, std::string(where), {}, "its changes do not fit its home: " + wrong};
  Scene start = start_in(home, changes);
  start.id = id;
  auto whole = check_whole(where, std::move(start));
  if (whole) return whole;
  Error error = whole.error();
  error.message = "its changes do not fit its home: " + error.message;
  return error;
}

}  // namespace unietp
