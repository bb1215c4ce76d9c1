#pragma once

#include <string>
#include <string_view>

#include "scene/action.h"
#include "scene/scene.h"

namespace unietp {

/// What a failure refers to: an object, a room, a wall, an action, or a name that nothing has.
struct FailureReference {
  std::string id;      // "mug_1"; "" for what has no id
  std::string phrase;  // the same in words that hold no id: "the mug"
};
/// "the living room" for a room of that type.
FailureReference reference_to(const Room& room);
/// Something without an id, by its words.
FailureReference in_words(std::string_view words);
/// A name that an agent gave and nothing has: repeated to agents that name things by ids, to others "of that name".
FailureReference unknown_name(std::string_view name);

/// Why an action failed, as a value; simulation/feedback.h makes a sentence of it.
struct FailureDetail {
  FailureCause cause = FailureCause::None;
  FailureReference object, other;  // {object} and {other} of the cause's sentence, where it has them
  FailureReference tool;           // of an action ..._with, one step of which failed
};

/// What an action came to in the world.
struct ActionResult {
  bool success = false;
  Failure failure = Failure::None;  // that of the detail's cause
  FailureDetail detail;             // of a failure
};
/// A success, without detail.
ActionResult succeeded();
/// A failure of the kind that the cause belongs to.
ActionResult failed(FailureDetail detail);
/// The same, from the parts of the detail.
ActionResult failed(FailureCause cause, FailureReference object = {}, FailureReference other = {});

}  // namespace unietp
