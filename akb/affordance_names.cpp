#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "akb/tables.h"

namespace unietp {

const std::vector<std::string>& affordance_names() {
  static const std::vector<std::string> names{
      "burnable",   "breakable", "consumable", "container", "cookable",    "coverable",   "dirtyable", "drain",
      "fillable",   "foldable",  "freezable",  "heatable",  "heat_source", "cold_source", "lieable",   "openable",
      "pickupable", "pluggable", "receptacle", "sittable",  "sliceable",   "soakable",    "switchable"};
  return names;
}

const std::vector<std::string>& table_names() {
  static const std::vector<std::string> names{"category", "affordance", "relation", "effect", "alias", "asset"};
  return names;
}

const std::vector<std::string>& columns_of(std::string_view table) {
  static const std::vector<std::string> category{"name",        "display",         "plural",      "synset",
                                                 "countable",   "movable",         "archetype",   "width",
                                                 "depth",       "height",          "mass",        "rooms",
                                                 "colours",     "materials",       "source",      "confidence",
                                                 "size_source", "size_confidence", "mass_source", "mass_confidence"};
  static const std::vector<std::string> affordance{"category", "affordance", "source", "confidence"};
  static const std::vector<std::string> relation{"object",   "relation", "receptacle", "likelihood",
                                                 "capacity", "source",   "confidence"};
  static const std::vector<std::string> effect{"tool",   "effect", "target", "gives",
                                               "amount", "needs",  "source", "confidence"};
  static const std::vector<std::string> alias{"category", "kind", "text", "source", "confidence"};
  static const std::vector<std::string> asset{"asset", "category", "width", "depth", "height", "source", "confidence"};
  if (table == "category") return category;
  if (table == "affordance") return affordance;
  if (table == "relation") return relation;
  if (table == "effect") return effect;
  return table == "alias" ? alias : asset;
}

const std::vector<std::string>& relation_names() {
  static const std::vector<std::string> names{"on", "inside", "next_to", "under"};
  return names;
}

const std::vector<std::string>& effect_names() {
  static const std::vector<std::string> names{"heats",  "cools", "freezes", "washes", "cooks",     "burns",
                                              "slices", "fills", "soaks",   "wipes",  "dispenses", "drains"};
  return names;
}

const std::vector<std::string>& need_names() {
  static const std::vector<std::string> names{"closed", "power_on", "held", "inside", "on", "under_tap"};
  return names;
}

const std::vector<std::string>& alias_kinds() {
  static const std::vector<std::string> names{"synonym", "function", "context"};
  return names;
}

const std::vector<std::string>& room_types() {
  static const std::vector<std::string> names{"kitchen",     "living_room", "bedroom", "bathroom",
                                              "dining_room", "corridor",    "office"};
  return names;
}

}  // namespace unietp
