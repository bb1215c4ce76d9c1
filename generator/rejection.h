#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scene/action.h"

namespace unietp {

/// The stage that gives a candidate up.
enum class RejectionStage : std::uint8_t {
  Generator,
  Grounding,
  Annotator,
  Expert,
  Pipeline,  // the choice among finished candidates
  Review,    // by a person
};
/// "generator", as in files.
std::string_view name_of(RejectionStage stage);

/// Why a candidate is given up: a counted outcome, not an error. Each reason belongs to one stage; files name both.
enum class RejectionReason : std::uint8_t {
  // generator: one for each gate (generator/gate.h), then what it has no choice for
  GateSimulator,
  GatePlaceholder,
  GateAffordance,
  GateConstraint,
  GateStateOfCategory,
  GateExclusiveStates,
  GateOnePlace,
  GateCapacity,
  GateCounts,
  GateStart,
  GateFalseAtStart,
  GateReachable,
  NoBinding,              // no home has categories for all placeholders
  NoReferringConstraint,  // nothing distinguishes an object from others of its category
  NoWording,              // no category has a word for the style that was asked for
  Senseless,              // nobody in a home would ask for it
  // grounding
  NoLayout,          // the home could not be made
  UnknownCategory,   // the knowledge lacks a category that the start must have
  LacksRoom,         // the home has no room of a type that is needed, or not the number
  LacksFurniture,    // furniture is missing and finds no place
  NoFreePlace,       // an object finds no place to rest; the detail says what it hit
  StateNotPossible,  // a category cannot have a state that is asked for
  CannotEnforce,     // no edit of a scene brings this about
  StartNotMet,       // after all rounds a start constraint is still false
  GoalHolds,
  PartHolds,
  EmptyDomain,   // a forall or count would be about nothing
  NoReferent,    // a referring constraint picks out nothing
  NoDistractor,  // … or excludes nothing
  NotReachable,  // the body cannot stand where it could reach and see something needed
  NotCalm,       // what was put in place does not stay there
  NoSpot,        // nothing could be put where the goal wants it, or its door meets something fixed
  NotTogether,   // each finds a spot, but not all of them at once
  NotSeen,       // too small or too hidden to show clearly in any picture
  OddReference,  // nobody in this home would tell the objects apart by that
  LooksAlike,    // a color, material or state that the words tell things apart by does not show
  OddStart,      // nobody's home looks as the start would have to
  // annotator
  NoWords,
  // expert
  NoPlan,
  ActionFailed,
  TooManySteps,
  TooManyFailures,
  GoalNotMet,
  MutationSucceeds,  // a step may be left out and the goal still holds
  NotTempting,       // no plan as short breaks the goal's order or what has to stay
  NotInM2,
  NotInM3,
  // pipeline
  DuplicateStart,
  DuplicateText,
  // review
  Rejected,
};
/// Number of reasons.
inline constexpr std::size_t kRejectionReasonCount = static_cast<std::size_t>(RejectionReason::Rejected) + 1;

std::string_view name_of(RejectionReason reason);  // "no-free-place"
/// nullopt for an unknown name.
std::optional<RejectionReason> rejection_reason_named(std::string_view name);
/// The one stage that gives this reason.
RejectionStage stage_of(RejectionReason reason);
/// What most likely has to change in a template whose candidates are given up for this reason, in one sentence; "" for
/// a reason that says all itself.
std::string_view hint_for(RejectionReason reason);

/// A candidate's reason, with what it was about.
struct Rejection {
  RejectionReason reason = RejectionReason::NoPlan;
  std::string detail;               // a sentence with template, categories and, for a placement, what it hit
  Failure failure = Failure::None;  // of the action that the expert could not do; None where that was not the reason
};

}  // namespace unietp
