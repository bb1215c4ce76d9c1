#pragma once

#include <string>
#include <string_view>

#include "core/rng.h"

namespace unietp::fuzz {

/// The text with up to four places overwritten, cut out or doubled, whatever it says.
inline std::string broken(std::string text, Rng& rng) {
  constexpr std::string_view kBytes = "()[]{}?-:,;\"'\\/\n\r|=<>019.eE+aAxtn_ \xff\x00";
  const std::uint64_t changes = 1 + rng.below(4);
  for (std::uint64_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = rng.below(text.size());
    switch (rng.below(3)) {
      case 0:
        text[at] = kBytes[rng.below(kBytes.size())];
        break;
      case 1:
        text.erase(at, 1 + rng.below(8));
        break;
      default:
        text.insert(at, text.substr(rng.below(text.size()), rng.below(24)));
        break;
    }
  }
  return text;
}

}  // namespace unietp::fuzz
