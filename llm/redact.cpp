#include "llm/redact.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

constexpr std::size_t kTelling = 8;  // a part of a key this long, in bytes, is redacted

/// Length of the longest part of `secret` that `text` begins with.
std::size_t part_at_front(std::string_view text, std::string_view secret) {
  std::size_t longest = 0;
  for (std::size_t from = 0; from < secret.size(); ++from) {
    const auto [in_secret, in_text] =
        std::mismatch(secret.begin() + static_cast<std::ptrdiff_t>(from), secret.end(), text.begin(), text.end());
    longest = std::max(longest, static_cast<std::size_t>(in_text - text.begin()));
  }
  return longest;
}

}  // namespace

std::string redacted(std::string_view text, std::string_view secret) {
  if (secret.empty()) return std::string(text);
  const std::size_t telling = std::min(kTelling, secret.size());
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t part = part_at_front(text.substr(at), secret);
    if (part >= telling) {
      shown += "[key]";
      at += part;
    } else {
      shown += text[at++];
    }
  }
  return shown;
}

std::string plain_line(std::string_view text, std::size_t longest) {
  std::string line;
  for (const char c : text.substr(0, longest)) line += c >= ' ' && c <= '~' ? c : ' ';
  line = trim(line);
  return text.size() > longest ? line + "..." : line;
}

}  // namespace unietp
