#include "rewording/person_text.h"

#include "annotator/function_phrases.h"
#include "annotator/home_facts.h"
#include "annotator/phenomena.h"
#include "annotator/style.h"
#include "annotator/word_check.h"
#include "record/text_writer.h"

namespace unietp {
namespace {

constexpr const char* kPerson = "person";
constexpr const char* kUnchecked = "person:unchecked";

}  // namespace

bool by_person(std::string_view writer) {
  const auto known = text_writer_of(writer);
  return known == TextWriter::Person || known == TextWriter::UncheckedPerson;
}

PersonText check_person_text(const std::string& text, const WordedTask& task, const Backend& backend, English english,
                             const Scene& home) {
  const Specification& specification = task.specification;
  const NounTable& all = backend.nouns_in(english);
  const auto narrowed = narrowed_for(specification, backend.knowledge, all);
  const NounTable& nouns = narrowed ? *narrowed : all;
  PersonText checked{
      {text, kPerson, specification.style, {}, "", phenomena_of(text, specification.style, specification.goal, nouns)},
      {}};
  const auto check = [&](const char* name, std::vector<std::string> faults) {
    if (faults.empty()) checked.instruction.checks.emplace_back(name);
    for (auto& fault : faults) checked.faults.push_back(std::move(fault));
  };
  const auto form = form_faults(text, specification);
  check("form", form);
  if (form.empty()) check("parses-back", check_instruction(text, specification, backend.knowledge, all, &home));
  auto style = style_fault(text, specification.style, specification.goal, categories_in(home), nouns);
  check("style", style.empty() ? std::vector<std::string>() : std::vector<std::string>{std::move(style)});
  if (!checked.faults.empty()) checked.instruction.writer = kUnchecked;
  return checked;
}

}  // namespace unietp
