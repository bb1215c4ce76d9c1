#include "tests/support/household.h"

#include <cctype>

#include "scene/states.h"

namespace unietp::testing {
namespace {

std::string in_words(const std::string& name) {
  std::string words;
  for (const char letter : name) {
    const bool capital = std::isupper(static_cast<unsigned char>(letter)) != 0;
    if (capital && !words.empty()) words += ' ';
    words += capital ? static_cast<char>(std::tolower(static_cast<unsigned char>(letter))) : letter;
  }
  return words;
}

}  // namespace

Source curated() { return {"curated", 1}; }

Category category(std::string name, bool movable, Archetype archetype, Vec3 size, double mass) {
  Category c;
  c.name = std::move(name);
  c.display = c.plural = in_words(c.name);
  c.movable = movable;
  c.archetype = archetype;
  c.size = size;
  c.mass = mass;
  c.source = c.size_source = c.mass_source = curated();
  return c;
}

std::vector<Effect> appliance_effects() {
  using enum EffectNeed;
  using T = Treatment;
  const Source source = curated();
  return {{"Fridge", T::Cools, "Mug", "", 0, {Closed, Inside}, source},
          {"Knife", T::Slices, "Apple", "AppleSliced", 4, {Held}, source},
          {"Microwave", T::Heats, "Mug", "", 0, {Closed, Inside, PowerOn}, source},
          {"Microwave", T::Heats, "Potato", "", 0, {Closed, Inside, PowerOn}, source},
          {"Sink", T::Washes, "Mug", "", 0, {Inside, UnderTap}, source},
          {"Sink", T::Washes, "Plate", "", 0, {Inside, UnderTap}, source}};
}

Node node_of(const Knowledge& knowledge, const std::string& id, const std::string& category, double x, double y,
             double z, double yaw) {
  const Category& c = *knowledge.find(category);
  Node node;
  node.id = id;
  node.category = category;
  node.movable = c.movable;
  node.archetype = c.archetype;
  node.openable = knowledge.has(category, "openable");
  node.size = c.size;
  node.mass = c.mass;
  node.pose = upright(Vec3(x, y, z + c.size.z() / 2), yaw);
  for (const StateGroup& group : state_groups()) {
    if (knowledge.has(category, group.affordance)) node.states.set({group.predicates.front(), ""});
  }
  return node;
}

}  // namespace unietp::testing
