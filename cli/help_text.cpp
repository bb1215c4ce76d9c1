#include "cli/help_text.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

constexpr std::size_t kColumn = 26;  // where explanations of options begin

std::string wrapped_paragraph(const std::string& text, std::size_t indent, std::size_t width, bool hanging) {
  std::string lines, line = hanging ? "" : std::string(indent, ' ');
  std::size_t used = indent;
  bool first = true;
  for (const auto& word : split(text, ' ')) {
    if (word.empty()) continue;
    if (!first && used + 1 + word.size() > width) {
      lines += line + "\n";
      line = std::string(indent, ' ');
      used = indent;
      first = true;
    }
    line += (first ? "" : " ") + word;
    used += word.size() + (first ? 0 : 1);
    first = false;
  }
  return lines + line + "\n";
}

/// "  left      right, wrapped"; the right part begins on the next line when the left one is too long.
std::string row(const std::string& left, const std::string& right) {
  std::string text = "  " + left;
  if (text.size() + 2 > kColumn) return text + "\n" + wrapped(right, kColumn);
  text.resize(kColumn, ' ');
  return text + wrapped(right, kColumn, 80, true);
}

/// "one of a, b, c" where the help text does not list the choices already; the default.
std::string explanation(const OptionPage& option) {
  std::string text = option.help;
  const bool listed = std::all_of(option.choices.begin(), option.choices.end(), [&](const std::string& choice) {
    return option.help.find(choice) != std::string::npos;
  });
  std::vector<std::string> notes;
  if (!option.choices.empty() && !listed) notes.push_back(join(option.choices, ", "));
  if (!option.fallback.empty()) notes.push_back("default: " + replace_all(option.fallback, ",", ", "));
  if (notes.empty()) return text;
  if (!text.ends_with(')')) return text + " (" + join(notes, "; ") + ")";
  text.pop_back();
  return text + "; " + join(notes, "; ") + ")";
}

std::string left_of(const OptionPage& option) {
  return join(option.names, ", ") + (option.argument || option.value.empty() ? "" : " " + option.value);
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width, bool hanging) {
  std::string lines, paragraph;
  const auto flush = [&] {
    if (!paragraph.empty()) lines += wrapped_paragraph(paragraph, indent, width, hanging && lines.empty());
    paragraph.clear();
  };
  for (const auto& line : split(text, '\n')) {
    if (line.empty() || line.starts_with("  ")) {
      flush();
      lines += line.empty() ? "\n" : std::string(indent, ' ') + line + "\n";
    } else {
      paragraph += (paragraph.empty() ? "" : " ") + line;
    }
  }
  flush();
  return lines;
}

std::string usage_line(const CommandPage& page) {
  std::string line = page.name;
  if (!page.commands.empty()) line += " COMMAND";
  bool optional = false;
  for (const auto& option : page.options) {
    const std::string value =
        option.value + (option.many && option.value.find("...") == std::string::npos ? "..." : "");
    if (option.argument) {
      const std::string name = option.names.front() + (option.many ? "..." : "");
      line += option.required ? " " + name : " [" + name + "]";
    } else if (option.required) {
      line += " " + option.names.front() + (value.empty() ? "" : " " + value);
    } else {
      optional = true;
    }
  }
  return line + (optional ? " [OPTIONS]" : "");
}

std::string help_text(const CommandPage& page) {
  std::string text = page.summary + ".\n\n" + wrapped("Usage: " + usage_line(page), 4, 80, true);
  if (!page.about.empty()) text += "\n" + wrapped(page.about, 0);
  const auto section = [&](const char* title, bool arguments) {
    std::string rows;
    for (const auto& option : page.options) {
      if (option.argument == arguments) rows += row(left_of(option), explanation(option));
    }
    if (!rows.empty()) text += std::string("\n") + title + ":\n" + rows;
  };
  if (!page.commands.empty()) {
    text += "\nCommands:\n";
    for (const auto& command : page.commands)
      text += row(command.name.substr(command.name.rfind(' ') + 1), command.summary);
  }
  section("Arguments", true);
  section("Options", false);
  if (!page.examples.empty()) text += "\nExamples:\n";
  for (const auto& example : page.examples) {
    text += "  " + example.line + "\n";
    if (!example.effect.empty()) text += wrapped(example.effect, 6);
  }
  return text;
}

}  // namespace unietp
