#include "symbolic/witness.h"

#include <algorithm>
#include <queue>
#include <unordered_set>

#include "logic/evaluate.h"
#include "symbolic/heuristic.h"

namespace unietp::symbolic {
namespace {

constexpr int kEagerness = 3;           // weight of an estimated action relative to one already done
constexpr std::size_t kLongestRun = 3;  // longest run of steps that is tried without

/// A world of the search, and the steps that lead to it from its parent: an action, with a go_to before it where one is
/// needed.
struct Place {
  World world;
  Progress progress;
  std::size_t parent = 0;
  std::vector<Step> steps;
  std::size_t length = 0;
};

struct Entry {
  int priority = 0;
  std::size_t order = 0;  // of discovery: ties go to the older
  FewSteps next;
  bool operator<(const Entry& other) const {
    return priority != other.priority ? priority > other.priority : order > other.order;
  }
};

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  hash ^= value + 0x9e3779b97f4a7c15U + (hash << 6) + (hash >> 2);
  return hash * 0xff51afd7ed558ccdU;
}

std::uint64_t pair_of(std::uint32_t first, std::uint32_t second) {
  return (static_cast<std::uint64_t>(first) << 32) | second;
}

std::uint64_t digest(const World& world, const Progress& progress) {
  std::uint64_t hash = 1;
  for (const Thing& thing : world.things) {
    hash = mix(hash, thing.states);
    hash = mix(hash, thing.coats.hash());
    hash = mix(hash, pair_of(thing.at.value(), thing.beside.value()));
    const unsigned flags = (thing.under ? 1U : 0U) | (thing.exists ? 2U : 0U) | (thing.attached ? 4U : 0U);
    hash = mix(hash, pair_of(thing.filling.value(), static_cast<std::uint32_t>(thing.where) << 8 | flags));
  }
  hash = mix(hash, pair_of(world.held.value(), world.seat.value()));
  hash = mix(hash, pair_of(world.room.value(), world.by.value()));
  for (const auto part : progress.parts()) hash = mix(hash, static_cast<std::uint64_t>(part));
  return hash;
}

bool needs_reach(const World& world, const Step& step) {
  const auto group = info(step.action).group;
  if (group != ActionClass::Manipulation && group != ActionClass::Composite) return false;
  return step.target != kNobody && world.held != step.target && root_of(world, step.target) != world.by;
}

bool takes_seat(ActionType action) { return action == ActionType::SitOn || action == ActionType::LieOn; }

class Search {
 public:
  Search(const Formula& formula, const Setting& setting, const World& start, const SearchOptions& options)
      : formula_(formula),
        setting_(setting),
        start_(start),
        options_(options),
        goal_(formula, setting, start),
        heuristic_(setting, goal_) {}

  std::optional<std::vector<Step>> run() {
    Place first{start_, Progress(goal_), 0, {}, 0};
    first.progress.observe(goal_, setting_, start_);
    if (met(first)) return std::nullopt;
    add(std::move(first));
    while (!open_.empty() && places_.size() < options_.most_worlds) {
      const Entry entry = open_.top();
      open_.pop();
      for (const Step& step : entry.next.all()) {
        auto reached = after(entry.order, step);
        if (!reached) continue;
        if (met(*reached)) {
          places_.push_back(std::move(*reached));
          return minimal(plan_to(places_.size() - 1));
        }
        if (reached->length < options_.most_steps) add(std::move(*reached));
      }
    }
    return std::nullopt;
  }

 private:
  bool met(const Place& place) const { return holds(goal_, goal_.root(), setting_, place.world, place.progress); }

  void add(Place place) {
    if (!seen_.insert(digest(place.world, place.progress)).second) return;
    Estimate estimate = heuristic_.estimate(place.world, place.progress);
    if (!estimate.possible() || estimate.steps.empty()) return;
    const int done = static_cast<int>(place.length);
    open_.push({done + kEagerness * estimate.cost, places_.size(), estimate.steps});
    places_.push_back(std::move(place));
  }

  bool take(Place& place, const Step& step) const {
    if (place.progress.perform(goal_, setting_, place.world, step) != Failure::None) return false;
    place.steps.push_back(step);
    ++place.length;
    return true;
  }

  std::optional<Place> after(std::size_t from, const Step& step) const {
    Place place{places_[from].world, places_[from].progress, from, {}, places_[from].length};
    const bool leaves = step.action == ActionType::GoTo || needs_reach(place.world, step) ||
                        step.target == place.world.seat || takes_seat(step.action);
    if (place.world.seat != kNobody && leaves && !take(place, {ActionType::StandUp})) return std::nullopt;
    if (needs_reach(place.world, step) && !take(place, {ActionType::GoTo, step.target})) return std::nullopt;
    if (!take(place, step)) return std::nullopt;
    return place;
  }

  std::vector<Step> plan_to(std::size_t index) const {
    std::vector<const Place*> way;
    for (std::size_t i = index; i != 0; i = places_[i].parent) way.push_back(&places_[i]);
    std::vector<Step> plan;
    for (auto place = way.rbegin(); place != way.rend(); ++place)
      plan.insert(plan.end(), (*place)->steps.begin(), (*place)->steps.end());
    return plan;
  }

  /// The steps of a plan that succeed, up to the one that the goal holds after; nullopt when it never does.
  std::optional<std::vector<Step>> working(const std::vector<Step>& plan) const {
    Place place{start_, Progress(goal_), 0, {}, 0};
    place.progress.observe(goal_, setting_, start_);
    for (const Step& step : plan) {
      if (take(place, step) && met(place)) return std::move(place.steps);
    }
    return std::nullopt;
  }

  /// Tries the plan without each step (and the steps that fail without it), then without short runs of steps.
  std::optional<std::vector<Step>> minimal(std::vector<Step> plan) const {
    for (std::size_t run = 1; run <= kLongestRun;) {
      const auto before = plan.size();
      for (std::size_t i = 0; i + run <= plan.size();) {
        auto without = plan;
        const auto from = without.begin() + static_cast<std::ptrdiff_t>(i);
        without.erase(from, from + static_cast<std::ptrdiff_t>(run));
        if (auto rest = working(without)) {
          plan = std::move(*rest);
        } else {
          ++i;
        }
      }
      run = plan.size() < before && before > 1 ? 1 : run + 1;
    }
    if (!unietp::holds(formula_, trace_of(setting_, replay(setting_, start_, plan)))) return std::nullopt;
    return plan;
  }

  const Formula& formula_;
  const Setting& setting_;
  const World& start_;
  const SearchOptions& options_;
  Goal goal_;
  Heuristic heuristic_;
  std::vector<Place> places_;
  std::priority_queue<Entry> open_;
  std::unordered_set<std::uint64_t> seen_;
};

}  // namespace

std::optional<std::vector<Step>> find_witness(const Formula& goal, const Setting& setting, const World& start,
                                              const SearchOptions& options) {
  return Search(goal, setting, start, options).run();
}

std::vector<World> replay(const Setting& setting, const World& start, const std::vector<Step>& steps) {
  std::vector<World> worlds{start};
  for (const Step& step : steps) {
    World next = worlds.back();
    perform(setting, next, step, &worlds);
    worlds.push_back(std::move(next));
  }
  return worlds;
}

}  // namespace unietp::symbolic
