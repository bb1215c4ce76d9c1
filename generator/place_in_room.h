#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "generator/scene_offer.h"
#include "generator/specification.h"

namespace unietp {

/// A place of the goal with the room that says which is meant: "the kitchen sink", "a shelf in the living room".
struct PlaceInRoom {
  std::string variable;  // of the goal: one piece of furniture of a category that nothing else in the goal names
  Formula test;          // what its domain's `:where` says: (exists (?p - kitchen) (in_room ?b ?p))
  bool operator==(const PlaceInRoom&) const = default;
};

/// Whether furniture of a category that stands in a type of room suits what the goal asks for.
using RoomSuits = std::function<bool(const std::string& category, const std::string& room)>;

/// The specification with a room for every place that the home has in that room and in others, since nobody wants
/// coffee on just any of seven side tables. Of the rooms of which the home has one and that suit, those come first in
/// which one such place stands. Places of which nothing suits, and those of a goal that refers by rooms already, stay
/// as they are, and so does everything where nothing is known of the home. Split, style and refinement stay.
/// Deterministic in rng.
Specification with_places_in_rooms(const Specification& plain, const Knowledge& knowledge, const SceneOffer& offer,
                                   const RoomSuits& suits, const Rng& rng);

/// The places with a room of a goal with that refinement, as with_places_in_rooms adds them to the goal `plain`; in the
/// order of its variables.
std::vector<PlaceInRoom> places_in_rooms(const Formula& goal, Referring refinement, const Formula& plain,
                                         const Knowledge& knowledge);

/// The specification with this room: its goal's domain gets the test, and its start has such a place and one such room.
/// nullopt where the start demands that the place be the only one of its kind.
std::optional<Specification> with_place_in_room(const Specification& plain, const PlaceInRoom& place);

}  // namespace unietp
