#include "llm/json_object.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "core/text.h"

namespace unietp {
namespace {

using Json = nlohmann::json;

constexpr int kMostStarts = 64;  // opening brackets that are tried, to bound the time

/// Tracks whether the current byte of a JSON text is inside a string.
class StringTracker {
 public:
  bool inside(char c) {
    if (!in_string_) return in_string_ = c == '"';
    if (escaped_) {
      escaped_ = false;
    } else if (c == '\\') {
      escaped_ = true;
    } else if (c == '"') {
      in_string_ = false;
    }
    return true;
  }

 private:
  bool in_string_ = false, escaped_ = false;
};

/// Bytes up to the bracket that closes the one in front; 0 when none does.
std::size_t balanced_length(std::string_view text) {
  StringTracker strings;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (strings.inside(text[i])) continue;
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) return i + 1;
  }
  return 0;
}

bool is_object(std::string_view text) {
  return !nested_too_deep(text) && Json::parse(text, nullptr, false).is_object();
}

}  // namespace

bool nested_too_deep(std::string_view json) {
  StringTracker strings;
  int now = 0;
  for (const char c : json) {
    if (strings.inside(c)) continue;
    if (c == '{' || c == '[') ++now;
    if (c == '}' || c == ']') --now;
    if (now > limits::kJsonDepth) return true;
  }
  return false;
}

Result<std::string> json_object_in(std::string_view text) {
  constexpr std::string_view kThoughtsEnd = "</think>";
  if (const auto end = text.rfind(kThoughtsEnd); end != std::string_view::npos) {
    if (auto behind = json_object_in(text.substr(end + kThoughtsEnd.size()))) return behind;
  }
  text = trim(text);
  if (text.starts_with('{') && is_object(text)) return std::string(text);
  std::size_t at = text.find('{');
  for (int start = 0; start < kMostStarts && at != std::string_view::npos; ++start) {
    const auto candidate = text.substr(at, balanced_length(text.substr(at)));
    if (!candidate.empty() && is_object(candidate)) return std::string(candidate);
    at = text.find('{', at + 1);
  }
  return Error{Error::Kind::Schema, "language model", {}, "its text contains no JSON object"};
}

}  // namespace unietp
