#include "core/plain_name.h"

#include <algorithm>

#include "core/limits.h"

namespace unietp {

bool is_plain_name(std::string_view name) { return name.size() <= limits::kNameBytes && is_plain_file_name(name); }

bool is_plain_file_name(std::string_view name) {
  const auto is_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && name.size() <= limits::kFileNameBytes && is_word(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return is_word(c) || c == '-' || c == '.'; });
}

std::string plain_name_expected() {
  return "expected 1 to " + std::to_string(limits::kNameBytes) +
         " letters, digits, '_', '-' and '.', the first of them a letter, a digit or '_'";
}

bool is_label(std::string_view text) {
  return !text.empty() && text.size() <= limits::kLabelBytes && is_one_line(text);
}

std::string label_expected() {
  return "expected 1 to " + std::to_string(limits::kLabelBytes) + " bytes without control characters";
}

bool is_one_line(std::string_view text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; });
}

}  // namespace unietp
