#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/archetype.h"
#include "scene/geometry.h"

namespace unietp {

/// Where a fact comes from: `metadata:<file>`, `derived:<rule>`, `llm:<model>`, `override:<file>` or `curated`, and how
/// sure it is, (0, 1].
struct Source {
  std::string source;
  double confidence = 1;
  bool operator==(const Source&) const = default;
};

/// Whether a text is a source of one of these forms.
bool well_formed_source(std::string_view source);

/// A kind of object that a simulator has, with what most of its objects are like.
struct Category {
  std::string name;       // the simulator's own: "CoffeeMachine", "kitchencabinet", "coffee_table"
  std::string display;    // "coffee machine"
  std::string plural;     // "coffee machines"; equal to display for uncountable ones ("bread")
  std::string synset;     // WordNet 3.0, "mug.n.04"; "" when none fits
  bool countable = true;  // false: "some bread", not "a bread"
  bool movable = false;
  Archetype archetype = Archetype::Box;
  Vec3 size = Vec3::Zero();                     // typical full extents, metres: width x, depth y, height z
  double mass = 0;                              // kilograms
  std::vector<std::string> rooms;               // usual room types, most usual first
  std::vector<std::string> colours, materials;  // what instances come in
  Source source;                                // of the row as a whole
  Source size_source, mass_source;
  Source synset_source;  // that of the row, but for a completed one
};

/// `mug on countertop: likely 0.4, at most 6`.
struct Placement {
  std::string object, relation, receptacle;  // relation: on, inside, next_to, under
  double likelihood = 0;                     // share among its places on and in things; among its next_to; its under
  int capacity = 1;                          // how many such objects fit
  Source source;
};

/// What a tool or appliance does to what: `Microwave heats Potato; needs closed,power_on`.
struct Effect {
  std::string tool;    // category
  std::string effect;  // heats cools freezes washes cooks burns slices fills soaks wipes dispenses drains attaches
  std::string target;  // category
  std::string gives;   // slices: category of the pieces ("AppleSliced"); fills, dispenses: the substance; else ""
  int amount = 0;      // slices: how many pieces
  std::vector<std::string> needs;  // of the tool or place: closed, power_on, held, inside, on, under_tap
  Source source;
};

/// A further name or description of a category.
struct Alias {
  std::string category, text;
  std::string kind;  // synonym, function ("something to drink from"), context
  Source source;
};

/// One model that a simulator has of a category, with its real box. Scenes that use its size can be handed back to the
/// simulator as they are.
struct Asset {
  std::string name;          // the simulator's own: "Mug_1", "PRE_PRO_Mug_01", "mug-abcdef"
  std::string category;      // of this knowledge base
  Vec3 size = Vec3::Zero();  // full extents, metres, in its own frame: width x, depth y, height z
  Source source;
};

/// A category has an affordance (affordance_names of akb/table_words.h).
struct AffordanceFact {
  std::string category, affordance;
  Source source;
};

}  // namespace unietp
