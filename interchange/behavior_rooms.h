#pragma once

#include "interchange/source_scene.h"

namespace unietp {

/// Rooms from the pieces of floor that BEHAVIOR scenes have as objects, each of one room ("kitchen_0"): their outline,
/// less the smaller rooms that overlap it (a floor's box is drawn around all of it). A room that would leave a hole in
/// another becomes part of it, and so do its objects. Without floors there are no rooms.
void add_floor_rooms(SourceScene& scene);

}  // namespace unietp
