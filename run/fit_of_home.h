#pragma once

#include "akb/knowledge.h"
#include "generator/scene_offer.h"
#include "generator/weighted_binding.h"
#include "templates/template.h"

namespace unietp {

/// Accepts the last category of a binding only where the home has the furniture and rooms that the template's start
/// asks for, since no edit of a start gives it those. What is given must outlive it.
BindingCheck fits_home(const Template& source, const Knowledge& knowledge, const SceneOffer& offer);

/// Accepts what both accept; an empty one accepts everything.
BindingCheck both(BindingCheck first, BindingCheck second);

}  // namespace unietp
