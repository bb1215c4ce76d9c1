#include "generator/scene_offer.h"

#include <algorithm>
#include <string>

#include "logic/evaluate.h"

namespace unietp {
namespace {

std::vector<std::string> single(const SceneOffer& offer, Entity::Kind kind) {
  const auto& entities = offer.now.entities;
  std::vector<std::string> names;
  for (const auto category : entities.categories()) {
    const auto all = entities.of(of_category(std::string(category)));
    const auto of_kind = [&](EntityIndex e) { return entities[e].kind == kind; };
    if (std::count_if(all.begin(), all.end(), of_kind) == 1) names.emplace_back(category);
  }
  return names;
}

}  // namespace

int number_in(const SceneOffer& offer, const Domain& domain, const std::string& variable) {
  if (offer.now.states.empty()) return 0;
  return static_cast<int>(members_of(domain, variable, offer.now).size());
}

int number_of(const SceneOffer& offer, const std::string& category) {
  return number_in(offer, of_category(category), "x");
}

std::vector<std::string> single_rooms(const SceneOffer& offer) { return single(offer, Entity::Kind::Room); }
std::vector<std::string> single_objects(const SceneOffer& offer) { return single(offer, Entity::Kind::Object); }

}  // namespace unietp
