#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// The grammar of every id and name that may become the name of a file (tasks, scenes, homes, templates): 1 to
/// limits::kNameBytes ASCII letters, digits, `_`, `-` and `.`; the first is a letter, a digit or `_`. So no name is
/// empty, `.` or `..`, hidden, taken for an option, or a path.
bool is_plain_name(std::string_view name);
/// A plain name and its endings, at most limits::kFileNameBytes.
bool is_plain_file_name(std::string_view name);

/// What is_plain_name accepts, for error messages: "expected 1 to 200 letters, digits, …".
std::string plain_name_expected();

/// What else names something in a file, such as an object or a category: 1 to limits::kLabelBytes bytes on one line,
/// that is without control characters, which would move the cursor of a terminal.
bool is_label(std::string_view text);
std::string label_expected();

/// Whether a text stays on its line: it has no control characters.
bool is_one_line(std::string_view text);

}  // namespace unietp
