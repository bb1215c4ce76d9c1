#pragma once

#include "templates/template.h"

namespace unietp {

/// Whether the template's start needs a second room: something, or the agent, is not in the room that the task names.
/// A home of one room, as iTHOR's floor plans are, has no task of such a template.
bool needs_several_rooms(const Template& source);

}  // namespace unietp
