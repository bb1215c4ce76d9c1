#pragma once

#include "core/typed_id.h"

namespace unietp {

/// A moment of an episode; the start is the first. Worlds of one start at moments that are alike in all that can change
/// have equal ones.
using MomentId = TypedId<struct MomentTag>;

}  // namespace unietp
