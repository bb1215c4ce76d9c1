#include "scene/states.h"

#include <algorithm>
#include <array>

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
  using enum Predicate;
  static const std::vector<StateGroup> groups{
      {"openable", {Closed, Open}},     {"switchable", {PowerOff, PowerOn}},
      {"dirtyable", {Clean, Dirty}},    {"heatable", {RoomTemperature, Hot, Cool}},
      {"cookable", {Raw, Cooked}},      {"burnable", {Unburnt, Burnt}},
      {"freezable", {Thawed, Frozen}},  {"sliceable", {Whole, Sliced}},
      {"fillable", {Empty, Filled}},    {"soakable", {Dry, Soaked}},
      {"consumable", {Unused, UsedUp}}, {"breakable", {Intact, Broken}},
      {"foldable", {Unfolded, Folded}}, {"pluggable", {Unplugged, PluggedIn}},
  };
  return groups;
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
