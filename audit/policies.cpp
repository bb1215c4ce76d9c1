#include "audit/policies.h"

namespace unietp {
namespace {

using Option = GuessOption;
using Scope = ShuffleScope;

const LeakChannel kLeakingOrder{"order of the list", {{Scope::InList, {&Option::place}}}};
const LeakChannel kLeakingNumber{"numbers of ids", {{Scope::WithinKind, {&Option::number, &Option::number_rank}}}};
const LeakChannel kLeakingWhich{"numbers of ids", {{Scope::All, {&Option::number, &Option::number_rank}}}};
const LeakChannel kLeakingOrderOfKind{"order of the list", {{Scope::All, {&Option::place}}}};
// What is in view is listed by id, so by kind, and the picture shows kinds: only the order within a kind may leak.
const LeakChannel kLeakingOrderInView{"order of the list", {{Scope::WithinKind, {&Option::place}}}};
const LeakChannel kLeakingCount{"number of its kind", {{Scope::AcrossKinds, {&Option::of_kind}}}};
const LeakChannel kLeakingMore{"number of its kind", {{Scope::AcrossKinds, {&Option::more}}}};
const LeakChannel kLeakingElsewhere{"frequency of its kind", {{Scope::AcrossKinds, {&Option::elsewhere}}}};
const LeakChannel kLeakingStates{"states", {{Scope::All, {&Option::odd_states}}}};
const LeakChannel kLeakingAlike{"states", {{Scope::All, {&Option::alike}}}};
const LeakChannel kLeakingSupport{"what it is on or in", {{Scope::All, {&Option::odd_support}}}};
const LeakChannel kLeakingRoom{"room", {{Scope::All, {&Option::odd_room}}}};
const LeakChannel kLeakingAsset{"model", {{Scope::All, {&Option::odd_asset}}}};
const LeakChannel kLeakingDistance{"distance from the start", {{Scope::All, {&Option::distance}}}};
const LeakChannel kLeakingBox{"box", {{Scope::All, {&Option::area, &Option::low_edge}}}};
const LeakChannel kLeakingText{"numbers of ids, order", {{Scope::All, {&Option::number_rank, &Option::place}}}};
// A model knows the kinds, and some are found in more states and places than others: among all things, these would
// tell less of a thing's kind than they do in homes, and any model that has learned from them would do worse.
const LeakChannel kLeakingAll{
    "ids, order, states, places",
    {{Scope::InList, {&Option::place}},
     {Scope::WithinKind, {&Option::number, &Option::number_rank}},
     {Scope::OfAnyHome,
      {&Option::odd_states, &Option::alike, &Option::odd_support, &Option::odd_room, &Option::odd_asset}}}};
const LeakChannel kLeakingAllOfKind{"ids, order, states, places",
                                    {{Scope::All,
                                      {&Option::place, &Option::number, &Option::number_rank, &Option::odd_states,
                                       &Option::alike, &Option::odd_support, &Option::odd_room, &Option::odd_asset}}}};

constexpr std::string_view kKnowsNothing = "the list alone";
constexpr std::string_view kKnowsOthers = "the list, other homes";
constexpr std::string_view kKnowsKind = "what kind is meant";
constexpr std::string_view kKnowsPicture = "what the first picture shows";

template <float Option::*field, int sign>
float signed_field(const Option& option, const ModelsOfPart&) {
  return static_cast<float>(sign) * option.*field;
}
/// A field first, then the place in the list.
template <float Option::*field, int sign>
float field_then_place(const Option& option, const ModelsOfPart&) {
  return 1000 * option.*field + static_cast<float>(sign) * option.place;
}
template <int sign>
float named_then_place(const Option& option, const ModelsOfPart&) {
  return (option.is_named ? 10.0F : 0.0F) + static_cast<float>(sign) * option.place;
}
float gap(float a, float b) { return a < b ? b - a : a - b; }
float near_expected(const Option& option, const ModelsOfPart&) {
  return -gap(option.number_rank, option.expected_rank) - gap(option.place, option.expected_place);
}
float near_text(const Option& option, const ModelsOfPart&) { return -gap(option.number_rank, option.text_rank); }
float by_list(const Option& option, const ModelsOfPart& models) { return models.small_things->value(option); }
float by_kind(const Option& option, const ModelsOfPart& models) { return models.of_kind->value(option); }

}  // namespace

const std::vector<ShortcutPolicy>& shortcut_policies() {
  using enum GuessChoice;
  static const std::vector<ShortcutPolicy> policies{
      // Something small that the goal needs.
      {"last-listed", kKnowsNothing, SmallThing, &kLeakingOrder, signed_field<&Option::place, 1>},
      {"first-listed", kKnowsNothing, SmallThing, &kLeakingOrder, signed_field<&Option::place, -1>},
      {"highest-number", kKnowsNothing, SmallThing, &kLeakingNumber, signed_field<&Option::number, 1>},
      {"rarest-kind", kKnowsNothing, SmallThing, &kLeakingCount, signed_field<&Option::of_kind, -1>},
      {"commonest-kind", kKnowsNothing, SmallThing, &kLeakingCount, signed_field<&Option::of_kind, 1>},
      {"more-than-elsewhere", kKnowsOthers, SmallThing, &kLeakingMore, signed_field<&Option::more, 1>},
      {"fewer-than-elsewhere", kKnowsOthers, SmallThing, &kLeakingMore, signed_field<&Option::more, -1>},
      {"kind-of-no-other-home", kKnowsOthers, SmallThing, &kLeakingElsewhere, signed_field<&Option::elsewhere, -1>},
      {"unusual-state", kKnowsOthers, SmallThing, &kLeakingStates, signed_field<&Option::odd_states, 1>},
      {"unusual-place", kKnowsOthers, SmallThing, &kLeakingSupport, signed_field<&Option::odd_support, 1>},
      {"unusual-room", kKnowsOthers, SmallThing, &kLeakingRoom, signed_field<&Option::odd_room, 1>},
      {"unusual-model", kKnowsOthers, SmallThing, &kLeakingAsset, signed_field<&Option::odd_asset, 1>},
      {"nearest-to-start", "the list, where things are", SmallThing, &kLeakingDistance,
       signed_field<&Option::distance, -1>},
      {"named-then-last", "the words of the instruction", SmallThing, &kLeakingOrder, named_then_place<1>},
      {"named-then-first", "the words of the instruction", SmallThing, &kLeakingOrder, named_then_place<-1>},
      {"goal-of-template", "the goals of the template in other homes", SmallThing, &kLeakingOrder,
       field_then_place<&Option::template_share, 1>},
      {"usual-goal", "how often a kind is needed in other homes", SmallThing, &kLeakingOrder,
       field_then_place<&Option::goal_share, 1>},
      {"list-classifier", "the list, solved tasks of other homes", SmallThing, &kLeakingAll, by_list},
      // Furniture that the goal needs.
      {"last-furniture", kKnowsNothing, Furniture, &kLeakingOrder, signed_field<&Option::place, 1>},
      {"first-furniture", kKnowsNothing, Furniture, &kLeakingOrder, signed_field<&Option::place, -1>},
      {"furniture-of-no-other-home", kKnowsOthers, Furniture, &kLeakingElsewhere, signed_field<&Option::elsewhere, -1>},
      {"more-furniture-than-elsewhere", kKnowsOthers, Furniture, &kLeakingMore, signed_field<&Option::more, 1>},
      {"furniture-in-unusual-room", kKnowsOthers, Furniture, &kLeakingRoom, signed_field<&Option::odd_room, 1>},
      {"unusual-furniture-model", kKnowsOthers, Furniture, &kLeakingAsset, signed_field<&Option::odd_asset, 1>},
      {"unusual-furniture-state", kKnowsOthers, Furniture, &kLeakingStates, signed_field<&Option::odd_states, 1>},
      {"named-furniture-then-last", "the words of the instruction", Furniture, &kLeakingOrder, named_then_place<1>},
      // Which of several things of a kind.
      {"lowest-number-of-kind", kKnowsKind, OfKind, &kLeakingWhich, signed_field<&Option::number, -1>},
      {"highest-number-of-kind", kKnowsKind, OfKind, &kLeakingWhich, signed_field<&Option::number, 1>},
      {"first-of-kind", kKnowsKind, OfKind, &kLeakingOrderOfKind, signed_field<&Option::place, -1>},
      {"last-of-kind", kKnowsKind, OfKind, &kLeakingOrderOfKind, signed_field<&Option::place, 1>},
      {"nearest-of-kind", kKnowsKind, OfKind, &kLeakingDistance, signed_field<&Option::distance, -1>},
      {"only-one-in-its-state", kKnowsKind, OfKind, &kLeakingAlike, signed_field<&Option::alike, -1>},
      {"unusual-state-of-kind", "what kind is meant, other homes", OfKind, &kLeakingStates,
       signed_field<&Option::odd_states, 1>},
      {"unusual-place-of-kind", "what kind is meant, other homes", OfKind, &kLeakingSupport,
       signed_field<&Option::odd_support, 1>},
      {"unusual-model-of-kind", "what kind is meant, other homes", OfKind, &kLeakingAsset,
       signed_field<&Option::odd_asset, 1>},
      {"nearest-instruction", "the instruction, solved tasks of other homes", OfKind, &kLeakingText, near_expected},
      {"text-classifier", "the instruction, solved tasks of other homes", OfKind, &kLeakingWhich, near_text},
      {"kind-classifier", "what kind is meant, solved tasks of other homes", OfKind, &kLeakingAllOfKind, by_kind},
      // The room of something small that the goal needs.
      {"first-room", kKnowsNothing, Room, &kLeakingOrder, signed_field<&Option::place, -1>},
      {"last-room", kKnowsNothing, Room, &kLeakingOrder, signed_field<&Option::place, 1>},
      {"room-of-start", "the list, where the agent is", Room, &kLeakingDistance, signed_field<&Option::distance, -1>},
      {"usual-room", "rooms of other homes' goals", Room, &kLeakingOrder, field_then_place<&Option::goal_share, -1>},
      // Something in the first picture that the goal needs.
      {"first-in-view", kKnowsPicture, InView, &kLeakingOrderInView, signed_field<&Option::place, -1>},
      {"last-in-view", kKnowsPicture, InView, &kLeakingOrderInView, signed_field<&Option::place, 1>},
      {"largest-in-view", kKnowsPicture, InView, &kLeakingBox, signed_field<&Option::area, 1>},
      {"lowest-in-view", kKnowsPicture, InView, &kLeakingBox, signed_field<&Option::low_edge, 1>},
      // What the demonstration begins with.
      {"usual-first-object", "first actions in other homes", FirstObject, &kLeakingOrder,
       field_then_place<&Option::first_share, 1>},
      {"first-object-last-listed", kKnowsNothing, FirstObject, &kLeakingOrder, signed_field<&Option::place, 1>},
  };
  return policies;
}

}  // namespace unietp
