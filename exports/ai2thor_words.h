#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "logic/vocabulary.h"
#include "scene/action.h"

namespace unietp {

// What AI2-THOR calls our states and actions. Source: AI2-THOR 5.0.0 and the pages "Object State Changes", "Interactive
// Physics", "Navigation" and "Object Types" of its documentation (https://ai2thor.allenai.org/ithor/documentation,
// Apache-2.0); the sequences of calls with an appliance are those of ALFRED's demonstrations (Shridhar et al., 2020).

/// A state as AI2-THOR's metadata of an object shows it, and the call that brings it about without a tool.
struct ThorState {
  Predicate state;
  std::string_view key;                        // "isOpen"
  std::variant<bool, std::string_view> value;  // of the key; of `Filled`, which names a liquid, none
  std::string_view call = {};                  // "OpenObject"; "" when AI2-THOR has none
};
/// The row of a state, or nullptr when the metadata does not show it.
const ThorState* thor_state(Predicate state);

/// The object that a call refers to. Others: each object that the step changes, except its argument and the held one;
/// a tap also cleans what is in its basin.
enum class ThorTarget { Nothing, Argument, Held, Pose, Others };
/// When a step needs a call. Closed, Running: the target is so before the step. Closes: it is closed after it. Cleans,
/// Fills: the step cleans, or fills, the target.
enum class ThorWhen { Always, Closed, Running, Closes, Cleans, Fills };
struct ThorCall {
  std::string_view action;  // "PickupObject"
  ThorTarget target = ThorTarget::Nothing;
  ThorWhen when = ThorWhen::Always;
};
/// An action with a tool.
struct ThorActionRow {
  ActionType action;
  std::string_view tool;  // a category; "" for every one, where no row above names it
  std::span<const ThorCall> calls;
};
/// All rows.
std::span<const ThorState> thor_states();
std::span<const ThorActionRow> thor_actions();
/// The calls of an action; nothing when AI2-THOR does not have it with this tool (a category).
std::optional<std::span<const ThorCall>> thor_calls(ActionType action, std::string_view tool);

/// The part of an object that holds things in its place: a basin of a sink; "" for other categories.
std::string_view thor_holding_part(std::string_view category);

}  // namespace unietp
