#include "rewording/check_text.h"

#include <algorithm>

#include "annotator/function_phrases.h"
#include "annotator/instruction.h"
#include "annotator/phenomena.h"
#include "annotator/phrasing_sets.h"
#include "annotator/style.h"
#include "annotator/word_check.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "record/text_writer.h"
#include "rewording/worded_task.h"

namespace unietp {
namespace {

std::string listed(const std::vector<std::string>& phenomena) {
  return phenomena.empty() ? "no phenomenon of language" : join(phenomena, ", ");
}

}  // namespace

std::vector<Problem> check_text(const StatedGoal& stated, const Backend& backend) {
  std::vector<Problem> problems;
  const auto found = [&problems](ProblemKind kind, const std::vector<std::string>& faults) {
    for (const auto& fault : faults) problems.push_back(problem_in(kind, "", fault));
  };
  const auto style = style_named(stated.style);
  if (!style) return {problem_in(ProblemKind::TextStyle, "", "no style is called \"" + stated.style + "\"")};
  Specification specification;
  specification.template_name = stated.template_name;
  specification.simulator = stated.simulator;
  specification.goal = stated.goal;
  specification.init = stated.constraints;
  specification.style = *style;
  const NounTable& all = backend.nouns_in(recorded_english(stated.english));
  const auto narrowed = narrowed_for(specification, backend.knowledge, all);
  const NounTable& nouns = narrowed ? *narrowed : all;

  const auto form = form_faults(stated.text, specification);
  found(ProblemKind::TextForm, form);
  const auto writer = text_writer_of(stated.writer);
  if (writer == TextWriter::UncheckedPerson) return problems;  // reported for its writer
  const bool by_grammar = writer == TextWriter::Grammar;
  auto meaning = by_grammar || writer == TextWriter::Person
                     ? check_instruction(stated.text, specification, backend.knowledge, all, stated.home)
                     : saying_faults(stated.text, specification, nouns);
  if (writer == TextWriter::Model) {
    auto other = misreading(stated.text, specification, backend.knowledge, all, stated.home);
    if (!other.empty()) meaning.push_back(std::move(other));
  }
  std::erase_if(meaning,
                [&](const std::string& fault) { return std::find(form.begin(), form.end(), fault) != form.end(); });
  found(ProblemKind::TextMeaning, meaning);
  if (const auto fault = style_fault(stated.text, *style, stated.goal, stated.around, nouns); !fault.empty())
    found(ProblemKind::TextStyle, {fault});
  if (stated.phenomena != nullptr) {
    const auto shown = names_of(phenomena_of(stated.text, *style, stated.goal, nouns));
    if (shown != *stated.phenomena)
      found(ProblemKind::TextStyle,
            {"it says that it shows " + listed(*stated.phenomena) + "; it shows " + listed(shown)});
  }
  const auto phrasings = phrasings_named(stated.phrasings);
  if (!phrasings)
    found(ProblemKind::TextPhrasing,
          {"the manifest names a set of phrasings, " + stated.phrasings + ", that is not known"});
  // "I want to watch the news." is no pattern of the grammar: both sets ask so.
  const bool whole = std::any_of(nouns.phrases().begin(), nouns.phrases().end(), [&](const auto& one) {
    return one.second.use == AliasKind::Request && one.second.text == stated.text;
  });
  if (by_grammar && !whole && (phrasings == Phrasings::Training || phrasings == Phrasings::Benchmark)) {
    const auto own = phrasings_of(stated.text, nouns);
    if (own != phrasings)
      found(ProblemKind::TextPhrasing, {"its sentence pattern belongs to " + std::string(name_of(own)) + ", not to " +
                                        stated.phrasings + " as the manifest says"});
  }
  return problems;
}

}  // namespace unietp
