#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "authoring/problem_text.h"
#include "templates/template.h"

namespace unietp {

/// The contents of the sections of a new template, each as it is written there.
struct TemplateDraft {
  std::string name;     // "open-one"
  std::string title;    // "open one <A>"; "" for the name in words
  std::string purpose;  // "cleaning (because (dirty A))"; "": the section is left out
  std::string split = "atomic";
  std::string refinement;                // "by-state"; "": the section is left out
  std::vector<std::string> simulators;   // none: the section is left out
  std::vector<std::string> parameters;   // "A - pickupable", with or without brackets
  std::vector<std::string> constraints;  // "(distinct A B)"
  std::vector<std::string> init;         // "(exists (?a - A) (closed ?a))"
  std::string goal;
  std::vector<std::string> phrasings;  // without quotes
  bool operator==(const TemplateDraft&) const = default;
};

/// The sections of a template as a draft, under another name.
TemplateDraft draft_like(const Template& source, std::string name);

/// The file: each section below a comment that explains it, formulas laid out. Optional sections that a draft lacks are
/// there as comments.
std::string draft_text(const TemplateDraft& draft);

/// A problem of a draft and its section.
struct DraftProblem {
  LintProblem problem;
  std::string section;  // "goal"; "" for the name
};
/// Empty when draft_text(draft) is a valid template. `file`: its name in the messages.
std::vector<DraftProblem> draft_problems(const TemplateDraft& draft, const std::string& file);

}  // namespace unietp
