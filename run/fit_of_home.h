#pragma once

#include "annotator/noun_table.h"
#include "dataset/configuration.h"
#include "generator/place_in_room.h"
#include "generator/weighted_binding.h"
#include "grounding/household.h"
#include "resources/resources.h"
#include "run/layout_pool.h"

namespace unietp {

/// What a binding that is drawn for a home has to be: with it the goal makes at least so much sense, and the home has
/// the furniture and rooms that the template's start asks for, since no edit of a start gives it those, some of it in
/// rooms where people keep what the goal puts there, and there are words for `style` (has_words_for). Where the
/// configuration binds placeholders, a home that does not fit is accepted, to be refused with its reason later. What is
/// given must outlive it.
BindingCheck fits_home(const RunConfiguration& configuration, const Resources& resources, const Template& source,
                       const Layout& layout, Grade least, std::optional<Style> style);

/// Whether each place that things only pass through (Household::passes), and that the goal names without saying which,
/// is in a room where people keep what goes into it: a goal that any sink meets asks for no plates in the bathroom's.
/// What the home lacks is not looked at.
bool all_sinks_suit(const Formula& goal, const Layout& layout, const Household& household);

/// Whether the goal leaves open what nobody is indifferent about: which of several rooms of a type or of several
/// pieces of furniture in several rooms is meant, or which of several things that each belong to somebody
/// (Household::is_personal); or names furniture by a word that other furniture of the home could be meant by, too: "the
/// table" beside a coffee table, "the shelf" beside a shelving unit; or asks to open, close, empty, switch off or wipe
/// just one of several; or names what is carried by a word for other things of the home, too: "the bowl" beside a
/// mixing bowl; or calls two things by names of which one could mean the other. `nouns`: what things are called.
bool leaves_open(const Formula& goal, const Layout& layout, const Household& household, const NounTable& nouns);

/// Whether people have places of a category in a type of room and keep all things there that the goal puts into them.
/// The household and the knowledge must outlive it.
RoomSuits rooms_for(const Formula& goal, const Household& household, const Knowledge& knowledge);

}  // namespace unietp
