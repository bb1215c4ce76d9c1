#pragma once

#include <optional>
#include <string>

#include "templates/template.h"

namespace unietp {

/// The goal in the grammar's English, with placeholders for nouns: "Make sure that two <A> are inside a <C>." As for an
/// instruction, the text is read back and must mean the goal. nullopt when the grammar has no words for it.
std::optional<std::string> goal_in_words(const Template& source);

/// A start constraint of an enforceable shape: "at least 2 <A>, each dirty and on no <B>".
std::string start_in_words(const Formula& start);

/// What a placeholder asks for: "furniture that things go into".
std::string parameter_in_words(const Parameter& parameter);

}  // namespace unietp
