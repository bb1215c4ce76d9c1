#include "evaluation/prompt_file.h"

#include <algorithm>
#include <filesystem>

#include "core/digest.h"
#include "core/in_quotes.h"
#include "core/plain_name.h"
#include "core/text.h"

namespace unietp {
namespace {

Error parse_error(std::string_view where, int line, std::size_t column, const std::string& message) {
  return {Error::Kind::Parse, std::string(where), {line, static_cast<int>(column) + 1}, message};
}

Result<PromptLine> read_prompt_line(std::string_view where, int number, std::string_view text,
                                    const std::vector<std::string>& slots) {
  PromptLine line;
  std::size_t at = 0;
  for (;;) {
    const auto open = text.find("{{", at);
    if (open == std::string_view::npos) break;
    const auto close = text.find("}}", open);
    if (close == std::string_view::npos) return parse_error(where, number, open, "expected }} after {{");
    std::string name(trim(text.substr(open + 2, close - open - 2)));
    if (std::find(slots.begin(), slots.end(), name) == slots.end()) {
      const auto nearest = nearest_name(name, slots);
      return parse_error(where, number, open,
                         "unknown slot " + in_quotes(name) +
                             (nearest.empty() ? "" : ", did you mean " + in_quotes(nearest)) + "; accepted are " +
                             join(slots, ", "));
    }
    line.push_back({std::string(text.substr(at, open - at)), std::move(name)});
    at = close + 2;
  }
  line.push_back({std::string(text.substr(at)), ""});
  return line;
}

}  // namespace

Result<PromptFile> read_prompt(std::string_view where, std::string_view text, const std::vector<std::string>& slots) {
  PromptFile prompt;
  prompt.name = std::filesystem::path(where).stem().string();
  if (!is_label(prompt.name))
    return parse_error(where, 1, 0, "the file's name cannot be recorded: " + label_expected());
  prompt.digest = sha256(text);
  std::vector<PromptLine>* section = nullptr;
  bool has_system = false, has_turn = false;
  int number = 0;
  while (!text.empty()) {
    const auto end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++number;
    if (line == "[system]" || line == "[turn]") {
      bool& has = line == "[system]" ? has_system : has_turn;
      if (has) return parse_error(where, number, 0, "there is a second " + std::string(line));
      has = true;
      section = line == "[system]" ? &prompt.system : &prompt.turn;
    } else if (section != nullptr) {
      auto read = read_prompt_line(where, number, line, slots);
      if (!read) return read.error();
      section->push_back(std::move(*read));
    } else if (!line.empty() && line[0] != '#') {
      return parse_error(where, number, 0, "expected [system], [turn] or a comment that starts with #");
    }
  }
  if (!has_turn) return parse_error(where, number, 0, "expected a part [turn]");
  return prompt;
}

}  // namespace unietp
