#include "cli/man_page.h"

#include "cli/help_text.h"
#include "core/text.h"

namespace unietp {
namespace {

/// Text as roff shows it literally.
std::string escaped(std::string text) {
  text = replace_all(text, "\\", "\\e");
  text = replace_all(text, "-", "\\-");
  std::string lines;
  for (const auto& line : split(text, '\n')) {
    if (!lines.empty()) lines += "\n";
    if (line.starts_with('.') || line.starts_with('\'')) lines += "\\&";
    lines += line;
  }
  return lines;
}

/// Lines that keep their breaks and columns.
std::string verbatim(const std::string& text) {
  std::string body = escaped(text);
  while (!body.empty() && body.back() == '\n') body.pop_back();
  return ".nf\n" + body + "\n.fi\n";
}

/// Paragraphs are filled; lines that begin with two spaces are kept.
std::string paragraphs(const std::string& text) {
  std::string roff, kept;
  const auto flush = [&] {
    if (!kept.empty()) roff += ".PP\n" + verbatim(kept);
    kept.clear();
  };
  bool filling = false;
  for (const auto& line : split(text, '\n')) {
    if (line.starts_with("  ")) {
      kept += line + "\n";
      filling = false;
      continue;
    }
    flush();
    if (line.empty()) {
      filling = false;
      continue;
    }
    roff += (filling ? "" : ".PP\n") + escaped(line) + "\n";
    filling = true;
  }
  flush();
  return roff;
}

std::string option_entry(const OptionPage& option) {
  std::string names;
  for (const auto& name : option.names)
    names += (names.empty() ? "" : ", ") + std::string("\\fB") + escaped(name) + "\\fR";
  if (!option.argument && !option.value.empty()) names += " \\fI" + escaped(option.value) + "\\fR";
  std::string text = escaped(option.help) + ".";
  if (!option.choices.empty()) text += " Values: " + escaped(join(option.choices, ", ")) + ".";
  if (!option.fallback.empty()) text += " Default: " + escaped(replace_all(option.fallback, ",", ", ")) + ".";
  return ".TP\n" + names + "\n" + text + "\n";
}

std::string command_entry(const CommandPage& page) {
  std::string text =
      ".SS " + escaped(page.name) + "\n" + escaped(page.summary) + ".\n.PP\n.B " + escaped(usage_line(page)) + "\n";
  if (!page.about.empty()) text += paragraphs(page.about);
  for (const auto& option : page.options) text += option_entry(option);
  if (!page.examples.empty()) text += ".PP\nExamples:\n";
  for (const auto& example : page.examples) {
    text += ".PP\n" + verbatim("  " + example.line);
    if (!example.effect.empty()) text += ".RS 6\n" + escaped(example.effect) + "\n.RE\n";
  }
  for (const auto& below : page.commands) text += command_entry(below);
  return text;
}

std::string upper(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (c == '-') c = ' ';
  }
  return text;
}

}  // namespace

std::string man_page(const CommandPage& program, const std::vector<HelpTopic>& topics, const std::string& version) {
  std::string text = ".TH UNIETP 1 \"\" \"unietp " + version +
                     "\" \"User Commands\"\n.nh\n.ad l\n.SH NAME\nunietp \\- " + escaped(program.summary) +
                     "\n.SH SYNOPSIS\n.B " + escaped(usage_line(program)) + "\n.SH DESCRIPTION\n" +
                     paragraphs(program.about) + ".SH OPTIONS\n";
  for (const auto& option : program.options) text += option_entry(option);
  text += ".SH COMMANDS\n";
  for (const auto& command : program.commands) text += command_entry(command);
  for (const auto& topic : topics) text += ".SH " + upper(topic.name) + "\n" + paragraphs(topic.text);
  return text;
}

}  // namespace unietp
