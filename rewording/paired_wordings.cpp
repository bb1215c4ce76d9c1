#include "rewording/paired_wordings.h"

#include <array>

#include "annotator/home_facts.h"
#include "annotator/minimal_pair.h"
#include "annotator/phrasing_sets.h"
#include "dataset/candidate_number.h"
#include "dataset/lines.h"
#include "record/dataset_reader.h"
#include "rewording/referring_goal.h"
#include "rewording/worded_task.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr std::array kComplex{Style::SubordinateClause, Style::InvertedOrder, Style::Condition, Style::Aside};

class PairWriter {
 public:
  PairWriter(const WordedTask& task, Scene start, const DemonstrationRecord& demonstration, const Backend& backend,
             const PairOptions& options)
      : task_(task),
        start_(std::move(start)),
        backend_(backend),
        english_(options.english),
        contrasts_(options.contrasts),
        writing_{options.phrasings, categories_in(start_), &start_},
        rng_(wording_stream(options.seed.value_or(task.record.run), task.record.slot, task.record.attempt)
                 .fork("pair", 0)) {
    std::vector<Delta> changes;
    for (const StepRecord& step : demonstration.steps) changes.push_back(step.changes);
    trace_ = to_logic(start_, changes, reads_comparisons(task.specification.goal));
  }

  Result<WordingsEntry> pair() const {
    WordingsEntry pair;
    pair.task = task_.record.id;
    auto direct = worded(task_.specification.goal, Style::Direct);
    if (!direct) return direct.error();
    pair.direct = std::move(*direct);
    if (const auto goal = referring_goal(task_.specification.goal, start_, trace_, rng_.fork("referring", 0))) {
      if (auto referring = worded(*goal, Style::Direct)) {
        pair.referring = std::move(*referring);
        pair.referring_goal = to_text(*goal);
      }
    }
    for (const Style style : kComplex) {
      auto complex = worded(task_.specification.goal, style);
      if (!complex || complex->style != style) continue;
      pair.complex = std::move(*complex);
      break;
    }
    if (contrasts_) add_contrast(pair);
    return pair;
  }

 private:
  void add_contrast(WordingsEntry& pair) const {
    Specification specification = task_.specification;
    specification.style = Style::Direct;
    const NounTable& nouns = backend_.nouns_in(english_);
    auto other =
        minimal_pair(pair.direct.text, specification, backend_.knowledge, nouns, start_, rng_.fork("contrast", 0));
    const bool in_halves = writing_.phrasings == Phrasings::Training || writing_.phrasings == Phrasings::Benchmark;
    if (!other || (in_halves && phrasings_of(other->text, nouns) != writing_.phrasings)) return;
    pair.contrast = pair.direct;
    pair.contrast->text = std::move(other->text);
    pair.contrast_goal = to_text(other->goal);
  }

  Result<Instruction> worded(const Formula& goal, Style style) const {
    Specification specification = task_.specification;
    specification.goal = goal;
    specification.style = style;
    return write_instruction(specification, backend_.knowledge, backend_.nouns_in(english_), writing_,
                             rng_.fork(name_of(style), 0));
  }

  const WordedTask& task_;
  Scene start_;
  const Backend& backend_;
  English english_;
  bool contrasts_;
  WritingOptions writing_;
  Rng rng_;
  Trace trace_;
};

}  // namespace

Result<Done> write_paired_wordings(const fs::path& folder, const Resources& resources, const PairOptions& options,
                                   const fs::path& file) {
  auto reader = DatasetReader::open(folder, {.modes = {Mode::M1}, .starts = true});
  if (!reader) return reader.error();
  auto lines = LinesWriter::begin(file);
  if (!lines) return lines.error();
  int line = 0;
  const auto done = for_each_task<std::string>(
      std::move(*reader), 1,
      [&](const FinishedTask& finished) -> Result<std::string> {
        const auto task = worded_task(folder, ++line, finished.record);
        if (!task) return task.error();
        const Backend& backend = resources.backend(task->specification.simulator);
        const auto pair = PairWriter(*task, finished.start, finished.shown.at(Mode::M1), backend, options).pair();
        if (!pair) return pair.error();
        return line_of(*pair);
      },
      [&](std::string&& pair) { return lines->add(pair); });
  if (!done) return done;
  return lines->finish();
}

}  // namespace unietp
