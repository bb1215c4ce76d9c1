#include "optimum.h"

#include <unordered_map>
#include <vector>

#include "symbolic/perform.h"

namespace unietp::testing {
namespace {

using namespace symbolic;

struct Place {
  World world;
  Progress progress;
};

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  hash ^= value + 0x9e3779b97f4a7c15U + (hash << 6) + (hash >> 2);
  return hash * 0xff51afd7ed558ccdU;
}

std::uint64_t pair_of(std::uint32_t first, std::uint32_t second) {
  return static_cast<std::uint64_t>(first) << 32 | second;
}

std::uint64_t digest(const Place& place) {
  std::uint64_t hash = 7;
  for (const auto& thing : place.world.things) {
    hash = mix(hash, thing.states);
    hash = mix(hash, pair_of(thing.at.value(), thing.filling.value()));
    hash = mix(hash, thing.coats.hash());
    hash = mix(hash, pair_of(static_cast<std::uint32_t>(thing.where), thing.exists ? 1 : 2));
  }
  hash = mix(hash, place.world.held.value());
  hash = mix(hash, pair_of(place.world.by.value(), place.world.room.value()));
  for (const auto part : place.progress.parts()) hash = mix(hash, static_cast<std::uint64_t>(part));
  return hash;
}

std::vector<ActionType> useful_actions(const Capabilities& offer) {
  std::vector<ActionType> found;
  for (const auto& action : all_actions()) {
    const bool acts = action.group == ActionClass::Manipulation || action.group == ActionClass::Composite;
    if (acts && offer.has(action.type)) found.push_back(action.type);
  }
  return found;
}

}  // namespace

Optimum optimum(const Setting& setting, const World& start, const Goal& goal, int bound, std::size_t most_worlds) {
  const auto actions = useful_actions(setting.rules->capabilities());
  std::vector<std::vector<Place>> by_length(static_cast<std::size_t>(bound) + 1);
  std::unordered_map<std::uint64_t, int> seen;
  Place first{start, Progress(goal)};
  first.progress.observe(goal, setting, start);
  by_length[0].push_back(std::move(first));
  Optimum found;
  const auto take = [&](Place& place, const Step& step) {
    return place.progress.perform(goal, setting, place.world, step) == Failure::None;
  };
  for (int length = 0; length < bound; ++length) {
    for (std::size_t i = 0; i < by_length[static_cast<std::size_t>(length)].size(); ++i) {
      const auto place = by_length[static_cast<std::size_t>(length)][i];
      if (const auto best = seen.find(digest(place)); best != seen.end() && best->second < length) continue;
      if (holds(goal, goal.root(), setting, place.world, place.progress)) {
        found.length = length;
        found.exhausted = true;
        return found;
      }
      if (++found.worlds > most_worlds) return found;
      const auto add = [&](Place next, int steps) {
        const int reached = length + steps;
        if (reached >= bound) return;
        const auto [known, fresh] = seen.try_emplace(digest(next), reached);
        if (!fresh && known->second <= reached) return;
        known->second = reached;
        by_length[static_cast<std::size_t>(reached)].push_back(std::move(next));
      };
      for (const auto action : actions) {
        const bool alone = info(action).argument == ActionArgument::None;
        for (std::size_t t = 0; t < (alone ? 1 : place.world.things.size()); ++t) {
          const Step step{action, alone ? kNobody : Id::thing(t)};
          auto next = place;
          if (take(next, step)) {
            add(std::move(next), 1);
          } else if (!alone && place.world[step.target].exists) {
            next = place;
            if (take(next, {ActionType::GoTo, step.target}) && take(next, step)) add(std::move(next), 2);
          }
        }
      }
    }
    by_length[static_cast<std::size_t>(length)].clear();
  }
  found.exhausted = true;
  return found;
}

}  // namespace unietp::testing
