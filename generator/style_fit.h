#pragma once

#include <vector>

#include "akb/knowledge.h"
#include "generator/specification.h"
#include "generator/style.h"
#include "templates/template.h"

namespace unietp {

/// The styles in which a template's tasks of the Linguistic split can be worded, by the form of its goal: the one that
/// the template names itself, or else all that refine_linguistic can give it with fitting categories in a fitting home.
/// In the order of Style.
std::vector<Style> styles_fitting(const Template& source);

/// Whether some category of the binding has the words that the style needs: a phrase of its kind, or another name. True
/// for styles that need no such words. Most bindings that refine_linguistic refuses have none.
bool has_words_for(Style style, const Binding& binding, const Knowledge& knowledge);

}  // namespace unietp
