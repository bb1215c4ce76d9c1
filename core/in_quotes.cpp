#include "core/in_quotes.h"

#include <algorithm>

namespace unietp {

std::string printable(std::string_view text, std::size_t limit) {
  std::string plain(text.substr(0, limit));
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() > limit ? plain + "…" : plain;
}

std::string in_quotes(std::string_view text) { return std::string("\"").append(printable(text, 60)).append("\""); }

}  // namespace unietp
