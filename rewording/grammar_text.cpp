#include "rewording/grammar_text.h"

#include "annotator/home_facts.h"
#include "dataset/candidate_number.h"
#include "resources/own_phrasings.h"

namespace unietp {
namespace {

Result<Instruction> text_from(const WordedTask& task, const Scene& start, const Resources& resources,
                              const GrammarWording& wording, const Rng& rng) {
  const Backend& backend = resources.backend(task.specification.simulator);
  WritingOptions options{.phrasings = wording.phrasings,
                         .around = categories_in(start),
                         .home = &start,
                         .phrasings_of_template = phrasings_of_template(resources, task.record.template_name),
                         .tells_apart = true};
  const auto write = [&] {
    return write_instruction(task.specification, backend.knowledge, backend.nouns_in(wording.english), options, rng);
  };
  auto text = write();
  if (text) return text;
  options.tells_apart = false;  // a data set of people who asked for less, or of an earlier version
  return write();
}

}  // namespace

Rng stream_of(const TaskRecord& task, const GrammarWording& wording) {
  return wording_stream(wording.seed.value_or(task.run), task.slot, task.attempt);
}

Result<Instruction> first_text(const WordedTask& task, const Scene& start, const Resources& resources,
                               const GrammarWording& wording) {
  return text_from(task, start, resources, wording, stream_of(task.record, wording));
}

Result<Instruction> further_text(const WordedTask& task, const Scene& start, const Resources& resources,
                                 const GrammarWording& wording, std::uint64_t number, bool in_style) {
  GrammarWording words = wording;
  // Some styles fit some goals in everyday words only; "all" phrasings are those and the others.
  if (words.phrasings == Phrasings::All && number > kFurtherTexts / 2 && !in_style)
    words.phrasings = Phrasings::Everyday;
  return text_from(task, start, resources, words, stream_of(task.record, wording).fork("another", number));
}

Result<Instruction> text_again(const WordedTask& task, const Scene& start, const Resources& resources,
                               const GrammarWording& wording) {
  const auto first = first_text(task, start, resources, wording);
  auto text = first;
  for (std::uint64_t number = 1; text && text->text != task.record.instruction; ++number) {
    if (number > kFurtherTexts) return first;
    text = further_text(task, start, resources, wording, number, text->style == task.specification.style);
  }
  return text ? text : first;
}

}  // namespace unietp
