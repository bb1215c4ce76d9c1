#include "generator/rejection.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

using Reason = RejectionReason;
using Stage = RejectionStage;

constexpr std::string_view kWhyNot = "run `unietp template why-not` with this binding to see what would have to change";

struct ReasonInfo {
  Reason reason;
  Stage stage;
  std::string_view name, hint;
};
// In the order of the enumeration. Hints say what to look at first in the template, else in the scene or the knowledge.
constexpr std::array<ReasonInfo, kRejectionReasonCount> kReasons{{
    {Reason::GateSimulator, Stage::Generator, "gate-simulator", kWhyNot},
    {Reason::GatePlaceholder, Stage::Generator, "gate-placeholder", kWhyNot},
    {Reason::GateAffordance, Stage::Generator, "gate-affordance", kWhyNot},
    {Reason::GateConstraint, Stage::Generator, "gate-constraint", kWhyNot},
    {Reason::GateStateOfCategory, Stage::Generator, "gate-state-of-category", kWhyNot},
    {Reason::GateExclusiveStates, Stage::Generator, "gate-exclusive-states", kWhyNot},
    {Reason::GateOnePlace, Stage::Generator, "gate-one-place", kWhyNot},
    {Reason::GateCapacity, Stage::Generator, "gate-capacity", kWhyNot},
    {Reason::GateCounts, Stage::Generator, "gate-counts", kWhyNot},
    {Reason::GateStart, Stage::Generator, "gate-start", kWhyNot},
    {Reason::GateFalseAtStart, Stage::Generator, "gate-false-at-start", kWhyNot},
    {Reason::GateReachable, Stage::Generator, "gate-reachable", kWhyNot},
    {Reason::NoBinding, Stage::Generator, "no-binding",
     "no home has categories for all placeholders: relax `constraints` or the affordances of `parameters`, or try "
     "more homes"},
    {Reason::NoReferringConstraint, Stage::Generator, "no-referring-constraint",
     "choose categories with states or places that distinguish one object from the others"},
    {Reason::NoWording, Stage::Generator, "no-wording",
     "the categories have no synonym, function or context; `unietp knowledge show` lists a category's"},
    {Reason::Senseless, Stage::Generator, "senseless",
     "choose categories that people use so (`unietp sense` explains a grade), or allow it with --sense any"},
    {Reason::NoLayout, Stage::Grounding, "no-layout", ""},
    {Reason::UnknownCategory, Stage::Grounding, "unknown-category", ""},
    {Reason::LacksRoom, Stage::Grounding, "lacks-room",
     "the homes lack this room type, or have several: use other homes with --scenes, or choose another room"},
    {Reason::LacksFurniture, Stage::Grounding, "lacks-furniture",
     "the homes lack this furniture: use other homes with --scenes, or choose another category"},
    {Reason::NoFreePlace, Stage::Grounding, "no-free-place",
     "there is no space left: require fewer objects in `init`, or more space with (fits-on A B n)"},
    {Reason::StateNotPossible, Stage::Grounding, "state-not-possible",
     "`init` requires a state that the category does not have: add its affordance to "
     "`parameters`"},
    {Reason::CannotEnforce, Stage::Grounding, "cannot-enforce",
     "`init` requires a property that this category cannot have, or that cannot be set up in a scene"},
    {Reason::StartNotMet, Stage::Grounding, "start-not-met",
     "parts of `init` undo each other: state each relation once, from the side of the object that is put "
     "somewhere"},
    {Reason::GoalHolds, Stage::Grounding, "goal-holds-at-start",
     "the goal already holds: add to `init` that it is false"},
    {Reason::PartHolds, Stage::Grounding, "part-of-goal-holds-at-start",
     "a part of the goal already holds: add to `init` that it is false"},
    {Reason::EmptyDomain, Stage::Grounding, "empty-domain",
     "a `forall` or `count` has an empty domain: require objects of that category in `init`"},
    {Reason::NoReferent, Stage::Grounding, "no-referent",
     "no object satisfies the referring constraint: require one in `init`"},
    {Reason::NoDistractor, Stage::Grounding, "no-distractor",
     "the referring constraint excludes no object: require another object of the category in `init`"},
    {Reason::NotReachable, Stage::Grounding, "not-reachable",
     "the agent cannot reach it in these homes: try more homes"},
    {Reason::NotCalm, Stage::Grounding, "not-calm",
     "an object does not come to rest where `init` wants it: choose another place or a smaller object"},
    {Reason::NoSpot, Stage::Grounding, "no-spot",
     "the goal has no room in these homes: choose smaller objects, a larger place, or other homes"},
    {Reason::NotTogether, Stage::Grounding, "no-room-together",
     "the objects are too large for the place that they share: choose fewer or smaller objects, or a larger place"},
    {Reason::NotSeen, Stage::Grounding, "not-seen",
     "the object is too small in images: choose larger categories, or no --modes M3"},
    {Reason::OddReference, Stage::Grounding, "odd-reference",
     "in these homes nobody tells the objects apart by that (docs/gate.md): choose another reference or other "
     "categories, or allow it with --sense any"},
    {Reason::LooksAlike, Stage::Grounding, "looks-alike",
     "the color, material or state that tells the objects apart does not show: choose another one, or other "
     "categories"},
    {Reason::OddStart, Stage::Grounding, "odd-start",
     "few homes look as `init` and the goal's parts want it: require less in `init`, choose categories of which homes "
     "have fewer, or allow it with --sense any"},
    {Reason::NoWords, Stage::Annotator, "no-words", ""},
    {Reason::NoPlan, Stage::Expert, "no-plan",
     "the expert finds no plan: do the `constraints` require the tool (washes, heats, slices, …), and does the "
     "simulator offer the action?"},
    {Reason::ActionFailed, Stage::Expert, "action-failed",
     "an action kept failing: see its feedback in the example; often a receptacle is too small"},
    {Reason::TooManySteps, Stage::Expert, "too-many-steps", ""},
    {Reason::TooManyFailures, Stage::Expert, "too-many-failures", ""},
    {Reason::GoalNotMet, Stage::Expert, "goal-not-met", ""},
    {Reason::MutationSucceeds, Stage::Expert, "mutation-succeeds",
     "the goal still holds without one of the steps: the goal requires less than the plan does"},
    {Reason::NotTempting, Stage::Expert, "not-tempting",
     "nobody who forgets the order, or what has to stay as it is, would break it in as few steps: let `init` offer "
     "such "
     "a way"},
    {Reason::NotInM2, Stage::Expert, "not-in-m2", ""},
    {Reason::NotInM3, Stage::Expert, "not-in-m3", ""},
    {Reason::DuplicateStart, Stage::Pipeline, "duplicate-start", ""},
    {Reason::DuplicateText, Stage::Pipeline, "duplicate-text", ""},
    {Reason::Rejected, Stage::Review, "rejected", ""},
}};
static_assert([] {
  for (std::size_t i = 0; i < kReasons.size(); ++i) {
    if (kReasons[i].reason != static_cast<Reason>(i)) return false;
  }
  return true;
}());

const ReasonInfo& info(Reason reason) { return kReasons[static_cast<std::size_t>(reason)]; }

}  // namespace

std::string_view name_of(RejectionStage stage) {
  constexpr std::array<std::string_view, 6> kNames{"generator", "grounding", "annotator",
                                                   "expert",    "pipeline",  "review"};
  return kNames[static_cast<std::size_t>(stage)];
}

std::string_view name_of(RejectionReason reason) { return info(reason).name; }

std::optional<RejectionReason> rejection_reason_named(std::string_view name) {
  const auto found = std::find_if(kReasons.begin(), kReasons.end(), [&](const auto& one) { return one.name == name; });
  return found == kReasons.end() ? std::nullopt : std::optional(found->reason);
}

RejectionStage stage_of(RejectionReason reason) { return info(reason).stage; }

std::string_view hint_for(RejectionReason reason) { return info(reason).hint; }

}  // namespace unietp
