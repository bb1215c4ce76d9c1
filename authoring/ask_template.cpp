#include "authoring/ask_template.h"

#include <istream>
#include <ostream>

#include "core/text.h"
#include "templates/sections.h"

namespace unietp {
namespace {

/// The dialog on a terminal.
class TemplateDialog {
 public:
  TemplateDialog(TemplateDraft draft, std::istream& in, std::ostream& out)
      : draft_(std::move(draft)), in_(in), out_(out) {}

  Result<TemplateDraft> run(const std::set<std::string>& given) {
    out_ << "A template, section by section; `unietp template vocabulary` lists every word. An empty line ends an "
            "answer "
            "that takes several.\n";
    std::set<std::string> wanted;
    for (const auto& section : template_sections()) {
      if (!given.contains(std::string(section.name))) wanted.insert(std::string(section.name));
    }
    for (;;) {
      for (const auto& section : template_sections()) {
        if (wanted.contains(std::string(section.name))) ask(section);
      }
      const auto problems = draft_problems(draft_, draft_.name + ".template");
      if (problems.empty()) return draft_;
      const auto text = draft_text(draft_);
      wanted.clear();
      out_ << "\n";
      for (const auto& [problem, section] : problems) {
        if (section.empty()) return problem.error;  // about the name, which is not asked for
        out_ << problem_text(problem, text, false);
        wanted.insert(section);
      }
      if (!in_) {
        return Error{Error::Kind::Usage, draft_.name, {}, "the answers ended before the template was valid"};
      }
      out_ << "\nPlease correct:\n";
    }
  }

 private:
  std::string line() {
    out_ << "> " << std::flush;
    std::string text;
    std::getline(in_, text);
    return std::string(trim(text));
  }

  std::vector<std::string> lines() {
    std::vector<std::string> all;
    for (auto text = line(); !text.empty(); text = line()) all.push_back(std::move(text));
    return all;
  }

  std::vector<std::string> words() {
    std::vector<std::string> all;
    for (const auto& word : split(replace_all(line(), ",", " "), ' ')) {
      if (!word.empty()) all.push_back(word);
    }
    return all;
  }

  void ask(const TemplateSection& section) {
    out_ << "\n"
         << section.name << ": " << section.says << (section.required ? "" : "; leave empty to omit it") << "\n";
    switch (section.type) {
      case SectionType::Name:
        out_ << "  such as: open one <A>\n";
        draft_.title = line();
        break;
      case SectionType::Purpose:
        out_ << "  such as: cleaning (because (dirty A))\n";
        draft_.purpose = line();
        break;
      case SectionType::Split:
        out_ << "  one of: atomic compositional logical\n";
        draft_.split = line();
        break;
      case SectionType::Refinement:
        out_ << "  such as: by-state\n";
        draft_.refinement = line();
        break;
      case SectionType::Simulators:
        out_ << "  some of: ai2thor virtualhome habitat behavior\n";
        draft_.simulators = words();
        break;
      case SectionType::Parameters:
        out_ << "  one per line, such as: A - pickupable\n";
        draft_.parameters = lines();
        break;
      case SectionType::Constraints:
        out_ << "  one per line, such as: (fits-on A B 2)\n";
        draft_.constraints = lines();
        break;
      case SectionType::Init:
        out_ << "  one per line, such as: (exists (?a - A) (closed ?a))\n";
        draft_.init = lines();
        break;
      case SectionType::Goal:
        out_ << "  on one line, such as: (exists (?a - A) (at-end (open ?a)))\n";
        draft_.goal = line();
        break;
      case SectionType::Instruction:
        out_ << "  one per line, without quotes, such as: Open {A:indefinite}.\n";
        draft_.phrasings = lines();
        break;
    }
  }

  TemplateDraft draft_;
  std::istream& in_;
  std::ostream& out_;
};

}  // namespace

Result<TemplateDraft> ask_template(TemplateDraft draft, const std::set<std::string>& given, std::istream& in,
                                   std::ostream& out) {
  return TemplateDialog(std::move(draft), in, out).run(given);
}

}  // namespace unietp
