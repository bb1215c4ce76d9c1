#pragma once

#include <string>

namespace unietp {

/// Why grounding gives a candidate up; the closed list of Rejection::reason for the stage "grounding".
enum class GroundingReason {
  UnknownCategory,   // "unknown-category": the knowledge lacks a category that the start must have
  LacksRoom,         // "lacks-room": the home has no room of a type that is needed, or not the number
  LacksFurniture,    // "lacks-furniture": furniture is missing and finds no place
  NoFreePlace,       // "no-free-place": an object finds no place to rest; the detail says what it hit
  StateNotPossible,  // "state-not-possible": a category cannot have a state that is asked for
  CannotEnforce,     // "cannot-enforce": no edit of a scene brings this about
  StartNotMet,       // "start-not-met": after all rounds a start constraint is still false
  GoalHolds,         // "goal-holds-at-start"
  PartHolds,         // "part-of-goal-holds-at-start"
  EmptyDomain,       // "empty-domain": a forall or count would be about nothing
  NoReferent,        // "no-referent": a referring constraint picks out nothing
  NoDistractor,      // "no-distractor": … or excludes nothing
  NotReachable,      // "not-reachable": the body cannot stand where it could reach and see something needed
  NotCalm,           // "not-calm": what was put in place does not stay there
  NoSpot,            // "no-spot": nothing could be put where the goal wants it, or its door meets something fixed
  NotTogether,       // "no-room-together": each finds a spot, but not all of them at once
  NotSeen,           // "not-seen": too small or too hidden to show clearly in any picture
};
std::string name_of(GroundingReason reason);

/// A failure inside grounding, before it becomes a Rejection.
struct GroundingFailure {
  GroundingReason reason = GroundingReason::CannotEnforce;
  std::string detail;
  std::string subject;  // id of the object that it is about, when there is one
};

}  // namespace unietp
