#include "templates/refinement_kinds.h"

#include <array>

namespace unietp {
namespace {

using enum Split;

constexpr std::array<RefinementKind, 28> kRefinements = {{
    {"referring", InstanceGrounding, true, "the goal itself identifies its objects, with a :where"},
    {"by-state", InstanceGrounding, false, "the dirty mug"},
    {"by-relation", InstanceGrounding, false, "the mug on the desk, in the sink, next to the laptop"},
    {"by-room", InstanceGrounding, false, "the mug in the kitchen"},
    {"by-nearness", InstanceGrounding, false, "the mug nearest to the sink"},
    {"by-size", InstanceGrounding, false, "the larger mug"},
    {"by-attribute", InstanceGrounding, false, "the red mug, the wooden table"},
    {"by-two", InstanceGrounding, false,
     "two constraints that identify an object only together: the dirty mug on the desk"},
    {"each-its-own", InstanceGrounding, false, "two placeholders of one category: the red mug and the blue one"},
    {"alias", Linguistic, true, "objects are called by synonyms"},
    {"function", Linguistic, false, "something to drink from"},
    {"hypernym", Linguistic, false, "a piece of cutlery"},
    {"description", Linguistic, false, "the place where we wash our hands"},
    {"context", Linguistic, false, "a first sentence decides which thing is meant: I want to make a salad."},
    {"request", Linguistic, false, "a state is asked for without saying so: it's too dark to read"},
    {"aside", Linguistic, true, "first sentences that are true in this home and do not matter"},
    {"exception", Linguistic, false, "every mug but the red one"},
    {"ellipsis", Linguistic, false, "there is more than one mug here; wash the red one"},
    {"anaphora", Linguistic, false, "there is a mug on the desk; wash it"},
    {"compound", Linguistic, false, "the kitchen cabinet"},
    {"distractor", Linguistic, true, "something else is mentioned that must stay as it is"},
    {"negation", Linguistic, true, "a part of the goal is stated as what must not hold"},
    {"subordinate-clause", Linguistic, true, "a clause with \"once\" says what is put where before the rest is asked"},
    {"inverted-order", Linguistic, true, "the later part comes first in the sentence"},
    {"coreference", Linguistic, true, "a place is described by what is kept there"},
    {"implicit-need", Linguistic, true, "only the need is stated; the action follows from it"},
    {"vague-quantity", Linguistic, true, "a couple, a few"},
    {"condition", Linguistic, true, "starts with a condition that holds at the start: if a fridge is closed, ..."},
}};

}  // namespace

std::span<const RefinementKind> refinement_kinds() { return kRefinements; }

const RefinementKind* refinement_kind(std::string_view name) {
  for (const auto& kind : kRefinements) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

Split split_of_tasks(const Template& source) {
  const auto* kind = refinement_kind(source.refinement);
  return kind == nullptr ? source.split : kind->split;
}

}  // namespace unietp
