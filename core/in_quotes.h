#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unietp {

/// Text from a file for a message on a terminal: bytes that are not printable ASCII become `?`, and what is longer than
/// `limit` bytes is cut and ends in `…`.
std::string printable(std::string_view text, std::size_t limit);

/// A message with parts from a file, for a terminal: what would move the cursor, change colors or the direction of
/// writing becomes `?`, that is control characters (also those of UTF-8, U+0080 to U+009F) and Unicode's signs for
/// directions (U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069). The rest stays as it is.
std::string for_terminal(std::string_view text);

/// `"text"` for a message: printable, cut at 60 bytes.
std::string in_quotes(std::string_view text);

}  // namespace unietp
