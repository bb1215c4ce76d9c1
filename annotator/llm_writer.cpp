#include "annotator/llm_writer.h"

#include <algorithm>
#include <optional>

#include "annotator/conditions.h"
#include "annotator/equivalence.h"
#include "annotator/function_phrases.h"
#include "annotator/judge.h"
#include "annotator/meaning.h"
#include "annotator/other_wordings.h"
#include "annotator/phenomena.h"
#include "annotator/spelling.h"
#include "annotator/style.h"
#include "annotator/word_check.h"
#include "annotator/wording_request.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr std::size_t kSamples = 3;  // example wordings in a prompt
constexpr int kReadings = 2;         // attempts of the judge to give a valid formula

/// The state of one task over the rounds.
struct Draft {
  WordingTask task;
  std::optional<NounTable> narrowed;
  std::vector<std::string> samples;
  std::optional<Result<Instruction>> done;
  std::optional<Instruction> grammar;
  std::string text;       // of the round, "" when there is none to judge
  std::string complaint;  // why the last text was rejected
  bool judging = false;
  std::string reading_complaint;

  const NounTable& nouns() const { return narrowed ? *narrowed : *task.nouns; }
};

class Rounds {
 public:
  Rounds(const std::vector<WordingTask>& tasks, const LlmWriterOptions& options)
      : options_(options), spelling_(Spelling::open()) {
    for (const WordingTask& task : tasks) {
      Draft draft;
      draft.task = task;
      if (!spelling_) draft.done = spelling_.error();
      draft.narrowed = narrowed_for(task.specification, *task.knowledge, *task.nouns);
      if (!draft.done) add_samples(draft);
      drafts_.push_back(std::move(draft));
    }
  }

  std::vector<LlmRequest> requests() const {
    std::vector<LlmRequest> all;
    for (const Draft& draft : drafts_)
      if (!draft.done) all.push_back(wording_request(draft.task, draft.samples, draft.complaint));
    return all;
  }

  std::vector<Result<Instruction>> run() {
    for (int round = 0; round <= options_.rewrites && any_open(); ++round) {
      write();
      for (int reading = 0; reading < kReadings; ++reading) judge();
      for (Draft& draft : drafts_)
        if (draft.judging) refuse(draft, draft.reading_complaint);
    }
    std::vector<Result<Instruction>> all;
    for (Draft& draft : drafts_) {
      if (!draft.done) fall_back(draft, "refused: " + draft.complaint);
      all.push_back(std::move(*draft.done));
    }
    return all;
  }

 private:
  /// The grammar's text and others of its that differ.
  void add_samples(Draft& draft) const {
    const WordingTask& task = draft.task;
    const WritingOptions writing{options_.phrasings, task.categories, task.home.get(), task.phrasings_of_template};
    auto text = write_instruction(task.specification, *task.knowledge, *task.nouns, writing, task.rng);
    if (!text) {
      draft.done = text.error();
      return;
    }
    draft.samples = {text->text};
    for (Instruction& other : other_wordings(task.specification, *task.knowledge, *task.nouns, writing, {text->text},
                                             kSamples - 1, task.rng.fork("sample", 0)))
      draft.samples.push_back(std::move(other.text));
    draft.grammar = std::move(*text);
  }

  bool any_open() const {
    return std::any_of(drafts_.begin(), drafts_.end(), [](const Draft& draft) { return !draft.done; });
  }

  static void fall_back(Draft& draft, std::string why) {
    draft.grammar->why = std::move(why);
    draft.done = *draft.grammar;
  }

  static void refuse(Draft& draft, std::string complaint) {
    draft.judging = false;
    draft.complaint = std::move(complaint);
  }

  /// Whether the answer is missing, which ends the task; unusable answers are reported to the model.
  static bool is_unanswered(Draft& draft, const Result<LlmAnswer>& answer) {
    if (answer || answer.error().kind == Error::Kind::Schema) return false;
    fall_back(draft, answer.error().message);
    return true;
  }

  void write() {
    std::vector<Draft*> open;
    for (Draft& draft : drafts_)
      if (!draft.done) open.push_back(&draft);
    const auto answers = options_.ask(requests());
    for (std::size_t i = 0; i < open.size(); ++i) {
      Draft& draft = *open[i];
      if (is_unanswered(draft, answers[i])) continue;
      const auto text = answers[i] ? worded(*answers[i]) : Result<std::string>(answers[i].error());
      if (!text) {
        refuse(draft, text.error().message);
        continue;
      }
      const auto wrong = faults(*text, draft);
      if (!wrong.empty()) {
        refuse(draft, "\"" + *text + "\": " + join(wrong, "; "));
        continue;
      }
      draft.text = *text;
      draft.judging = true;
      draft.reading_complaint.clear();
    }
  }

  std::vector<std::string> faults(const std::string& text, const Draft& draft) const {
    const Specification& specification = draft.task.specification;
    auto wrong = form_faults(text, specification);
    const auto said = saying_faults(text, specification, draft.nouns());
    wrong.insert(wrong.end(), said.begin(), said.end());
    auto other = misreading(text, specification, *draft.task.knowledge, *draft.task.nouns, draft.task.home.get());
    if (!other.empty()) wrong.push_back(std::move(other));
    const auto slips = spelling_->faults(text, draft.nouns());
    wrong.insert(wrong.end(), slips.begin(), slips.end());
    auto style = style_fault(text, specification.style, specification.goal, draft.task.categories, draft.nouns());
    if (!style.empty()) wrong.push_back(std::move(style));
    return wrong;
  }

  void judge() {
    std::vector<Draft*> open;
    std::vector<LlmRequest> requests;
    for (Draft& draft : drafts_) {
      if (draft.done || !draft.judging) continue;
      WordingTask read = draft.task;
      read.nouns = &draft.nouns();
      open.push_back(&draft);
      requests.push_back(judging_request(draft.text, read, draft.reading_complaint));
    }
    if (requests.empty()) return;
    const auto answers = options_.ask(requests);
    for (std::size_t i = 0; i < open.size(); ++i) {
      Draft& draft = *open[i];
      if (is_unanswered(draft, answers[i])) continue;
      const auto read = answers[i] ? judged(*answers[i]) : Result<Formula>(answers[i].error());
      if (!read) {
        draft.reading_complaint = format(read.error());
        continue;
      }
      const Specification& specification = draft.task.specification;
      const Formula expected =
          specification.style == Style::Condition ? without_conditions(expanded(*read), specification.init) : *read;
      if (!equivalent(expected, specification.goal)) {
        refuse(draft, "\"" + draft.text + "\" was understood as " + to_text(*read));
        continue;
      }
      draft.done = Instruction{draft.text,
                               "llm:" + options_.model,
                               draft.task.specification.style,
                               {"form", "words", "style", "judged-back"},
                               "",
                               phenomena_of(draft.text, specification.style, specification.goal, draft.nouns())};
    }
  }

  const LlmWriterOptions& options_;
  Result<Spelling> spelling_;
  std::vector<Draft> drafts_;
};

}  // namespace

std::vector<Result<Instruction>> write_instructions_with_llm(const std::vector<WordingTask>& tasks,
                                                             const LlmWriterOptions& options) {
  return Rounds(tasks, options).run();
}

std::vector<LlmRequest> first_requests(const std::vector<WordingTask>& tasks, const LlmWriterOptions& options) {
  return Rounds(tasks, options).requests();
}

}  // namespace unietp
