#include "run/rejection_hints.h"

#include <algorithm>
#include <array>
#include <utility>

namespace unietp {
namespace {

// By how a person would go about it: what to look at first in the template, else in the scene or the knowledge.
constexpr std::array<std::pair<std::string_view, std::string_view>, 22> kHints{{
    {"no-binding",
     "no home offers categories for all placeholders: loosen `constraints` or the affordances of `parameters`, or try "
     "more homes"},
    {"no-referring-constraint", "choose categories with states or places by which one of them can be told apart"},
    {"no-wording", "the categories have no synonym, function or context; `unietp knowledge show` lists a category's"},
    {"lacks-furniture", "the homes lack that furniture: give others with --scenes, or choose another category"},
    {"lacks-room",
     "the homes lack that type of room, or have several: give others with --scenes, or choose another room"},
    {"no-free-place", "there is no space left: demand fewer objects in `init`, or ask for more with (fits-on A B n)"},
    {"not-calm", "something does not come to rest where `init` wants it: another place or a smaller object"},
    {"no-room-together", "what is to share a place is too large for it: fewer or smaller objects, or a larger place"},
    {"no-spot", "what the goal wants has no room in these homes: smaller objects, a larger place, or other homes"},
    {"not-seen", "it is too small for pictures: larger categories, or make tasks without --modes M3"},
    {"cannot-enforce", "`init` asks for something that this category cannot be or that the scene cannot be given"},
    {"state-not-possible",
     "`init` asks for a state that the category does not have: ask for its affordance in "
     "`parameters`"},
    {"start-not-met",
     "parts of `init` undo each other: say each thing once, from the side of the object that is put "
     "somewhere"},
    {"goal-holds-at-start", "nothing is left to do: add to `init` that the goal does not hold yet"},
    {"part-of-goal-holds-at-start", "a part of the goal needs no action: add to `init` that this part is false"},
    {"empty-domain", "a `forall` or `count` ranges over nothing: demand objects of that category in `init`"},
    {"no-referent", "no object is what the referring constraint describes: let `init` demand one"},
    {"no-distractor", "nothing is excluded by the referring constraint: let `init` demand another of the category"},
    {"not-reachable", "the agent cannot get at it in these homes: try more homes"},
    {"no-plan",
     "the expert finds no way: does `constraints` ask for the tool (washes, heats, slices, …), and does the "
     "simulator offer the action?"},
    {"action-failed", "an action kept failing: see its feedback in the example; often a receptacle that is too small"},
    {"mutation-succeeds", "a step may be left out and the goal still holds: the goal asks for less than the plan does"},
}};

}  // namespace

std::string_view hint_for(std::string_view reason) {
  if (reason.starts_with("gate-")) return "`unietp template why-not` with this binding says what would have to change";
  const auto found = std::find_if(kHints.begin(), kHints.end(), [&](const auto& hint) { return hint.first == reason; });
  return found == kHints.end() ? std::string_view() : found->second;
}

}  // namespace unietp
