#pragma once

#include "core/rng.h"
#include "generator/specification.h"
#include "grounding/home.h"
#include "grounding/scene_editor.h"

namespace unietp {

/// Changes the home in ways that the task has no use for, so that it says little about a thing of the goal that the
/// start added or moved it. For each category of the goal of which things were added, things of kDecoys other
/// categories are added to the same rooms: categories that people keep there, those first of which the home has as many
/// as it had of the goal's, with models of the simulator where that has some. For each thing of the goal that was
/// moved, kDecoys others of the home are moved into its room. All are placed as SceneEditor places things, not where
/// the goal puts something, nor in one place, drawn among the usual ones of their category, that a task for them could
/// have named. Nothing of a category that the task speaks of is added or moved, and nothing is added that its words
/// could mean; nothing stays where it would be senseless. Deterministic. How many things were added or moved.
int add_decoys(SceneEditor& editor, const Specification& specification, const Home& home, Rng rng);

/// Categories for each one of the goal that was added to, things for each one that was moved.
inline constexpr int kDecoys = 7;

}  // namespace unietp
