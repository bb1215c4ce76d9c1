#include "generator/scene_offer.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "logic/evaluate.h"

namespace unietp {
namespace {

std::vector<std::string> single(const SceneOffer& offer, Entity::Kind kind) {
  std::unordered_map<std::string_view, int> numbers;
  for (const auto& entity : offer.now.entities) {
    if (entity.kind == kind) ++numbers[entity.category];
  }
  std::vector<std::string> names;
  for (const auto& [name, number] : numbers) {
    if (number == 1) names.emplace_back(name);
  }
  std::sort(names.begin(), names.end());
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
