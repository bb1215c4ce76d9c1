#include "grounding/likelihood.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace unietp {
namespace {

constexpr double kLeastPlace = 1e-6, kLeastState = 1e-3;

/// What a thing of a workspace is on or in, and the room around it, as last read.
struct Location {
  std::vector<std::pair<Predicate, std::size_t>> hosts;
  const Room* room = nullptr;
};

Location location_of(const Workspace& workspace, const Node& node) {
  Location found;
  const auto& present = workspace.current_state();
  const auto entity = present.reader().find(node.id);
  if (!entity) return found;
  const auto& trace = present.now();
  for (const auto& [relation, other] : trace.states.front().relations(*entity)) {
    if (relation != Predicate::On && relation != Predicate::Inside) continue;
    if (const auto host = workspace.places().find(trace.entities[other].id)) found.hosts.emplace_back(relation, *host);
  }
  std::sort(found.hosts.begin(), found.hosts.end());
  if (const auto place = workspace.places().find(node.id)) found.room = workspace.room_of(*place);
  return found;
}

/// A state that hardly any such thing is in on or in a receptacle, or that nearly all are in and that it is not in or
/// was taken out of: "dirty", "not cool". `before`: the thing as the home has it, or nullptr.
std::string rare_state(const Workspace& workspace, const Node& node, const Node* before, Predicate relation,
                       const std::string& receptacle) {
  for (const LikelyState& likely : workspace.household()->states_of(node.category, relation, receptacle)) {
    std::string name(info(likely.state.predicate).name);
    const bool has = node.states.has(likely.state);
    if (has && likely.share < kHardlyAny) return name;
    const bool as_before = before != nullptr && before->pose.position == node.pose.position;
    const bool lacks =
        !has && (as_before ? before->states.has(likely.state) : can_be(node, workspace.knowledge(), likely.state));
    if (lacks && likely.share > 1 - kHardlyAny) return "not " + name;
  }
  return "";
}

/// Whether a thing is where the home has it.
bool stays(const Workspace& workspace, const Node& node) {
  const Home* home = workspace.home();
  const auto at = home == nullptr ? std::nullopt : home->places.find(node.id);
  return at && home->scene.nodes[*at].pose == node.pose;
}

/// Something else on or in the receptacle that is kept apart from the thing, there or as what is in such a place,
/// unless the home keeps it beside such things: in real homes spray stands beside fruit.
const Node* clashing(const Workspace& workspace, const Node& node, Predicate relation, std::size_t host) {
  const auto& household = *workspace.household();
  const auto carried = workspace.carried_by(host);
  const auto& receptacle = workspace.scene().nodes[host];
  const auto& present = workspace.current_state();
  const auto around = present.reader().find(receptacle.id);
  const auto is_inside = [&](const Node& other) {
    const auto entity = present.reader().find(other.id);
    return around && entity && present.now().states.front().holds(Predicate::Inside, *entity, *around);
  };
  const auto clash = [&](const Node& one, const Node& other) {
    return household.clash(one.category, other.category) ||
           (household.stored_apart(one.category, other.category, relation, receptacle.category) && is_inside(other));
  };
  const auto thing = [&](const std::string& id) -> const Node& {
    return workspace.scene().nodes[*workspace.places().find(id)];
  };
  const auto is_usual_here = [&](const Node& other) {
    return stays(workspace, other) && std::any_of(carried.begin(), carried.end(), [&](const std::string& id) {
             return id != node.id && clash(thing(id), other) && stays(workspace, thing(id));
           });
  };
  for (const std::string& id : carried) {
    const Node& other = thing(id);
    if (other.id != node.id && clash(node, other) && !is_usual_here(other)) return &other;
  }
  return nullptr;
}

}  // namespace

double likelihood_of_place(const Workspace& workspace, const Node& node, Predicate relation, std::size_t host) {
  const auto* household = workspace.household();
  if (household == nullptr || household->places_of(node.category).empty()) return 1;
  const auto* place = household->place(node.category, relation, workspace.scene().nodes[host].category);
  const Room* room = workspace.room_of(host);
  const auto& receptacle = workspace.scene().nodes[host].category;
  if (room != nullptr && !household->keeps(node.category, receptacle, room->type)) return kLeastPlace;
  const double suits = room == nullptr ? 1 : household->in_room(node.category, room->type);
  return std::max(kLeastPlace, (place == nullptr ? 0 : place->weight) * suits);
}

