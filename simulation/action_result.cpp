#include "simulation/action_result.h"

#include <algorithm>

namespace unietp {

FailureReference reference_to(const Room& room) {
  std::string type = room.type;
  std::replace(type.begin(), type.end(), '_', ' ');
  return {room.id, "the " + type};
}

FailureReference in_words(std::string_view words) { return {"", std::string(words)}; }

FailureReference unknown_name(std::string_view name) { return {std::string(name), "of that name"}; }

ActionResult succeeded() { return {true, Failure::None, {}}; }

ActionResult failed(FailureDetail detail) {
  const Failure failure = info(detail.cause).failure;
  return {false, failure, std::move(detail)};
}

ActionResult failed(FailureCause cause, FailureReference object, FailureReference other) {
  return failed(FailureDetail{cause, std::move(object), std::move(other), {}});
}

}  // namespace unietp
