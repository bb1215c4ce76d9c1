#pragma once

#include <string>
#include <vector>

#include "templates/template.h"

namespace unietp {

/// What is doubtful of a template's purpose, each in words for a warning: it has none; its goal asks for nothing that
/// the purpose is about; it gives no reason although its start says something; or the goal's end is what the start
/// already is, so that nothing has changed when it is done.
std::vector<std::string> doubtful_purpose(const Template& source);

/// "<A> is dirty", "<A> is not inside <B>", "the agent is not in <R>".
std::string need_in_words(const Need& need);

}  // namespace unietp
