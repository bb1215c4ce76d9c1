#pragma once

#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "symbolic/rules.h"
#include "symbolic/world.h"

namespace unietp::pddl {

/// A class of rows of the effect table that differ in their categories only: what a tool does to things on or in it,
/// and under which conditions. A condition that always holds (closed, of a tool without a door) is left out.
struct ProcessClass {
  enum class Place : std::uint8_t { Rests, On, Inside };
  Treatment treatment = Treatment::Heats;
  Place place = Place::Rests;
  bool closed = false, power = false;
  bool tap = false;   // only under the running tap, so only within a composite action
  bool door = false;  // the tool opens
  auto operator<=>(const ProcessClass&) const = default;
};
/// "heats-inside-closed-running-door": the predicate of the tools and things that the process applies to.
std::string name_of(const ProcessClass& process);

/// The class of an effect row or reaction with these needs (symbolic::needs_of) and such a tool; nullopt for what is
/// done by hand.
std::optional<ProcessClass> class_of(Treatment treatment, std::uint8_t needs, bool openable, bool switchable);
std::optional<ProcessClass> class_of(const symbolic::Setting& setting, symbolic::Id tool,
                                     const symbolic::Reaction& reaction);

/// The classes of all effects of a knowledge base, sorted.
std::vector<ProcessClass> classes_of(const Knowledge& knowledge);

}  // namespace unietp::pddl
