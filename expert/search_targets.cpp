#include "expert/search_targets.h"

#include <algorithm>
#include <utility>

#include "expert/search_tools.h"

namespace unietp {
namespace {

constexpr double kEnough = 0.05;  // of the chances to find more of what the goal speaks of all of

SearchTarget target_of(const std::string& category, const SearchNeed& need) {
  return {category, need.places, need.rooms, need.floor, need.near};
}

}  // namespace

int SearchTargets::known_of(const std::vector<std::string>& categories) const {
  int known = 0;
  for (const std::string& category : categories) {
    known += belief_.count(category);
    for (const Room& room : belief_.scene().rooms) known += room.type == category ? 1 : 0;
  }
  return known;
}

bool SearchTargets::is_movable(const std::string& category) const {
  const Category* known = problem_.knowledge.find(category);
  return known != nullptr && known->movable;
}

void SearchTargets::add(std::vector<SearchTarget>& targets, const SearchNeed& need) const {
  for (const std::string& category : need.categories) {
    if (points() || is_movable(category) || belief_.told_by_look(category))
      targets.push_back(target_of(category, need));
  }
}

/// Furniture of which M2 tells where it stands, when none is known to be of the color or material that the goal names.
void SearchTargets::add_unseen(std::vector<SearchTarget>& targets, const WantedState& wanted) const {
  const auto& of = wanted.categories;
  const auto looks_so = [&](const std::string& category) { return belief_.knows_of_look(category, wanted.state); };
  if (points() || std::any_of(of.begin(), of.end(), looks_so)) return;
  for (const std::string& category : of) {
    if (!is_movable(category)) targets.push_back({category});
  }
}

std::vector<SearchTarget> SearchTargets::missing() const {
  std::vector<SearchTarget> targets;
  for (const SearchNeed& need : needs_.needs) {
    if (known_of(need.categories) < need.at_least) add(targets, need);
  }
  if (!targets.empty()) return targets;
  for (const WantedState& wanted : needs_.states) {
    if (wanted.is_look() && wanted.positive) add_unseen(targets, wanted);
    if (wanted.stated) continue;
    for (const std::string& category : wanted.categories) {
      const auto tools = tools_for(wanted, category, problem_.knowledge, profile_);
      if (tools.empty() || std::any_of(tools.begin(), tools.end(), [this](const auto& tool) { return is_known(tool); }))
        continue;
      for (const std::string& tool : tools) targets.push_back({tool});
    }
  }
  return targets;
}

std::vector<SearchTarget> SearchTargets::overlooked() const {
  std::vector<SearchTarget> targets;
  for (const SearchNeed& need : needs_.needs) {
    if (!need.every) continue;
    std::vector<SearchTarget> all;
    add(all, need);
    for (SearchTarget& target : all) {
      if (order_.unseen_share(target, belief_) > kEnough) targets.push_back(std::move(target));
    }
  }
  return targets;
}

std::vector<SearchTarget> SearchTargets::all() const {
  std::vector<SearchTarget> targets;
  for (const SearchNeed& need : needs_.needs) {
    for (const std::string& category : need.categories) targets.push_back(target_of(category, need));
  }
  return targets;
}

}  // namespace unietp
