#pragma once

#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "symbolic/rules.h"
#include "symbolic/world.h"

namespace unietp::pddl {

/// What a tool does by itself to what is there, as far as an action asks: rows of the effect table that differ in their
/// categories only. A need that the tool cannot fail (closed, of what has no door) is none.
struct ProcessClass {
  enum class Place : std::uint8_t { Rests, On, Inside };
  symbolic::Treatment treatment = symbolic::Treatment::Heats;
  Place place = Place::Rests;
  bool closed = false, power = false;
  bool tap = false;   // happens only under the running tap, so within a composite action
  bool door = false;  // the tool opens
  auto operator<=>(const ProcessClass&) const = default;
};
/// "heats-inside-closed-running-door": the name of the predicate that says of which tool and thing it is true.
std::string name_of(const ProcessClass& process);

/// The class of an effect row or reaction with these needs (symbolic::Need) and such a tool; nullopt for what is done
/// by hand.
std::optional<ProcessClass> class_of(symbolic::Treatment treatment, std::uint8_t needs, bool openable, bool switchable);
std::optional<ProcessClass> class_of(const symbolic::Setting& setting, symbolic::Id tool,
                                     const symbolic::Reaction& reaction);

/// All that the effects of a knowledge base come to, sorted.
std::vector<ProcessClass> classes_of(const Knowledge& knowledge);

}  // namespace unietp::pddl
