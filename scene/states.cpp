#include "scene/states.h"

#include <algorithm>
#include <array>

#include "scene/simulator_info.h"

namespace unietp {
namespace {

constexpr int kNoGroup = -1;

/// Group of each predicate, so that setting a state does not walk the groups.
const std::array<int, kPredicateCount>& group_of_predicate() {
  static const auto table = [] {
    std::array<int, kPredicateCount> groups{};
    groups.fill(kNoGroup);
    for (std::size_t g = 0; g < state_groups().size(); ++g) {
      for (const Predicate predicate : state_groups()[g].predicates) {
        groups[static_cast<std::size_t>(predicate)] = static_cast<int>(g);
      }
    }
    return groups;
  }();
  return table;
}

int group_of(Predicate predicate) { return group_of_predicate()[static_cast<std::size_t>(predicate)]; }

}  // namespace

const std::vector<StateGroup>& state_groups() {
  static const auto groups = [] {
    std::vector<StateGroup> found;
    for (const PredicateInfo& row : all_predicates()) {
      if (row.group.empty()) continue;
      auto group =
          std::find_if(found.begin(), found.end(), [&](const StateGroup& one) { return one.affordance == row.group; });
      if (group == found.end()) group = found.insert(group, {std::string(row.group), {}});
      auto& states = group->predicates;
      states.insert(row.by_default ? states.begin() : states.end(), row.predicate);
    }
    return found;
  }();
  return groups;
}

bool shows(Simulator simulator, Predicate state) {
  const SimulatorInfo& row = info(simulator);
  return row.all_states || std::find(row.shows.begin(), row.shows.end(), state) != row.shows.end();
}

std::optional<Predicate> opposite_of(Predicate state) {
  static const auto table = [] {
    std::array<std::optional<Predicate>, kPredicateCount> opposites;
    for (const StateGroup& group : state_groups()) {
      const auto& two = group.predicates;
      const bool plain = std::all_of(two.begin(), two.end(), [](Predicate p) { return info(p).arguments.size() == 1; });
      if (two.size() != 2 || !plain) continue;
      opposites[static_cast<std::size_t>(two[0])] = two[1];
      opposites[static_cast<std::size_t>(two[1])] = two[0];
    }
    return opposites;
  }();
  return table[static_cast<std::size_t>(state)];
}

void StateSet::set(State state) {
  if (const int group = group_of(state.predicate); group != kNoGroup) {
    std::erase_if(states_, [group](const State& other) { return group_of(other.predicate) == group; });
  }
  const auto place = std::lower_bound(states_.begin(), states_.end(), state);
  if (place == states_.end() || *place != state) states_.insert(place, std::move(state));
}

void StateSet::clear(Predicate predicate) {
  std::erase_if(states_, [predicate](const State& state) { return state.predicate == predicate; });
}

bool StateSet::has(Predicate predicate) const {
  return std::any_of(states_.begin(), states_.end(),
                     [predicate](const State& state) { return state.predicate == predicate; });
}

bool StateSet::has(const State& state) const { return std::binary_search(states_.begin(), states_.end(), state); }

}  // namespace unietp
