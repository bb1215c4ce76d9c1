#include "expert/witness.h"

#include <algorithm>
#include <map>
#include <set>

namespace unietp {

WitnessWindow::WitnessWindow(Window& window) : window_(window) {
  seen_.known_scene = window.known_scene();
  look();
}

void WitnessWindow::look() { seen_.moments.push_back({window_.view(), window_.body()}); }

Outcome WitnessWindow::act(const Action& action) {
  Outcome outcome = window_.act(action);
  seen_.actions.push_back(action);
  seen_.outcomes.push_back(outcome);
  look();
  return outcome;
}

Outcome RecordedWindow::act(const Action& action) {
  other_ = other_ || at_ == record_.actions.size() || record_.actions[at_] != action;
  if (other_) return {false, Failure::NotOffered, ""};
  return record_.outcomes[at_++];
}

std::size_t same_moments(const Witnessed& one, const Witnessed& other) {
  std::size_t same = 0;
  for (; same < one.moments.size() && same < other.moments.size(); ++same) {
    if (one.moments[same] != other.moments[same]) break;
    if (same == 0) continue;
    const Outcome &mine = one.outcomes[same - 1], &others = other.outcomes[same - 1];
    if (mine.success != others.success || mine.failure != others.failure || mine.feedback != others.feedback) break;
  }
  return same;
}

bool acted_alike(const Witnessed& one, const Witnessed& other) {
  const std::size_t decided = std::min(same_moments(one, other), std::max(one.actions.size(), other.actions.size()));
  return std::mismatch(one.actions.begin(), one.actions.end(), other.actions.begin(), other.actions.end()).first -
             one.actions.begin() >=
         static_cast<std::ptrdiff_t>(decided);
}

std::optional<Scene> twin_of(const Scene& start, const Demonstration& demonstration) {
  std::map<std::string, std::size_t> first_seen;
  std::string last;
  for (std::size_t i = 0; i < demonstration.steps.size(); ++i) {
    for (const VisibleObject& object : demonstration.steps[i].visible) first_seen.emplace(object.id, i);
  }
  std::size_t latest = 0;
  for (const DemonstrationStep& step : demonstration.steps) {
    for (const std::string& id : step.action.args) {
      const Node* node = find_node(start, id);
      const auto seen = first_seen.find(id);
      if (node == nullptr || !node->movable || seen == first_seen.end() || seen->second <= latest) continue;
      latest = seen->second;
      last = id;
    }
  }
  if (last.empty()) return std::nullopt;
  std::set<std::string> gone{last};
  for (bool more = true; more;) {
    more = false;
    for (const Edge& edge : start.edges) {
      const bool rests = edge.relation == Predicate::On || edge.relation == Predicate::Inside;
      if (rests && gone.contains(edge.to)) more = gone.insert(edge.from).second || more;
    }
  }
  Scene twin = start;
  erase_if(twin.nodes, [&](const Node& node) { return gone.contains(node.id); });
  EdgeSet edges;
  for (const Edge& edge : start.edges) {
    if (!gone.contains(edge.from) && !gone.contains(edge.to)) edges.insert(edge);
  }
  twin.edges = std::move(edges);
  return twin;
}

std::optional<Scene> painted_otherwise(const Scene& start, const Demonstration& demonstration) {
  std::set<std::string> in_view;
  for (const VisibleObject& object : demonstration.steps.front().visible) in_view.insert(object.id);
  std::map<std::string, std::vector<std::size_t>> of_kind;
  for (std::size_t i = 0; i < start.nodes.size(); ++i) {
    const Node& node = start.nodes[i];
    if (!node.movable && !in_view.contains(node.id)) of_kind[node.category].push_back(i);
  }
  Scene twin = start;
  for (const auto& [kind, places] : of_kind) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Node& other = start.nodes[places[places.size() - 1 - i]];
      Node& node = twin.nodes.edit(places[i]);
      node.color = other.color;
      node.material = other.material;
    }
  }
  if (twin == start) return std::nullopt;
  return twin;
}

}  // namespace unietp
