#pragma once

#include <string>

#include "scene/action.h"
#include "simulation/action_result.h"
#include "simulation/outcome.h"

namespace unietp {

/// A failure without the ids of what it refers to: all that the wording for M2 and M3 is given, so that no id of the
/// scene can be in it, whatever ids look like.
struct FailureWithoutIds {
  FailureCause cause = FailureCause::None;
  std::string object, other, tool;  // phrases, "" where there is none
};
/// Keeps the phrases and drops the ids.
FailureWithoutIds without_ids(const FailureDetail& failure);

/// For agents that know all ids (M1): "mug_1 is out of reach; go to it first."
std::string feedback_with_ids(const FailureDetail& failure);
/// For the other modes: "The mug is out of reach; go to it first."
std::string feedback_in_words(const FailureWithoutIds& failure);
/// The result with one of the two.
Outcome outcome_of(const ActionResult& result, bool with_ids);
/// With ids in M1 alone.
Outcome outcome_in(Mode mode, const ActionResult& result);

}  // namespace unietp
