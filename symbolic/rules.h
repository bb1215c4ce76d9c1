#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "scene/action.h"
#include "scene/states.h"
#include "scene/treatment.h"
#include "symbolic/substances.h"

namespace unietp::symbolic {

/// What a simulator lets its agent do.
struct Capabilities {
  ActionSet actions;
  bool power_needs_closed = true;    // an appliance with a door runs only when it is shut
  bool open_needs_power_off = true;  // and does not open while it runs
  bool power_needs_plug = false;     // what has a plug runs only when it is plugged in
  bool attaching = false;            // place_on attaches what the tables say attaches
  bool has(ActionType type) const { return actions[static_cast<std::size_t>(type)]; }
};
/// From the action table and the rules of data/simulators: all simulators have the two rules of appliances; in the
/// profile `wide`, plugs matter where they can be handled, and BEHAVIOR attaches.
Capabilities capabilities_of(Simulator simulator, ActionProfile profile = ActionProfile::Unietp);

/// Conditions of a treatment, as bits of Reaction::needs.
constexpr std::uint8_t bit_of(EffectNeed need) { return static_cast<std::uint8_t>(1U << static_cast<unsigned>(need)); }
inline constexpr std::uint8_t kClosed = bit_of(EffectNeed::Closed), kPowerOn = bit_of(EffectNeed::PowerOn),
                              kHeld = bit_of(EffectNeed::Held), kInside = bit_of(EffectNeed::Inside),
                              kOn = bit_of(EffectNeed::On), kUnderTap = bit_of(EffectNeed::UnderTap);

/// The needs of an effect as such bits.
std::uint8_t needs_of(const Effect& row);

/// Position of a kind in Rules::kinds().
using KindId = TypedId<struct KindTag>;

/// One row of the effect table, between two kinds.
struct Reaction {
  Treatment treatment = Treatment::Heats;
  std::uint8_t needs = 0;
  SubstanceId symbol;           // fills, dispenses: the substance
  std::optional<KindId> piece;  // slices: kind of the pieces
  int pieces = 0;               // slices: how many
};

/// What the actions need to know of a category.
struct Kind {
  std::string category;
  bool movable = false, pickupable = false, openable = false, switchable = false, sliceable = false, fillable = false,
       coverable = false, drain = false;
  ActionSet allowed;                      // actions whose needs of affordances its things meet
  bool shuts_to_run = false;              // runs only with its door shut, where the simulator has that rule
  std::vector<const StateGroup*> groups;  // the state groups that its things have
  std::vector<std::string> colors, materials;
  bool allows(ActionType action) const { return allowed[static_cast<std::size_t>(action)]; }
};

/// The knowledge base reduced to some categories of one simulator, with numbers in place of names, for the symbolic
/// actions. Kinds are numbered in the order of the given categories, followed by the pieces that slicing them makes.
class Rules {
 public:
  /// Categories that the knowledge base does not have are left out.
  Rules(const Knowledge& knowledge, const Capabilities& capabilities, const std::vector<std::string>& categories);

  /// What the agent may do.
  const Capabilities& capabilities() const { return capabilities_; }
  const std::vector<Kind>& kinds() const { return kinds_; }
  const Kind& kind(KindId id) const { return kinds_[id.index()]; }
  /// nullopt when there is none.
  std::optional<KindId> kind_named(std::string_view category) const;

  /// How many things of a kind fit on or inside one of another; 0 when they do not go there.
  int capacity(KindId thing, Predicate relation, KindId place) const;
  /// What a tool does to a thing; nullptr when it does not.
  const Reaction* reaction(KindId tool, Treatment treatment, KindId thing) const;
  /// All that a tool does to a thing, one of a treatment.
  const std::vector<Reaction>& reactions(KindId tool, KindId thing) const;

  /// Substances, numbered; "any" is none of them.
  const std::vector<std::string>& symbols() const { return symbols_; }
  /// nullopt for one that no row names, and for "any".
  std::optional<SubstanceId> symbol_named(std::string_view symbol) const;
  /// The number of a substance; a new one is added.
  SubstanceId symbol_number(const std::string& symbol);

 private:
  std::size_t cell(KindId first, KindId second) const;
  void add_kind(const Knowledge& knowledge, const std::string& category);
  /// A tool that treats a thing on or in it takes at least one, though no row says that such things belong there.
  void make_room(KindId thing, std::size_t relation, KindId place);
  void read_reactions(const Knowledge& knowledge, std::size_t tools, std::size_t targets);

  Capabilities capabilities_;
  std::vector<Kind> kinds_;
  std::vector<std::string> symbols_;
  std::vector<std::array<int, 2>> capacity_;      // by cell: on, inside
  std::vector<std::vector<Reaction>> reactions_;  // by cell
};

}  // namespace unietp::symbolic
