#include "core/in_quotes.h"

#include <algorithm>

namespace unietp {

std::string printable(std::string_view text, std::size_t limit) {
  std::string plain(text.substr(0, limit));
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() > limit ? plain + "…" : plain;
}

std::string for_terminal(std::string_view text) {
  const auto at = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0; };
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int byte = at(i), next = at(i + 1), third = at(i + 2);
    const bool control = byte < 0x20 || byte == 0x7f;
    const bool control_of_two = byte == 0xc2 && next >= 0x80 && next <= 0x9f;
    const bool direction = byte == 0xe2 && ((next == 0x80 && (third == 0x8e || third == 0x8f)) ||
                                            (next == 0x80 && third >= 0xaa && third <= 0xae) ||
                                            (next == 0x81 && third >= 0xa6 && third <= 0xa9));
    safe += control || control_of_two || direction ? '?' : text[i];
    if (control_of_two) i += 1;
    if (direction) i += 2;
  }
  return safe;
}

std::string in_quotes(std::string_view text) { return std::string("\"").append(printable(text, 60)).append("\""); }

}  // namespace unietp
