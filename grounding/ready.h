#pragma once

#include <functional>

#include "generator/specification.h"
#include "grounding/scene_editor.h"

namespace unietp {

/// Brings what the goal uses into the state in which people find such things (UseStates), where neither the goal nor
/// the constraints of the start speak of that state: cups that are set on a table are clean, the plates that stand
/// about are dirty when one goes into the dishwasher, the schnitzel that is warmed up is cooked.
///
/// Left as they are: a thing at a place where hardly anything is in that state; what is put away, when it would become
/// dirty; what waits to be washed, when enough others are clean. All edits are kept only if `is_sound` of the scene
/// afterwards. Deterministic.
void make_ready(SceneEditor& editor, const Specification& specification, const std::function<bool()>& is_sound);

}  // namespace unietp
