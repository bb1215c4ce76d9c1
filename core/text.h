#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace unietp {

/// The parts between separators; one part more than separators, also empty ones.
std::vector<std::string> split(std::string_view text, char separator);
/// The parts with the separator between them.
std::string join(const std::vector<std::string>& parts, std::string_view separator);
/// Without blanks, tabs and line ends at both ends.
std::string_view trim(std::string_view text);
/// ASCII letters in lower case; other bytes stay.
std::string lower(std::string_view text);
/// True for a, e, i, o, u in either case, whatever the word sounds like.
bool starts_with_vowel_letter(std::string_view word);
/// Each `from`, left to right, replaced by `to`; what is put in is not searched again.
std::string replace_all(std::string text, std::string_view from, std::string_view to);

/// The candidate with the smallest edit distance to `name`, where two neighbors swapped are one edit, or "" when none
/// is near (more than a third of the letters differ); ties go to the first.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// Shortest text that reads back to the same double (std::to_chars), so that files are the same everywhere.
std::string number_text(double value);

}  // namespace unietp
