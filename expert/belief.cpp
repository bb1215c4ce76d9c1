#include "expert/belief.h"

#include <algorithm>
#include <utility>

namespace unietp {
namespace {

constexpr double kElsewhere_m = 0.02;

/// Puts the node into a state, with its joints.
void set_state(Node& node, const State& state) {
  node.states.set(state);
  if (state.predicate == Predicate::Open) node.opening = 1;
  if (state.predicate == Predicate::Closed) node.opening = 0;
}

/// A state of the same group in which the thing is not as wanted; nullopt where the state has no group.
std::optional<State> other_than(const State& wanted) {
  for (const StateGroup& group : state_groups()) {
    if (std::find(group.predicates.begin(), group.predicates.end(), wanted.predicate) == group.predicates.end())
      continue;
    for (const Predicate other : group.predicates) {
      if (other == wanted.predicate) continue;
      return State{other, other == Predicate::Filled ? "water" : ""};
    }
  }
  return std::nullopt;
}

/// What a goal presupposes of furniture that was not seen: that there is something to do. How it looks and how large it
/// is are no states, and nothing is presupposed of them.
void presume(Node& node, const SearchNeeds& needs) {
  for (const bool stated : {false, true}) {
    for (const WantedState& wanted : needs.states) {
      if (wanted.stated != stated || wanted.is_look() || wanted.state.predicate == Predicate::Size) continue;
      const auto& of = wanted.categories;
      if (!holds(of, node.category)) continue;
      if (wanted.positive == stated) {
        set_state(node, wanted.state);
      } else if (wanted.state.predicate == Predicate::Covered) {
        node.states.clear(Predicate::Covered);
      } else if (const auto other = other_than(wanted.state)) {
        set_state(node, *other);
      }
    }
  }
}

}  // namespace

Belief::Belief(const Scene& known_scene, const SearchNeeds& needs, std::set<std::string> relevant)
    : scene_(known_scene), relevant_(std::move(relevant)) {
  for (const WantedState& wanted : needs.states) {
    if (wanted.is_look()) told_by_look_.insert(wanted.categories.begin(), wanted.categories.end());
  }
  for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
    if (relevant_.contains(scene_.nodes[i].category)) presume(scene_.nodes.edit(i), needs);
  }
  places_ = NodeIndex(scene_.nodes);
}

const Node* Belief::find(std::string_view id) const {
  const auto place = places_.find(id);
  return place ? &scene_.nodes[*place] : nullptr;
}

bool Belief::knows_of_look(const std::string& category, const State& look) const {
  const auto& places = places_.of(category);
  return std::any_of(places.begin(), places.end(), [&](std::size_t place) {
    const Node& node = scene_.nodes[place];
    return (look.predicate == Predicate::Color ? node.color : node.material) == look.symbol;
  });
}

bool Belief::put(const Node& node) {
  if (const auto place = places_.find(node.id)) {
    if (scene_.nodes[*place] == node) return false;
    scene_.nodes.edit(*place) = node;
    return true;
  }
  places_.add(scene_.nodes.size(), node);
  scene_.nodes.push_back(node);
  return true;
}

void Belief::see(const std::vector<Node>& view, const Agent& body) {
  differed_ = false;
  scene_.agent = body;
  moved_.clear();
  for (const Node& node : view) {
    const Node* known = find(node.id);
    const bool looks_other = known != nullptr && told_by_look_.contains(node.category) &&
                             (known->color != node.color || known->material != node.material);
    const bool other = known == nullptr || looks_other || known->states != node.states;
    if (other && relevant_.contains(node.category)) {
      ++news_;
      last_news_ = node.id;
    }
    if (known == nullptr || (known->pose.position - node.pose.position).norm() > kElsewhere_m)
      moved_.push_back(node.id);
    seen_.insert(node.id);
    differed_ = put(node) || differed_;
  }
}

void Belief::foresee(const Delta& changes) {
  for (const Node& node : changes.nodes) (void)put(node);
  if (changes.removed.empty()) return;
  erase_if(scene_.nodes, [&](const Node& node) {
    return std::find(changes.removed.begin(), changes.removed.end(), node.id) != changes.removed.end();
  });
  places_ = NodeIndex(scene_.nodes);
}

}  // namespace unietp