double likelihood_of_states(const Workspace& workspace, const Node& node, const HostRelation& host_relation) {
  const Household* household = workspace.household();
  if (household == nullptr) return 1;
  double likelihood = 1;
  for (const LikelyState& likely :
       household->states_of(node.category, host_relation.relation, host_relation.receptacle)) {
    if (node.states.has(likely.state)) {
      likelihood *= likely.share;
    } else if (can_be(node, workspace.knowledge(), likely.state)) {
      likelihood *= 1 - likely.share;
    }
  }
  return std::max(likelihood, kLeastState);
}

double share_in_state(const Workspace& workspace, const Node& node, const State& state) {
  const Household* household = workspace.household();
  if (household == nullptr) return 1;
  double share = 0;
  const auto where = location_of(workspace, node);
  if (where.hosts.empty()) share = household->share(node.category, Predicate::On, "", state);
  for (const auto& [relation, host] : where.hosts)
    share = std::max(share, household->share(node.category, relation, workspace.scene().nodes[host].category, state));
  return std::max(share, kLeastState);
}

bool is_rare_at(const Workspace& workspace, const Node& node, const Node& receptacle) {
  const Household* household = workspace.household();
  if (household == nullptr) return false;
  const auto rare = [&](Predicate relation) {
    return household->place(node.category, relation, receptacle.category) != nullptr &&
           !rare_state(workspace, node, nullptr, relation, receptacle.category).empty();
  };
  return rare(Predicate::On) || rare(Predicate::Inside);
}

bool is_kept_apart_in(const Workspace& workspace, const Node& node, Predicate relation, std::size_t host) {
  return relation == Predicate::Inside && workspace.household() != nullptr && workspace.home() != nullptr &&
         clashing(workspace, node, relation, host) != nullptr;
}

Oddness oddness_of(const Workspace& workspace, const Node& node, std::string* reason) {
  const auto* household = workspace.household();
  const auto odd = [&](const std::string& why) {
    if (reason != nullptr) *reason = node.id + " is " + why;
    return Oddness::Senseless;
  };
  if (household == nullptr || household->places_of(node.category).empty()) return Oddness::None;
  const auto where = location_of(workspace, node);
  const bool unmoved = stays(workspace, node);  // its place is the home's doing: real homes have bowls in the bathroom
  if (!unmoved && where.room != nullptr && household->in_room(node.category, where.room->type) < Household::kNoRoom)
    return odd("in " + where.room->id + ", where nobody keeps such things");
  const auto& all = household->places_of(node.category);
  const bool some_usual = std::any_of(all.begin(), all.end(), [](const auto& place) { return place.usual; });
  const Home* home = workspace.home();
  const auto at_home = home == nullptr ? std::nullopt : home->places.find(node.id);
  const Node* before = at_home ? &home->scene.nodes[*at_home] : nullptr;
  if (node.states.has(Predicate::Dirty) && node.states.has(Predicate::Folded)) return odd("dirty and folded");
  Oddness worst = Oddness::None;
  for (const auto& [relation, host] : where.hosts) {
    const Node& there = workspace.scene().nodes[host];
    const auto at = std::string(info(relation).name) + " " + there.id;
    const auto* place = household->place(node.category, relation, there.category);
    const bool kept = where.room == nullptr || household->keeps(node.category, there.category, where.room->type);
    if ((place == nullptr || !kept) && !unmoved) return odd(at + ", where nobody keeps such things");
    if (some_usual && (place == nullptr || !place->usual)) worst = Oddness::Unusual;
    const auto state = rare_state(workspace, node, before, relation, there.category);
    if (!state.empty()) return odd(state + " " + at + ", as hardly anything is there");
    const Node* other = unmoved ? nullptr : clashing(workspace, node, relation, host);
    if (other != nullptr) return odd(at + " together with " + other->id);
  }
  return worst;
}

}  // namespace unietp
