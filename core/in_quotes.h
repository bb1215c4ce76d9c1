#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace unietp {

/// Text from a file for a message on a terminal: bytes that are not printable ASCII become `?`, and what is longer than
/// `limit` bytes is cut and ends in `…`.
std::string printable(std::string_view text, std::size_t limit);

/// `"text"` for a message: printable, cut at 60 bytes.
std::string in_quotes(std::string_view text);

}  // namespace unietp
