#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// The text with the secret, and with every part of it of at least 8 bytes, replaced by "[key]". "" is no secret.
std::string redacted(std::string_view text, std::string_view secret);

/// One line that may be shown: control and non-ASCII bytes as blanks, at most `longest` bytes.
std::string plain_line(std::string_view text, std::size_t longest);

}  // namespace unietp
