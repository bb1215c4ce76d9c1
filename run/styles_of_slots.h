#pragma once

#include <vector>

#include "core/rng.h"
#include "run/task_slot.h"
#include "templates/template.h"

namespace unietp {

/// The styles that fit each template (style_fit.h), in their order.
std::vector<std::vector<Style>> styles_of_templates(const std::vector<Template>& templates);
bool is_among(Style style, const std::vector<Style>& styles);

/// Gives each slot of the Linguistic split the phenomena that it is to show, in the order in which they are tried: the
/// first of all slots are spread as evenly over the phenomena as the slots' templates allow, and so are the second
/// ones, to which slots turn whose first cannot be had, and so on. `styles`: of each template. Deterministic in rng.
void deal_styles(std::vector<TaskSlot>& slots, const std::vector<std::vector<Style>>& styles, Rng rng);

}  // namespace unietp
