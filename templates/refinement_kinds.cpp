#include "templates/refinement_kinds.h"

#include <array>

namespace unietp {
namespace {

using enum Split;

constexpr std::array<RefinementKind, 23> kKinds = {{
    {"referring", InstanceGrounding, true, "the goal itself says which objects are meant, by its :where"},
    {"by-state", InstanceGrounding, false, "the dirty mug"},
    {"by-relation", InstanceGrounding, false, "the mug on the desk, in the sink, next to the laptop"},
    {"by-room", InstanceGrounding, false, "the mug in the kitchen"},
    {"by-nearness", InstanceGrounding, false, "the mug nearest to the sink"},
    {"by-size", InstanceGrounding, false, "the larger mug"},
    {"by-attribute", InstanceGrounding, false, "the red mug, the wooden table"},
    {"by-two", InstanceGrounding, false, "two constraints that only together tell which: the dirty mug on the desk"},
    {"each-its-own", InstanceGrounding, false, "two placeholders of one category: the red mug and the blue one"},
    {"alias", Linguistic, true, "objects under other names"},
    {"function", Linguistic, false, "something to drink from"},
    {"context", Linguistic, true, "a sentence before that gives the occasion"},
    {"distractor", Linguistic, true, "something else is mentioned, which has to stay as it is"},
    {"negation", Linguistic, true, "a part of the goal is said by what must not be"},
    {"relative-clause", Linguistic, true, "an object is named by what is done to it"},
    {"inverted-order", Linguistic, true, "what comes later is said first"},
    {"coreference", Linguistic, true, "a place is named by what is kept there"},
    {"implicit-need", Linguistic, true, "the need is said, and what to do follows from it"},
    {"vague-quantity", Linguistic, true, "a couple, a few"},
    {"background", Linguistic, true, "sentences before that give some background and ask for nothing"},
    {"bystander", Linguistic, true, "something of the home is named that the goal has nothing to do with"},
    {"nested-syntax", Linguistic, true, "one long sentence with clauses inside clauses"},
    {"condition", Linguistic, true, "tied to a condition that the start meets: if a fridge is closed, ..."},
}};

}  // namespace

std::span<const RefinementKind> refinement_kinds() { return kKinds; }

const RefinementKind* refinement_kind(std::string_view name) {
  for (const auto& kind : kKinds) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

Split split_of_tasks(const Template& source) {
  const auto* kind = refinement_kind(source.refinement);
  return kind == nullptr ? source.split : kind->split;
}

}  // namespace unietp
