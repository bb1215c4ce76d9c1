#include "authoring/problem_text.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

constexpr std::size_t kWidest = 110;  // bytes of a source line that are shown
constexpr std::size_t kBefore = 60;   // of these, before the position

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80; }

/// The text with one column per byte: tabs and control characters replaced.
std::string printable(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = c == '\t' ? ' ' : '.';
  }
  return out;
}

std::string colored(const std::string& text, const char* code, bool color) {
  return color ? std::string("\033[") + code + "m" + text + "\033[0m" : text;
}

}  // namespace

std::string_view line_of(std::string_view text, int number) {
  for (int line = 1; line < number; ++line) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

std::string problem_text(const LintProblem& problem, std::string_view source, bool color) {
  const char* code = problem.warning ? "33" : "31";
  auto message = printable(format(problem.error));
  if (problem.warning) message = replace_all(message, "schema error: ", "warning: ");
  for (const auto* word : {"parse error:", "schema error:", "warning:"}) {
    const auto at = message.find(word);
    if (at == std::string::npos) continue;
    message.replace(at, std::string_view(word).size(), colored(word, code, color));
    break;
  }
  const auto [line, column] = problem.error.pos;
  if (line < 1 || column < 1 || line > static_cast<int>(std::count(source.begin(), source.end(), '\n')) + 1)
    return message + "\n";
  auto shown = line_of(source, line);
  auto at = std::min(static_cast<std::size_t>(column) - 1, shown.size());
  std::string_view front;
  if (shown.size() > kWidest && at > kBefore) {
    auto cut = at - kBefore;
    while (cut < at && continues(shown[cut])) ++cut;
    shown.remove_prefix(cut);
    at -= cut;
    front = "...";
  }
  std::string_view back;
  if (shown.size() > kWidest) {
    auto length = kWidest;
    while (length > at && continues(shown[length])) --length;
    shown = shown.substr(0, length);
    back = "...";
  }
  const auto columns = std::count_if(shown.begin(), shown.begin() + static_cast<std::ptrdiff_t>(at),
                                     [](char c) { return !continues(c); });
  const auto number = std::to_string(line);
  const std::string margin(number.size() < 5 ? 5 - number.size() : 0, ' ');
  return message + "\n" + margin + number + " | " + std::string(front) + printable(shown) + std::string(back) + "\n" +
         std::string(margin.size() + number.size(), ' ') + " | " +
         std::string(front.size() + static_cast<std::size_t>(columns), ' ') + colored("^", code, color) + "\n";
}

}  // namespace unietp
