#pragma once

#include <string>

#include "core/sexpr.h"
#include "templates/template.h"

namespace unietp {

/// The template as a file: every section that says something, in the order of template_sections(), without comments.
/// parse_template(file, to_text(t)) gives a template of the same content, and equal contents give equal texts.
std::string to_text(const Template& source);

/// Whether two templates say the same: all fields but the file and the positions in it.
bool same_content(const Template& left, const Template& right);

/// An expression on one line where it fits into 120 columns behind `indent` spaces, else its parts below each other.
/// The first line is not indented.
std::string laid_out(const Sexpr& expression, std::size_t indent);

/// In double quotes, as read_sexprs reads it back.
std::string quoted_string(std::string_view text);

}  // namespace unietp
