#pragma once

#include "core/rng.h"
#include "generator/specification.h"
#include "grounding/home.h"
#include "grounding/scene_editor.h"

namespace unietp {

/// Changes the home in ways that the task has no use for, so that it says little about a thing of the goal that the
/// start added or moved it, or that the home has several.
///
/// For each category of the goal of which things were added, things of kDecoys other categories are added to the same
/// rooms: categories that people keep there, those first of which the home has as many as it had of the goal's, of
/// these such as can be in the states of the first thing, with models of the simulator where that has some, and slices
/// for slices. Each is on or in the same kind of furniture as the thing that it is like, if it is kept there and finds
/// a place, and in its states, as far as it can be. Of a category of which the home has several and nothing was added,
/// kDecoys others that it has once less come first to be given one more, in any room. For each thing of the goal that
/// was moved, kMovedDecoys others of the home are moved into its room, first those that homes have there or not
/// (Household::is_found_in) as they do or do not have what was moved, of these such as are kept there about as often;
/// where homes do not have it there, and too few such others find a place, more go to other rooms where homes do not
/// have them. For each state that it was given, kRestatedDecoys others of the home are given it and its other states as
/// far as they can be, first those that share these, at most fifteen in all, if such things are in it at such places.
///
/// All are placed as SceneEditor places things, not where the goal puts something, nor in one place, drawn among the
/// usual ones of their category, that a task for them could have named. Nothing of a category that the task speaks of
/// is added or moved, and nothing is added that its words could mean. What is added or moved comes to where such things
/// usually are, unless it is to be in a room where homes do not have them, or few are in a state that it is to be in at
/// such places; nothing stays where it would be senseless. At most four come to one place, of which one is of a
/// category that homes do not have several of (Household::has_several) and three are of another; nothing comes to a
/// dish that holds something else, or on or in a movable thing that the task speaks of; of a category that homes do not
/// have several of, a home comes to have at most two, and at most two are moved or given a state, else four.
/// Deterministic. How many things were added, moved or given a state.
int add_decoys(SceneEditor& editor, const Specification& specification, const Home& home, Rng rng);

/// Categories for each one of the goal that was added to or that the home has several of.
inline constexpr int kDecoys = 7;
/// Things for each one of the goal that was moved: few of a home's own are in such rooms, as rooms go by what is kept
/// there.
inline constexpr int kMovedDecoys = 12;
/// Things for each state that a thing of the goal was given.
inline constexpr int kRestatedDecoys = 5;

}  // namespace unietp
