#include "run/rejection_hints.h"

#include <algorithm>
#include <array>
#include <utility>

namespace unietp {
namespace {

// By how a person would go about it: what to look at first in the template, else in the scene or the knowledge.
constexpr std::array<std::pair<std::string_view, std::string_view>, 22> kHints{{
    {"no-binding",
     "no home has categories for all placeholders: relax `constraints` or the affordances of `parameters`, or try "
     "more homes"},
    {"no-referring-constraint", "choose categories with states or places that distinguish one object from the others"},
    {"no-wording", "the categories have no synonym, function or context; `unietp knowledge show` lists a category's"},
    {"lacks-furniture", "the homes lack this furniture: use other homes with --scenes, or choose another category"},
    {"lacks-room",
     "the homes lack this room type, or have several: use other homes with --scenes, or choose another room"},
    {"no-free-place", "there is no space left: require fewer objects in `init`, or more space with (fits-on A B n)"},
    {"not-calm", "an object does not come to rest where `init` wants it: choose another place or a smaller object"},
    {"no-room-together",
     "the objects are too large for the place that they share: choose fewer or smaller objects, or a larger place"},
    {"no-spot", "the goal has no room in these homes: choose smaller objects, a larger place, or other homes"},
    {"not-seen", "the object is too small in images: choose larger categories, or no --modes M3"},
    {"cannot-enforce",
     "`init` requires a property that this category cannot have, or that cannot be set up in a scene"},
    {"state-not-possible",
     "`init` requires a state that the category does not have: add its affordance to "
     "`parameters`"},
    {"start-not-met",
     "parts of `init` undo each other: state each relation once, from the side of the object that is put "
     "somewhere"},
    {"goal-holds-at-start", "the goal already holds: add to `init` that it is false"},
    {"part-of-goal-holds-at-start", "a part of the goal already holds: add to `init` that it is false"},
    {"empty-domain", "a `forall` or `count` has an empty domain: require objects of that category in `init`"},
    {"no-referent", "no object satisfies the referring constraint: require one in `init`"},
    {"no-distractor", "the referring constraint excludes no object: require another object of the category in `init`"},
    {"not-reachable", "the agent cannot reach it in these homes: try more homes"},
    {"no-plan",
     "the expert finds no plan: do the `constraints` require the tool (washes, heats, slices, …), and does the "
     "simulator offer the action?"},
    {"action-failed", "an action kept failing: see its feedback in the example; often a receptacle is too small"},
    {"mutation-succeeds", "the goal still holds without one of the steps: the goal requires less than the plan does"},
}};

}  // namespace

std::string_view hint_for(std::string_view reason) {
  if (reason.starts_with("gate-"))
    return "run `unietp template why-not` with this binding to see what would have to change";
  const auto found = std::find_if(kHints.begin(), kHints.end(), [&](const auto& hint) { return hint.first == reason; });
  return found == kHints.end() ? std::string_view() : found->second;
}

}  // namespace unietp
