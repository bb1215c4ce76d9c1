#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/sexpr.h"
#include "templates/template_checks.h"

namespace unietp {

/// Reads `(purpose cleaning)` or `(purpose cleaning (because (dirty A) (not (inside A B))))` into source.value.purpose.
/// Errors: Parse, each at its place: no or an unknown purpose, a part that is no `because`, a reason of another form.
std::vector<Error> read_purpose(const Sexpr& section, TemplateSource& source);

/// Whether every reason of the purpose is something that the start says. Errors: Schema, at the reason.
std::vector<Error> check_purpose(const TemplateSource& source);

/// "(dirty A)", "(not (inside A B))"
std::string to_text(const Need& need);
/// "cleaning (because (dirty A))": what stands in the section.
std::string to_text(const Purpose& purpose);
/// "plate is dirty", "cup is not on counter", where `name_of` says what placeholders are called; "the agent is not in
/// kitchen".
std::string need_in_words(const Need& need, const std::function<std::string(const std::string&)>& name_of);

}  // namespace unietp
