#include "templates/bracket_hint.h"

#include "templates/sections.h"

namespace unietp {
namespace {

/// The section that the text begins with, or "".
std::string section_at(std::string_view text) {
  for (const auto& section : template_sections()) {
    const auto head = "(" + std::string(section.name);
    const bool whole =
        text.size() > head.size() && std::string_view(" \n\r\t").find(text[head.size()]) != std::string_view::npos;
    if (whole && text.starts_with(head)) return std::string(section.name);
  }
  return "";
}

}  // namespace

std::string bracket_hint(std::string_view text) {
  int depth = 0;
  int line = 1;
  bool in_string = false;
  bool in_comment = false;
  bool line_begins = true;  // nothing but blanks so far
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '\n') {
      ++line;
      in_comment = false;
      line_begins = true;
      continue;
    }
    if (in_comment) continue;
    if (in_string) {
      if (c == '\\') ++at;
      in_string = c != '"';
      continue;
    }
    if (c == '(' && line_begins && depth != 1) {
      if (const auto section = section_at(text.substr(at)); !section.empty()) {
        const auto open = depth - 1;
        return "; section '" + section + "' opens at line " + std::to_string(line) +
               (open < 0 ? " after the end of the template: there is an extra ')' before it"
                         : " while " + std::to_string(open) + (open == 1 ? " bracket" : " brackets") +
                               " of the section before it " + (open == 1 ? "is" : "are") + " open");
      }
    }
    if (c == '(') ++depth;
    if (c == ')') --depth;
    in_comment = c == ';';
    in_string = c == '"';
    if (c != ' ' && c != '\t' && c != '\r') line_begins = false;
  }
  return "";
}

}  // namespace unietp
