#include "grounding/reasons.h"

namespace unietp {

std::string name_of(GroundingReason reason) {
  switch (reason) {
    case GroundingReason::UnknownCategory:
      return "unknown-category";
    case GroundingReason::LacksRoom:
      return "lacks-room";
    case GroundingReason::LacksFurniture:
      return "lacks-furniture";
    case GroundingReason::NoFreePlace:
      return "no-free-place";
    case GroundingReason::StateNotPossible:
      return "state-not-possible";
    case GroundingReason::CannotEnforce:
      return "cannot-enforce";
    case GroundingReason::StartNotMet:
      return "start-not-met";
    case GroundingReason::GoalHolds:
      return "goal-holds-at-start";
    case GroundingReason::PartHolds:
      return "part-of-goal-holds-at-start";
    case GroundingReason::EmptyDomain:
      return "empty-domain";
    case GroundingReason::NoReferent:
      return "no-referent";
    case GroundingReason::NoDistractor:
      return "no-distractor";
    case GroundingReason::NotReachable:
      return "not-reachable";
    case GroundingReason::NotCalm:
      return "not-calm";
    case GroundingReason::NoSpot:
      return "no-spot";
    case GroundingReason::NotTogether:
      return "no-room-together";
    case GroundingReason::NotSeen:
      return "not-seen";
  }
  return "cannot-enforce";
}

}  // namespace unietp
