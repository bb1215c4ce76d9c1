#include "authoring/template_draft.h"

#include <algorithm>

#include "core/sexpr.h"
#include "core/text.h"
#include "templates/constraint_kinds.h"
#include "templates/purpose_reading.h"
#include "templates/sections.h"
#include "templates/template_text.h"

namespace unietp {
namespace {

/// A formula, laid out; unchanged when its brackets do not match.
std::string laid_out_text(const std::string& text) {
  const auto expression = read_sexpr("", text);
  return expression ? laid_out(*expression, 4) : text;
}

std::string in_brackets(const std::string& parameter) {
  return parameter.starts_with('(') ? parameter : "(" + parameter + ")";
}

std::vector<std::string> each(std::vector<std::string> items, std::string (*change)(const std::string&)) {
  for (auto& item : items) item = change(item);
  return items;
}

std::string quoted_text(const std::string& text) { return quoted_string(text); }

/// "cleaning (because (dirty A))" as its word and the rest.
std::vector<std::string> words_of(const std::string& purpose) {
  if (purpose.empty()) return {};
  const auto space = purpose.find(' ');
  if (space == std::string::npos) return {purpose};
  return {purpose.substr(0, space), purpose.substr(space + 1)};
}

/// The items of a section as written in the file.
std::vector<std::string> items_of(const TemplateDraft& draft, SectionType section) {
  switch (section) {
    case SectionType::Name:
      return {quoted_string(draft.title.empty() ? replace_all(draft.name, "-", " ") : draft.title)};
    case SectionType::Purpose:
      return words_of(draft.purpose);
    case SectionType::Split:
      return {draft.split};
    case SectionType::Refinement:
      return draft.refinement.empty() ? std::vector<std::string>{} : std::vector{draft.refinement};
    case SectionType::Simulators:
      return draft.simulators;
    case SectionType::Parameters:
      return each(draft.parameters, in_brackets);
    case SectionType::Constraints:
      return draft.constraints;
    case SectionType::Init:
      return each(draft.init, laid_out_text);
    case SectionType::Goal:
      return draft.goal.empty() ? std::vector<std::string>{} : std::vector{laid_out_text(draft.goal)};
    case SectionType::Instruction:
      return each(draft.phrasings, quoted_text);
  }
  return {};
}

bool below_each_other(SectionType section) {
  return section == SectionType::Init || section == SectionType::Goal || section == SectionType::Instruction;
}

/// The first word of a line that opens a section, or "".
std::string section_opened(std::string_view line) {
  const auto text = trim(line);
  for (const auto& section : template_sections()) {
    const auto head = "(" + std::string(section.name);
    if (line.starts_with("  (") && text.starts_with(head) && (text.size() == head.size() || text[head.size()] == ' '))
      return std::string(section.name);
  }
  return "";
}

}  // namespace

TemplateDraft draft_like(const Template& source, std::string name) {
  TemplateDraft draft;
  draft.name = std::move(name);
  draft.title = source.title;
  draft.purpose = to_text(source.purpose);
  draft.split = name_of(source.split);
  draft.refinement = source.refinement;
  for (const auto simulator : source.simulators) draft.simulators.emplace_back(name_of(simulator));
  for (const auto& parameter : source.parameters) {
    draft.parameters.push_back(parameter.name + " - " + join(parameter.affordances, " "));
  }
  for (const auto& constraint : source.constraints) {
    draft.constraints.push_back(to_text(constraint));
  }
  for (const auto& start : source.init) draft.init.push_back(to_text(start));
  draft.goal = to_text(source.goal);
  draft.phrasings = source.instructions;
  return draft;
}

std::string draft_text(const TemplateDraft& draft) {
  std::string text =
      "; A semicolon starts a comment. Language: docs/templates.md. Words: `unietp template vocabulary`.\n"
      "(template " +
      draft.name;
  for (const auto& section : template_sections()) {
    const auto items = items_of(draft, section.type);
    text += "\n  ; " + std::string(section.says) + "\n";
    if (items.empty() && !section.required) {
      text += "  ; optional: " + std::string(section.usage);
      continue;
    }
    text += "  (" + std::string(section.name);
    for (const auto& item : items) text += (below_each_other(section.type) ? "\n    " : " ") + item;
    text += ")";
  }
  return text + "\n)\n";
}

std::vector<DraftProblem> draft_problems(const TemplateDraft& draft, const std::string& file) {
  const auto text = draft_text(draft);
  std::vector<DraftProblem> problems;
  for (const auto& section : template_sections()) {
    for (const auto& item : items_of(draft, section.type)) {
      const std::string name(section.name);
      const auto read = read_sexpr(name, item);
      if (!read) problems.push_back({{{Error::Kind::Parse, name, {}, read.error().message}, false}, name});
    }
  }
  if (!problems.empty()) return problems;  // a missing bracket would be reported at the end of the whole file
  for (const auto& error : parse_template(file, text).errors) {
    std::string section;
    for (int line = 1; line <= error.pos.line; ++line) {
      if (auto opened = section_opened(line_of(text, line)); !opened.empty()) section = std::move(opened);
    }
    problems.push_back({{error, false}, std::move(section)});
  }
  return problems;
}

}  // namespace unietp
