#include "expert/search_tools.h"

#include <utility>

#include "expert/achievers.h"

namespace unietp {

Profile profile_in(Mode mode, Profile profile) {
  for (const ActionInfo& action : all_actions()) {
    if (!offers(action, mode)) profile.actions[static_cast<std::size_t>(action.type)] = false;
  }
  return profile;
}

std::vector<std::string> tools_for(const WantedState& wanted, const std::string& category, const Knowledge& knowledge,
                                   const Profile& profile) {
  std::vector<std::string> tools;
  Predicate predicate = wanted.state.predicate;
  if (!wanted.positive) {
    if (predicate == Predicate::Covered) {
      for (const Effect* effect : knowledge.effects_on(category, Treatment::Wipes)) tools.push_back(effect->tool);
      return tools;
    }
    const auto other = opposite_of(predicate);
    if (!other) return {};
    predicate = *other;
  }
  const std::string& symbol = wanted.state.symbol;
  for (const Achiever& way : achievers_of(predicate, profile)) {
    if (way.kind == AchieverKind::Direct) {
      if (knowledge.has(category, way.affordance)) return {};
      continue;
    }
    if (!way.treatment) continue;
    for (const Effect* effect : knowledge.effects_on(category, *way.treatment)) {
      if (symbol.empty() || symbol == "any" || effect->gives == symbol) tools.push_back(effect->tool);
    }
  }
  return tools;
}

std::set<std::string> categories_of_use(const Formula& goal, const SearchNeeds& needs, const Knowledge& knowledge,
                                        const Profile& profile) {
  std::set<std::string> all;
  for (const std::string& category : categories_of(goal)) all.insert(category);
  for (const WantedState& wanted : needs.states) {
    if (wanted.stated) continue;
    for (const std::string& category : wanted.categories) {
      for (std::string& tool : tools_for(wanted, category, knowledge, profile)) all.insert(std::move(tool));
    }
  }
  return all;
}

}  // namespace unietp
