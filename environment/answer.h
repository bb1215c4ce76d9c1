#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "environment/settings.h"
#include "scene/command.h"

namespace unietp {

/// A point of the picture; pixels.
struct PixelPoint {
  int x = 0, y = 0;
  bool operator==(const PixelPoint&) const = default;
};

/// One action of an answer.
struct AnsweredAction {
  Command command;
  std::optional<PixelPoint> point;  // in place of an argument: what the picture shows there
  bool operator==(const AnsweredAction&) const = default;
};

/// What an agent answered.
struct Answer {
  std::vector<AnsweredAction> actions;  // at least one
  std::string reasoning;                // "" when it gave none
  bool operator==(const Answer&) const = default;
};

/// The picture that boxes and points of an answer refer to.
struct AnswerFrame {
  BoxForm form = BoxForm::Pixels;
  int width = 0, height = 0;  // pixels
};

/// What parse_answer expected of an answer that it could not read as a whole; other sentences are about one field of
/// it.
inline constexpr std::string_view kExpectedJson = "expected one JSON object with \"action\" and \"args\"";
inline constexpr std::string_view kExpectedOneObject = "expected one JSON object, not several";
inline constexpr std::string_view kExpectedAction = "expected the name of an action in \"action\"";

/// Reads what an agent said, any bytes. Accepted are
///  - {"action": "pick_up", "args": ["mug_1"]}, also with "reasoning"; an argument may be {"bbox": [x0, y0, x1, y1]}
///    or {"point": [x, y]}; "args" may be missing, or one argument without the list;
///  - a list of such objects, or {"actions": [...]} with them;
///  - the form of the released runner: {"reasoning": "...", "actions": [{"action_name": "pick up", "args":
///  {"object_id":
///    "mug_1"}}]} with "room_id", "tool_id", "pixel", "object_bbox" and `done`;
///  - pick_up(mug_1), as actions are written in texts.
/// JSON may stand in a fenced block, or in other text when it is the only JSON object or list in it.
/// Errors: Schema, with a sentence fragment for the agent that says what was expected and repeats nothing of the
/// answer. Limits: limits::kAgentAnswerBytes, limits::kAgentActions, limits::kLabelBytes for names. Never throws.
Result<Answer> parse_answer(std::string_view text, const AnswerFrame& frame);

/// What the released runner calls an action of ours: "pick up", "heat the object in hand with", "done" for `stop`.
std::string release_action_name(std::string_view ours);

}  // namespace unietp
