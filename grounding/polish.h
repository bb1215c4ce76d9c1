#pragma once

#include <functional>

#include "grounding/goal_places.h"
#include "grounding/scene_editor.h"

namespace unietp {

/// Makes a start that is as asked look like the home it grew out of:
///
/// - what was moved or changed on the way and need not be is as in the home again;
/// - what is where or as hardly anything is (oddness_of) goes to a likelier place: a mug that was made dirty in a
///   cabinet goes into the sink;
/// - when all things of a category that is to go where things are washed are put away (PlaceUse::PutAway), as if they
///   were clean, one of them goes elsewhere; and what waits to be washed though the goal wants it elsewhere, or in
///   another machine of that kind, is not there yet. `places`: where the goal puts things.
///
/// Each such edit is kept only if `is_sound` of the scene afterwards. Deterministic; the tries are bounded.
void polish(SceneEditor& editor, const GoalPlaces& places, const std::function<bool()>& is_sound);

}  // namespace unietp
