#pragma once

#include <string>

#include "generator/rejection.h"

namespace unietp {

/// A failure inside grounding, before it becomes a Rejection.
struct GroundingFailure {
  RejectionReason reason = RejectionReason::CannotEnforce;
  std::string detail;
  std::string subject;  // id of the object that it is about, when there is one
};

}  // namespace unietp
