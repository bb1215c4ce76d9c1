#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"

namespace unietp {

/// One thing that can be known of a category, in the notation of override files and of the commands that show facts:
///
///     size  mass  synset  rooms ...        a cell of its row (fact_properties)
///     openable  pickupable ...             an affordance
///     on:CounterTop  inside:Fridge         a place of it; `on:CounterTop:capacity` says how many fit
///     heats:Potato  slices:Apple           what it does to another category; `heats:Potato:needs` says under what
///     alias:cup                            another name of it
///     asset:Mug_1                          a model of it
struct FactName {
  enum class Kind { Property, Affordance, Placement, Effect, Alias, Asset };
  Kind kind = Kind::Property;
  std::string word;    // the property, affordance, relation or effect; "alias", "asset"
  std::string object;  // the other category, the alias, the model; else ""
  std::string detail;  // "capacity" of a placement, "needs" of an effect, else ""
  bool operator==(const FactName&) const = default;
};

/// display plural synset countable movable archetype size mass rooms colors materials
const std::vector<std::string>& fact_properties();

/// Errors: Usage with `where` "fact": an unknown word with the nearest one, nothing after the colon.
/// Whether a category of the name after the colon exists is not looked at.
Result<FactName> parse_fact(std::string_view text);
/// The inverse of parse_fact.
std::string to_text(const FactName& fact);

/// A fact and what it says: `true`; a number; three lengths `0.1 x 0.09 x 0.1` (width, depth, height); words joined by
/// `|`. A placement says its likelihood; an effect what it gives (`5 AppleSliced` of slicing, else the substance) or
/// `true`; an alias its kind.
struct Fact {
  std::string category, name, value;
  Source source;
  bool operator==(const Fact&) const = default;
};

/// "0.1 x 0.09 x 0.1": width, depth, height in meters.
std::string size_text(const Vec3& size);

/// All facts of one category of `knowledge`, each name once: properties, affordances, placements, effects, aliases,
/// assets. Absent ones (no synset, no rooms) are left out.
std::vector<Fact> facts_of(const Knowledge& knowledge, const Category& category);

}  // namespace unietp
