#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "logic/vocabulary.h"
#include "scene/archetype.h"
#include "scene/geometry.h"
#include "scene/treatment.h"

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

/// What rules of several rooms ask of a category: a row each of data/sense/kind_traits.csv lists its kinds.
enum class KindTrait : std::uint8_t {
  OneSize,       // nobody tells such things apart by their size, whatever their models
  NotBySize,     // nobody picks one out by its size: "the largest pants"
  NotByOpening,  // nor by its being open or closed: a case or a pot is closed at a glance or not at all
  RawOrCooked,   // people call it raw or cooked: meat, eggs and vegetables, not bread
  SeenRunning,   // one sees, and says, that it is on: not of a sink
  ToldByRoom,    // it is told by its room alone
  PutsAway,      // what is in it was put away or waits there
  GivesLight,    // it is left on more often than other things
  Dish,          // holds one sort of thing at a time
};
/// In the order of the enum.
inline constexpr std::array kKindTraits{KindTrait::OneSize,     KindTrait::NotBySize,   KindTrait::NotByOpening,
                                        KindTrait::RawOrCooked, KindTrait::SeenRunning, KindTrait::ToldByRoom,
                                        KindTrait::PutsAway,    KindTrait::GivesLight,  KindTrait::Dish};
std::string_view name_of(KindTrait trait);  // "one_size"
/// nullopt for an unknown name.
std::optional<KindTrait> kind_trait_named(std::string_view name);

/// A kind of object that a simulator has, with what most of its objects are like.
struct Category {
  std::string name;       // the simulator's own: "CoffeeMachine", "kitchencabinet", "coffee_table"
  std::string display;    // "coffee machine"
  std::string plural;     // "coffee machines"; equal to display for uncountable ones ("bread")
  std::string synset;     // WordNet 3.0, "mug.n.04"; "" when none fits
  bool countable = true;  // false: "some bread", not "a bread"
  bool movable = false;
  Archetype archetype = Archetype::Box;
  Vec3 size = Vec3::Zero();                    // typical full extents, meters: width x, depth y, height z
  double mass = 0;                             // kilograms
  std::vector<std::string> rooms;              // usual room types, most usual first
  std::vector<std::string> colors, materials;  // what instances come in
  std::vector<std::string> kinds;              // of data/sense/kinds.csv, narrowest first; empty when it has none
  std::vector<KindTrait> traits;               // that those kinds have, in the order of the enum
  Source source;                               // of the row as a whole
  Source size_source, mass_source;
  Source synset_source;  // that of the row, but for a completed one
};

/// Whether the category has this trait.
bool has_trait(const Category& category, KindTrait trait);
/// Names of the traits, in their order.
std::vector<std::string> names_of(const std::vector<KindTrait>& traits);

/// The relations that a placement may have.
inline constexpr std::array kPlacementRelations{Predicate::On, Predicate::Inside, Predicate::NextTo, Predicate::Under};
/// nullopt for another word.
std::optional<Predicate> placement_relation_named(std::string_view name);

/// `mug on countertop: likely 0.4, at most 6`.
struct Placement {
  std::string object;                  // category
  Predicate relation = Predicate::On;  // one of kPlacementRelations
  std::string receptacle;              // category
  double likelihood = 0;               // share among its places on and in things; among its next_to; its under
  int capacity = 1;                    // how many such objects fit
  Source source;
};

/// What a tool or place needs for an effect.
enum class EffectNeed : std::uint8_t {
  Closed,    // it is closed
  PowerOn,   // it is switched on
  Held,      // the agent holds it
  Inside,    // the target is inside it
  On,        // the target is on it
  UnderTap,  // the target is in it, and its tap runs
};
/// In the order of the enum.
inline constexpr std::array kEffectNeeds{EffectNeed::Closed, EffectNeed::PowerOn, EffectNeed::Held,
                                         EffectNeed::Inside, EffectNeed::On,      EffectNeed::UnderTap};
std::string_view name_of(EffectNeed need);  // "power_on"
/// nullopt for an unknown name.
std::optional<EffectNeed> effect_need_named(std::string_view name);

/// What a tool or appliance does to what: `Microwave heats Potato; needs closed,power_on`.
struct Effect {
  std::string tool;  // category
  Treatment treatment = Treatment::Heats;
  std::string target;             // category
  std::string gives;              // slices: category of the pieces ("AppleSliced"); fills, dispenses: the substance
  int amount = 0;                 // slices: how many pieces
  std::vector<EffectNeed> needs;  // in the order of the table
  Source source;
};
/// Whether the effect has this need.
bool has_need(const Effect& effect, EffectNeed need);
/// Names of the needs, in their order.
std::vector<std::string> names_of(const std::vector<EffectNeed>& needs);

/// What a further name or phrase says of a category. The phrases of data/sense/phrases.csv are the last four.
enum class AliasKind : std::uint8_t {
  Synonym,      // another name
  Function,     // what it is for: "something to drink from"
  Context,      // when one wants it: "I am thirsty."
  Hypernym,     // a wider name: "a piece of cutlery"
  Description,  // by use or part: "the place where we keep the milk cold"
  Occasion,  // a sentence that says what is going to be done, and so which thing is needed: "I want to make a salad."
  Request,   // a state and a sentence that asks for it: "power_on It's too dark to read."
};
/// In the order of the enum.
inline constexpr std::array kAliasKinds{AliasKind::Synonym,  AliasKind::Function,    AliasKind::Context,
                                        AliasKind::Hypernym, AliasKind::Description, AliasKind::Occasion,
                                        AliasKind::Request};
std::string_view name_of(AliasKind kind);  // "synonym"
/// nullopt for an unknown name.
std::optional<AliasKind> alias_kind_named(std::string_view name);

/// A further name or description of a category.
struct Alias {
  std::string category, text;
  AliasKind kind = AliasKind::Synonym;
  Source source;
};

/// One model that a simulator has of a category, with its real box. Scenes that use its size can be handed back to the
/// simulator as they are.
struct Asset {
  std::string name;          // the simulator's own: "Mug_1", "PRE_PRO_Mug_01", "mug-abcdef"
  std::string category;      // of this knowledge base
  Vec3 size = Vec3::Zero();  // full extents, meters, in its own frame: width x, depth y, height z
  Source source;
};

/// A category has an affordance (affordance_names of akb/table_words.h).
struct AffordanceFact {
  std::string category, affordance;
  Source source;
};

}  // namespace unietp
