#include "annotator/instruction.h"

#include <algorithm>
#include <optional>

#include "annotator/conditions.h"
#include "annotator/function_phrases.h"
#include "annotator/home_facts.h"
#include "annotator/home_reading.h"
#include "annotator/home_sentences.h"
#include "annotator/meaning.h"
#include "annotator/parse.h"
#include "annotator/phrasing_sets.h"
#include "annotator/plan.h"
#include "annotator/realise.h"
#include "annotator/style.h"
#include "annotator/word_check.h"
#include "scene/trace.h"

namespace unietp {
namespace {

constexpr int kDraws = 120;      // forms tried before the grammar gives up on a style
constexpr int kPlainDraws = 30;  // of these, draws without an opening "Choose a …"
constexpr int kFreeDraws = 90;   // of these, draws that are not operator by operator

bool ranges_over(const Formula& formula, const Domain& noun) {
  if (formula.domain.kind == noun.kind && formula.domain.members == noun.members) return true;
  return std::any_of(formula.children.begin(), formula.children.end(),
                     [&](const Formula& child) { return ranges_over(child, noun); });
}

bool asks_for(const Formula& formula, Predicate state) {
  if (formula.op == Formula::Op::Atom && formula.predicate == state) return true;
  return std::any_of(formula.children.begin(), formula.children.end(),
                     [&](const Formula& child) { return asks_for(child, state); });
}

/// What a text is held against: the specification with its goal expanded, and what is known of the home.
class Judge {
 public:
  Judge(const Specification& specification, const Knowledge& knowledge, const NounTable& lexicon, const Scene* home)
      : specification_(specification), knowledge_(knowledge), lexicon_(lexicon), goal_(expanded(specification.goal)) {
    if (home != nullptr) start_ = to_logic(*home, {}, reads_comparisons(specification.goal));
  }

  const Formula& goal() const { return goal_; }
  const Trace& start() const { return start_; }

  bool reads_back(const std::string& text) const {
    const auto read = readings(text);
    return read && read->size() == 1 && is_meant(read->front().goal) && form_faults(text, specification_).empty();
  }

  std::vector<std::string> faults(const std::string& text) const {
    std::vector<std::string> found = form_faults(text, specification_);
    const auto read = readings(text);
    if (!read) {
      found.push_back(format(read.error()));
    } else if (read->empty()) {
      found.emplace_back("nothing that the text can mean is possible in this home, or what it says of it is not so");
    } else if (read->size() > 1) {
      found.push_back("the text can be read in " + std::to_string(read->size()) + " ways in this home, such as " +
                      to_text((*read)[0].goal) + " and " + to_text((*read)[1].goal));
    } else if (!is_meant(read->front().goal)) {
      found.push_back("the text asks for " + to_text(normal_form(read->front().goal)) + ", the goal is " +
                      to_text(normal_form(specification_.goal)));
    }
    return found;
  }

 private:
  Result<std::vector<Reading>> readings(const std::string& text) const {
    auto read = readings_of(text, lexicon_);
    if (!read || (read->size() == 1 && read->front().facts.empty())) return read;
    return readings_in_home(std::move(*read), knowledge_, start_.states.empty() ? nullptr : &start_);
  }

  /// In the style `condition` without the conditions that the start meets.
  bool is_meant(const Formula& read) const {
    Formula all = expanded(read);
    if (specification_.style == Style::Condition) all = without_conditions(all, specification_.init);
    return same_expanded(all, goal_);
  }

