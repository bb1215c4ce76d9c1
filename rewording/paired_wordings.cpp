#include "rewording/paired_wordings.h"

#include <array>
#include <set>
#include <span>

#include "annotator/home_facts.h"
#include "annotator/minimal_pair.h"
#include "annotator/other_wordings.h"
#include "annotator/phrasing_sets.h"
#include "dataset/candidate_number.h"
#include "generator/phrase_kind.h"
#include "record/dataset_reader.h"
#include "resources/own_phrasings.h"
#include "rewording/referring_goal.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr std::array kComplex{Style::SubordinateClause, Style::InvertedOrder, Style::Condition, Style::Aside};

/// Texts of a line that mean the task's goal.
std::set<std::string> texts_of_goal(const WordingsEntry& entry) {
  std::set<std::string> texts{entry.direct.text};
  if (entry.complex) texts.insert(entry.complex->text);
  for (const Instruction& other : entry.others) texts.insert(other.text);
  return texts;
}

class PairWriter {
 public:
  PairWriter(const WordedTask& task, const Scene& start, const DemonstrationRecord& demonstration,
             const Backend& backend, const PlaceUses& uses, std::span<const std::string> phrasings_of_template,
             const PairOptions& options)
      : task_(task),
        start_(start),
        backend_(backend),
        uses_(uses),
        english_(options.english),
        contrasts_(options.contrasts),
        wordings_(options.wordings),
        phrasings_of_template_(phrasings_of_template),
        writing_{options.phrasings, categories_in(start_), &start_},
        rng_(wording_stream(options.seed.value_or(task.record.run), task.record.slot, task.record.attempt)
                 .fork("pair", 0)) {
    trace_ = to_logic(start_, changes_by_moment(demonstration), reads_comparisons(task.specification.goal));
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
    add_others(pair);
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

  /// Where everyday words have too few forms, requests follow; where they have one only, a second one comes from the
  /// wider choice.
  void add_others(WordingsEntry& pair) const {
    add_others(pair, wordings_, writing_);
    if (writing_.phrasings != Phrasings::Everyday) return;
    add_requests(pair, pair.direct);
    const auto others = pair.others;
    for (const Instruction& other : others) add_requests(pair, other);
    if (texts_of_goal(pair).size() > 1) return;
    WritingOptions wider = writing_;
    wider.phrasings = Phrasings::All;
    add_others(pair, 2, wider);
  }

  void add_requests(WordingsEntry& pair, const Instruction& command) const {
    const auto known = texts_of_goal(pair);
    if (known.size() >= wordings_) return;
    Specification specification = task_.specification;
    specification.style = command.style;
    for (Instruction& request : requests_for(command, specification, backend_.knowledge, backend_.nouns_in(english_),
                                             start_, known, wordings_ - known.size())) {
      request.phrasing = 0;  // of a task's instruction only
      pair.others.push_back(std::move(request));
    }
  }

  /// Whether people name the things of the goal so: a task has it, or it fits.
  bool fits(Style style) const {
    return style == task_.specification.style ||
           may_use_phrases(style, task_.specification, backend_.knowledge, &uses_);
  }

  /// Plain texts first, the template's own among them; then in one style after the other.
  void add_others(WordingsEntry& pair, std::size_t wordings, WritingOptions writing) const {
    writing.phrasings_of_template = phrasings_of_template_;
    Specification specification = task_.specification;
    for (std::size_t style = 0; style < kStyleCount; ++style) {
      const auto known = texts_of_goal(pair);
      if (known.size() >= wordings) return;
      specification.style = static_cast<Style>(style);
      if (!fits(specification.style)) continue;
      for (Instruction& other : other_wordings(specification, backend_.knowledge, backend_.nouns_in(english_), writing,
                                               known, wordings - known.size(), rng_.fork("others", style))) {
        other.phrasing = 0;  // of a task's instruction only
        pair.others.push_back(std::move(other));
      }
    }
  }

  Result<Instruction> worded(const Formula& goal, Style style) const {
    Specification specification = task_.specification;
    specification.goal = goal;
    specification.style = style;
    return write_instruction(specification, backend_.knowledge, backend_.nouns_in(english_), writing_,
                             rng_.fork(name_of(style), 0));
  }

  const WordedTask& task_;
  const Scene& start_;
  const Backend& backend_;
  const PlaceUses& uses_;
  English english_;
  bool contrasts_;
  std::size_t wordings_;
  std::span<const std::string> phrasings_of_template_;
  WritingOptions writing_;
  Rng rng_;
  Trace trace_;
};

}  // namespace

Result<WordingsEntry> paired_wordings(const WordedTask& task, const Scene& start,
                                      const DemonstrationRecord& demonstration, const Resources& resources,
                                      const PairOptions& options) {
  return PairWriter(task, start, demonstration, resources.backend(task.specification.simulator),
                    resources.sense->common.place_uses(), phrasings_of_template(resources, task.record.template_name),
                    options)
      .pair();
}

Result<PairCounts> write_paired_wordings(const fs::path& folder, const Resources& resources, const PairOptions& options,
                                         const fs::path& file) {
  auto reader = DatasetReader::open(folder, {.modes = {Mode::M1}, .starts = true});
  if (!reader) return reader.error();
  auto lines = LinesWriter::begin(file);
  if (!lines) return lines.error();
  int line = 0;
  PairCounts counts;
  const auto done = for_each_task<WordingsEntry>(
      std::move(*reader), 1,
      [&](const FinishedTask& finished) -> Result<WordingsEntry> {
        const auto task = worded_task(folder, ++line, finished.record);
        if (!task) return task.error();
        return paired_wordings(*task, finished.start, finished.shown.at(Mode::M1), resources, options);
      },
      [&](WordingsEntry&& pair) {
        ++counts.tasks_by_wordings[texts_of_goal(pair).size()];
        counts.referring += pair.referring ? 1 : 0;
        counts.contrasts += pair.contrast ? 1 : 0;
        return lines->add(line_of(pair));
      });
  if (!done) return done.error();
  if (const auto finished = lines->finish(); !finished) return finished.error();
  return counts;
}

}  // namespace unietp
