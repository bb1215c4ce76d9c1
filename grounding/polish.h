#pragma once

#include <functional>

#include "grounding/scene_editor.h"

namespace unietp {

/// Makes a start that is as asked look like the home it grew out of:
///
/// - what was moved or changed on the way and need not be is as in the home again;
/// - what is where or as hardly anything is (oddness_of) goes to a likelier place: a mug that was made dirty in a
///   cabinet goes into the sink.
///
/// Each such edit is kept only if `is_sound` of the scene afterwards. Deterministic; the tries are bounded.
void polish(SceneEditor& editor, const std::function<bool()>& is_sound);

}  // namespace unietp