  const Specification& specification_;
  const Knowledge& knowledge_;
  const NounTable& lexicon_;
  Formula goal_;
  Trace start_;
};

/// Puts the sentences that a style has in front of a text. False when there are none.
bool add_style_frame(std::string& text, const Specification& specification, Style style, const Judge& judge,
                     const Knowledge& knowledge, const NounTable& lexicon, Rng& rng) {
  std::vector<std::string> sentences;
  if (style == Style::Context || text.find("I need for that") != std::string::npos) {
    for (const auto& [key, phrase] : lexicon.phrases())
      if (phrase.use == AliasKind::Occasion && ranges_over(specification.goal, phrase.noun))
        sentences.push_back(phrase.text);
    if (sentences.empty()) return false;
    text.insert(0, rng.pick(sentences) + " ");
  } else if (style == Style::Aside) {
    auto own = categories_of(specification.goal);
    for (const Formula& start : specification.init)
      for (auto& category : categories_of(start)) own.push_back(std::move(category));
    sentences = home_sentences(judge.start(), own, knowledge, lexicon, rng.fork("home", 0));
    if (sentences.empty()) return false;
    const std::size_t count = std::min<std::size_t>(sentences.size(), 1 + rng.below(2));
    for (std::size_t i = 0; i < count; ++i) text.insert(0, sentences[i] + " ");
  }
  return true;
}

/// A sentence that asks for the goal without naming anything: "It's too dark to read."
std::optional<std::string> request_for(const Formula& goal, const NounTable& lexicon, Rng& rng) {
  std::vector<std::string> sentences;
  for (const auto& [key, phrase] : lexicon.phrases())
    if (phrase.use == AliasKind::Request && ranges_over(goal, phrase.noun) && asks_for(goal, phrase.state))
      sentences.push_back(phrase.text);
  return sentences.empty() ? std::nullopt : std::optional(rng.pick(sentences));
}

/// A wording of the plan from the set of phrasings asked for; about half of all wordings are.
std::optional<std::string> worded(const Plan& plan, const NounTable& lexicon, Style style, Phrasings set,
                                  std::span<const std::string> alone, const Rng& rng) {
  constexpr std::uint64_t kWordings = 4;
  const Wording wording{style, set == Phrasings::Everyday, alone};
  for (std::uint64_t i = 0; i < kWordings; ++i) {
    auto text = realise(plan, lexicon, wording, rng.fork("words", i));
    if (!text || set == Phrasings::Everyday || set == Phrasings::All || phrasings_of(*text, lexicon) == set)
      return text;
  }
  return std::nullopt;
}

bool has_material(const Specification& specification, Style style, const NounTable& lexicon) {
  if (style != Style::Alias) return true;
  const auto categories = categories_of(specification.goal);
  return std::any_of(categories.begin(), categories.end(),
                     [&](const std::string& c) { return !lexicon.synonyms(c).empty(); });
}

}  // namespace

Result<Instruction> write_instruction(const Specification& specification, const Knowledge& knowledge, Rng rng) {
  return write_instruction(specification, knowledge, NounTable(knowledge), {}, rng);
}

Result<Instruction> write_instruction(const Specification& specification, const Knowledge& knowledge,
                                      const NounTable& nouns, const WritingOptions& options, Rng rng) {
  const auto narrowed = narrowed_for(specification, knowledge, nouns);
  const NounTable& lexicon = narrowed ? *narrowed : nouns;
  const Judge judge(specification, knowledge, lexicon, specification.style == Style::Direct ? nullptr : options.home);
  const Phrasings set = options.phrasings;
  const bool everyday = set == Phrasings::Everyday;
  const auto alone = options.home == nullptr ? std::vector<std::string>() : alone_in(*options.home);
  std::string last;
  std::vector<Style> styles{specification.style};
  if (specification.style != Style::Direct) styles.push_back(Style::Direct);
  for (const Style style : styles) {
    if (!has_material(specification, style, lexicon)) continue;
    bool exactly = false;
    for (int draw = 0; draw < kDraws; ++draw) {
      Rng own = rng.fork(name_of(style), static_cast<std::uint64_t>(draw));
      exactly = exactly || (draw >= kFreeDraws && style == Style::Direct);
      std::optional<std::string> text;
      // Of a goal that accepts very many things, a request may be all that says it.
      if (style == Style::Request || draw == kFreeDraws) text = request_for(specification.goal, lexicon, own);
      if (style == Style::Request && !text) break;
      if (!text) {
        auto plan =
            plan_message(exactly ? specification.goal : judge.goal(), specification.init,
                         {draw >= kPlainDraws, style == Style::Condition, everyday, exactly}, own.fork("plan", 0));
        if (!plan && (exactly || style != Style::Direct)) break;
        if (!plan) {
          exactly = true;
          continue;
        }
        if (!turn_to_style(*plan, style)) continue;
        text = worded(*plan, lexicon, style, set, alone, own);
        if (!text) continue;
      }
      if (!add_style_frame(*text, specification, style, judge, knowledge, lexicon, own)) break;
      if (judge.reads_back(*text) && style_fault(*text, style, specification.goal, options.around, lexicon).empty())
        return Instruction{std::move(*text), "grammar", style, {"form", "parses-back", "style"}, ""};
      last = std::move(*text);
    }
  }
  std::string why = last.empty() ? "no form says it" : "\"" + last + "\"";
  for (const std::string& fault : last.empty() ? std::vector<std::string>() : judge.faults(last)) why += ": " + fault;
  return Error{Error::Kind::Unsatisfiable,
               specification.template_name,
               {},
               "the grammar found no text that says the goal and nothing else; the last one was " + why};
}

Result<Formula> parse_instruction(std::string_view text, const Knowledge& knowledge) {
  return parse_with(text, NounTable(knowledge));
}

std::vector<std::string> check_instruction(const std::string& text, const Specification& specification,
                                           const Knowledge& knowledge) {
  return check_instruction(text, specification, knowledge, NounTable(knowledge));
}

std::vector<std::string> check_instruction(const std::string& text, const Specification& specification,
                                           const Knowledge& knowledge, const NounTable& nouns, const Scene* home) {
  const auto narrowed = narrowed_for(specification, knowledge, nouns);
  return Judge(specification, knowledge, narrowed ? *narrowed : nouns, home).faults(text);
}

}  // namespace unietp
