#include "annotator/instruction.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "annotator/another_meaning.h"
#include "annotator/authored.h"
#include "annotator/conditions.h"
#include "annotator/contrast.h"
#include "annotator/everyday_phrases.h"
#include "annotator/function_phrases.h"
#include "annotator/home_counts.h"
#include "annotator/home_facts.h"
#include "annotator/home_reading.h"
#include "annotator/home_sentences.h"
#include "annotator/meaning.h"
#include "annotator/parse.h"
#include "annotator/phenomena.h"
#include "annotator/phrasing_sets.h"
#include "annotator/plan.h"
#include "annotator/realize.h"
#include "annotator/sounds_right.h"
#include "annotator/style.h"
#include "annotator/word_check.h"
#include "core/text.h"
#include "scene/trace.h"

namespace unietp {
namespace {

constexpr int kDraws = 120;                  // forms tried before the grammar gives up on a style
constexpr int kPronounDraws = 8;             // of these, draws with "it" wherever it is clear
constexpr int kPlainDraws = 30;              // of these, draws without an opening "Choose a …"
constexpr int kFreeDraws = 90;               // of these, draws that are not operator by operator
constexpr double kAuthoredShare = 0.75;      // of the texts for which the template's own phrasings come first
constexpr std::uint64_t kAuthoredDraws = 2;  // ways to name the things of each

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

/// The categories in which a goal wants something, or which it wants open or closed.
std::vector<std::string> opened_in(const Formula& part, const Formula& goal) {
  std::vector<std::string> found;
  const bool is_atom = part.op == Formula::Op::Atom;
  const bool inside = is_atom && part.predicate == Predicate::Inside;
  const bool opens = is_atom && (part.predicate == Predicate::Open || part.predicate == Predicate::Closed);
  if (const Formula* binder = inside || opens ? binder_of(goal, part.terms[inside ? 1 : 0].name) : nullptr)
    for (const Domain::Member& member : binder->domain.members) found.push_back(member.category);
  for (const Formula& child : part.children)
    for (std::string& category : opened_in(child, goal)) found.push_back(std::move(category));
  return found;
}

/// What a text is held against: the specification with its goal expanded, and what is known of the home.
class TextChecker {
 public:
  TextChecker(const Specification& specification, const Knowledge& knowledge, const NounTable& lexicon,
              const Scene* home)
      : specification_(specification),
        knowledge_(knowledge),
        lexicon_(lexicon),
        home_(home),
        alone_(home == nullptr ? std::vector<std::string>() : alone_in(*home)),
        there_(home == nullptr ? std::vector<std::string>() : categories_in(*home)),
        start_(home == nullptr ? Trace() : to_logic(*home, {}, reads_comparisons(specification.goal))),
        counts_(home == nullptr ? HomeCounts() : HomeCounts(start_)),
        goal_(expanded(specification.goal)),
        plain_goal_(expanded(plainly_in_home(goal_, counts_))),
        goal_here_(expanded(as_in_home(goal_, counts_))),
        unique_(unique_variables(plain_goal_, counts_)),
        unique_for_author_(unique_variables(specification.goal, counts_)),
        opened_(opened_in(goal_, goal_)) {}
  TextChecker(const TextChecker&) = delete;

  const Formula& goal() const { return goal_; }
  /// As a text about this home says it.
  const Formula& plain_goal() const { return plain_goal_; }
  const HomeCounts& counts() const { return counts_; }
  /// Of which the home has one.
  const std::vector<std::string>& alone() const { return alone_; }
  const std::vector<std::string>& there() const { return there_; }
  /// Variables of the plain goal, and of the specification's, that can mean one thing only (home_counts.h).
  const std::vector<std::string>& unique() const { return unique_; }
  const std::vector<std::string>& unique_for_author() const { return unique_for_author_; }
  /// Categories in which something is to be, or that are to be opened or closed.
  const std::vector<std::string>& opened() const { return opened_; }
  const Trace& start() const { return start_; }

  /// Whether what a text names may be taken for another thing of the home.
  bool names_another(const std::string& text) const {
    return home_ != nullptr && may_mean_another(text, specification_.goal, *home_, knowledge_, lexicon_);
  }

  bool reads_back(const std::string& text) const {
    const auto read = readings(text);
    return read && !all_strained(*read) && all_match_goal(*read) && form_faults(text, specification_).empty();
  }

  std::vector<std::string> faults(const std::string& text) const {
    std::vector<std::string> found = form_faults(text, specification_);
    const auto read = readings(text);
    if (!read) {
      found.push_back(format(read.error()));
    } else if (read->empty()) {
      found.emplace_back("nothing that the text can mean is possible in this home, or what it says of it is not so");
    } else if (read->size() > 1 && !all_match_goal(*read)) {
      found.push_back("the text can be read in " + std::to_string(read->size()) + " ways in this home, such as " +
                      to_text((*read)[0].goal) + " and " + to_text((*read)[1].goal));
    } else if (!matches_goal(read->front().goal)) {
      found.push_back("the text asks for " + to_text(normal_form(read->front().goal)) + ", the goal is " +
                      to_text(normal_form(specification_.goal)));
    } else if (all_strained(*read)) {
      found.emplace_back(kStrainedPronoun);
    }
    return found;
  }

  /// What a text says that can be read, but not as the goal; "" for any other.
  std::string misreading(const std::string& text) const {
    const auto read = readings_of(text, lexicon_);
    if (!read || std::any_of(read->begin(), read->end(), [&](const Reading& one) { return matches_goal(one.goal); }))
      return "";
    return "the text asks for " + to_text(normal_form(read->front().goal)) + ", the goal is " +
           to_text(normal_form(specification_.goal));
  }

  Result<Formula> goal_of(const std::string& text) const {
    auto read = readings(text);
    if (!read) return read.error();
    *read = readings_in_home(std::move(*read), knowledge_, home_ == nullptr ? nullptr : &start());
    if (read->size() != 1 || read->front().strained)
      return Error{Error::Kind::Parse, "instruction", {1, 1}, "the text has several readings in this home, or none"};
    return read->front().goal;
  }

 private:
  Result<std::vector<Reading>> readings(const std::string& text) const {
    auto read = readings_of(text, lexicon_);
    const Trace* here = home_ == nullptr ? nullptr : &start();
    if (!read || (read->size() == 1 && facts_hold(read->front(), here))) return read;
    return readings_in_home(std::move(*read), knowledge_, here);
  }

  /// In the style `condition` without the conditions that the start meets.
  bool matches_goal(const Formula& read) const {
    Formula all = expanded(read);
    if (specification_.style == Style::Condition) all = without_conditions(all, specification_.init);
    return same_expanded(all, goal_) ||
           (counts_.is_known() && same_expanded(expanded(as_in_home(all, counts_)), goal_here_));
  }
  /// Also where there is none.
  static bool all_strained(const std::vector<Reading>& read) {
    return std::all_of(read.begin(), read.end(), [](const Reading& one) { return one.strained; });
  }
  /// Readings that are the same in this home are one.
  bool all_match_goal(const std::vector<Reading>& read) const {
    return std::all_of(read.begin(), read.end(), [&](const Reading& one) { return matches_goal(one.goal); });
  }

  const Specification& specification_;
  const Knowledge& knowledge_;
  const NounTable& lexicon_;
  const Scene* home_;
  std::vector<std::string> alone_, there_;
  Trace start_;  // empty when the home is not known
  HomeCounts counts_;
  Formula goal_, plain_goal_, goal_here_;
  std::vector<std::string> unique_, unique_for_author_, opened_;
};

/// Americans turn lights and machines on, and have gray cats.
std::string american(std::string text) {
  return replace_all(replace_all(std::move(text), " grey ", " gray "), " switched o", " turned o");
}

/// "Get something to drink it from and put it on the desk", not "take something to drink it from to the kitchen" nor
/// "wash something to stir it with and the mortar": what is needed comes last, or before what is done with it.
bool ends_with_need(const std::string& text, const std::string& need) {
  const std::size_t at = text.find(need);
  if (at == std::string::npos || !need.starts_with("something ")) return true;
  const std::string_view rest = std::string_view(text).substr(at + need.size());
  if (rest.starts_with(".") || rest.starts_with(",")) return true;
  constexpr std::array kThings{"the ", "a ", "an ", "some ", "one ", "both ", "all ", "something "};
  constexpr std::string_view kAnd = " and ";
  return rest.starts_with(kAnd) && std::none_of(kThings.begin(), kThings.end(), [&](const char* article) {
           return rest.substr(kAnd.size()).starts_with(article);
         });
}

bool ends_with_needs(const std::string& text, const NounTable& lexicon) {
  if (text.find("something ") == std::string::npos) return true;
  std::vector<const std::string*> said;
  for (const auto& [key, phrase] : lexicon.phrases()) {
    const std::string& need = phrase.use == AliasKind::Occasion ? phrase.need : phrase.text;
    if (text.find(need) != std::string::npos) said.push_back(&need);
  }
  // "Something to drink" is not meant by "something to drink from".
  const auto goes_on = [&](const std::string& need) {
    return std::any_of(said.begin(), said.end(),
                       [&](const std::string* longer) { return longer->starts_with(need + " "); });
  };
  return std::all_of(said.begin(), said.end(),
                     [&](const std::string* need) { return goes_on(*need) || ends_with_need(text, *need); });
}

/// Adds to a text what a style has besides what is asked. False when there is nothing to add.
bool add_style_frame(std::string& text, const Specification& specification, Style style, const TextChecker& judge,
                     const Knowledge& knowledge, const NounTable& lexicon, Rng& rng) {
  std::vector<std::string> sentences;
  // "Something to dry off with" is clear without "I'm about to take a shower.", too.
  const auto stands_alone = [&](const std::string& need) {
    return style != Style::Context && lexicon.phrases().contains(need);
  };
  for (const auto& [key, phrase] : lexicon.phrases())
    if (phrase.use == AliasKind::Occasion && ranges_over(specification.goal, phrase.noun) &&
        text.find(phrase.need) != std::string::npos && !stands_alone(phrase.need))
      sentences.push_back(phrase.text);
  if (!sentences.empty() || style == Style::Context) {
    std::erase_if(sentences, [&](const std::string& said) { return !can_be_said(said, judge.start(), lexicon); });
    if (sentences.empty()) return false;
    text.insert(0, rng.pick(sentences) + " ");
  } else if (style == Style::Aside) {
    auto own = categories_of(specification.goal);
    for (const Formula& start : specification.init)
      for (auto& category : categories_of(start)) own.push_back(std::move(category));
    sentences = home_sentences(judge.start(), specification.goal, own, knowledge, lexicon, rng.fork("home", 0));
    if (sentences.empty()) return false;
    text += " " + sentences[0];
  }
  return true;
}

/// A sentence that asks for the goal without naming anything: "It's too dark to read."
std::optional<std::string> request_for(const TextChecker& judge, const Formula& goal, const NounTable& lexicon,
                                       Rng& rng) {
  std::vector<std::string> sentences;
  for (const auto& [key, phrase] : lexicon.phrases())
    if (phrase.use == AliasKind::Request && ranges_over(goal, phrase.noun) && asks_for(goal, phrase.state) &&
        can_be_said(phrase.text, judge.start(), lexicon))
      sentences.push_back(phrase.text);
  return sentences.empty() ? std::nullopt : std::optional(rng.pick(sentences));
}

/// A wording of the plan from the set of phrasings asked for; about half of all wordings are.
std::optional<std::string> worded(const Plan& plan, const NounTable& lexicon, Style style, Phrasings set,
                                  const TextChecker& judge, double pronouns, const Rng& rng) {
  constexpr std::uint64_t kWordings = 4;
  const Wording wording{
      style, set == Phrasings::Everyday, judge.alone(), judge.there(), judge.opened(), judge.unique(), pronouns};
  for (std::uint64_t i = 0; i < kWordings; ++i) {
    auto text = realize(plan, lexicon, wording, rng.fork("words", i));
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

/// Writes the text of one task. `nouns`: with the phrases of its goal.
class Writer {
 public:
  Writer(const Specification& specification, const Knowledge& knowledge, const NounTable& nouns,
         const WritingOptions& options)
      : specification_(specification),
        knowledge_(knowledge),
        nouns_(nouns),
        options_(options),
        judge_(specification, knowledge, nouns, options.home) {}

  std::optional<Instruction> write(Style style, const Rng& rng) {
    if (!has_material(specification_, style, nouns_)) return std::nullopt;
    if (auto own = by_author(style, rng.fork("author", 0))) return own;
    bool exactly = false;
    for (int draw = 0; draw < kDraws; ++draw) {
      Rng own = rng.fork(name_of(style), static_cast<std::uint64_t>(draw));
      exactly = exactly || (draw >= kFreeDraws && style == Style::Direct);
      std::optional<std::string> text;
      // Of a goal that accepts very many things, a request may be all that says it.
      if (style == Style::Request || draw == kFreeDraws) text = request_for(judge_, specification_.goal, nouns_, own);
      if (style == Style::Request && !text) return std::nullopt;
      if (!text) {
        if (exactly && !options_.spells_out) return std::nullopt;
        auto plan =
            plan_message(exactly ? specification_.goal : judge_.plain_goal(), specification_.init,
                         {chooses(draw, style), style == Style::Condition, is_everyday(), exactly, judge_.counts()},
                         own.fork("plan", 0));
        if (!plan && (exactly || style != Style::Direct)) return std::nullopt;
        if (!plan) {
          exactly = true;
          continue;
        }
        if (!turn_to_style(*plan, style)) continue;
        // Where "it" could be two things, both are named.
        text = worded(*plan, nouns_, style, options_.phrasings, judge_, draw < kPronounDraws ? 1 : 0.5, own);
        if (!text) continue;
      }
      if (!framed(*text, style, own)) return std::nullopt;
      if (style == Style::Ellipsis && !with_contrast(*text, own)) continue;
      if (auto written = accepted(*text, style)) return written;
      last_ = std::move(*text);
    }
    return std::nullopt;
  }

  Error failure() const {
    std::string why = last_.empty() ? "no form says it" : "\"" + last_ + "\"";
    for (const std::string& fault : last_.empty() ? std::vector<std::string>() : judge_.faults(last_))
      why += ": " + fault;
    return Error{Error::Kind::Unsatisfiable,
                 specification_.template_name,
                 {},
                 "the grammar found no text that says the goal and nothing else; the last one was " + why};
  }

 private:
  /// Nobody says "choose a mug" who can say it otherwise.
  static bool chooses(int draw, Style style) { return draw >= kPlainDraws && style == Style::Direct; }
  bool is_everyday() const { return options_.phrasings == Phrasings::Everyday; }
  bool framed(std::string& text, Style style, Rng& rng) const {
    return add_style_frame(text, specification_, style, judge_, knowledge_, nouns_, rng);
  }

  /// "the red mug, not the blue one"
  bool with_contrast(std::string& text, Rng& rng) const {
    auto contrast =
        options_.home == nullptr ? std::nullopt : contrasted(text, judge_.goal(), *options_.home, nouns_, rng);
    if (contrast) text = std::move(*contrast);
    return contrast.has_value();
  }

  std::optional<Instruction> accepted(const std::string& written, Style style) const {
    std::string text = with_plain_places(nouns_.english() == English::Us ? american(written) : written);
    const auto where = text.find(" where ");
    const bool plain = with_plain_places(written) != written;
    // "Put it where we wash our hands and close it."
    if (plain && text.find(" it", where) != text.npos) return std::nullopt;
    if (!sounds_right(text) || !ends_with_needs(text, nouns_)) return std::nullopt;
    if (is_everyday()) text = with_zips(with_one_of(with_room_tables(with_tops(std::move(text), nouns_)), nouns_));
    if (is_everyday() && text.starts_with("Choose the ")) return std::nullopt;
    // Nobody closes "the place where we wash our hands".
    if (text.find(" the place where ") != text.npos || text.find(" the spot where ") != text.npos) return std::nullopt;
    if (options_.tells_apart && is_everyday() && judge_.names_another(text)) return std::nullopt;
    if (!judge_.reads_back(text) || !style_fault(text, style, specification_.goal, options_.around, nouns_).empty())
      return std::nullopt;
    return Instruction{text,  "grammar",
                       style, {"form", "parses-back", "style"},
                       "",    phenomena_of(text, style, specification_.goal, nouns_)};
  }

  /// Of the template's own phrasings one that says the goal in the style; some texts are left to the grammar.
  std::optional<Instruction> by_author(Style style, Rng rng) const {
    const auto phrasings = options_.phrasings_of_template;
    if (phrasings.empty() || !is_everyday() || !rng.chance(kAuthoredShare)) return std::nullopt;
    std::vector<std::size_t> order(phrasings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    rng.shuffle(order);
    for (const std::size_t i : order) {
      for (std::uint64_t draw = 0; draw < kAuthoredDraws; ++draw) {
        Rng own = rng.fork("phrasing", i * kAuthoredDraws + draw);
        const double pronouns = draw == 0 ? 1 : 0;
        auto text = authored_text(
            phrasings[i], specification_, nouns_,
            {style, true, judge_.alone(), judge_.there(), judge_.opened(), judge_.unique_for_author(), pronouns},
            judge_.counts(), own);
        if (!text || !framed(*text, style, own)) break;
        if (style == Style::Ellipsis && !with_contrast(*text, own)) break;
        auto written = accepted(*text, style);
        if (!written) continue;
        written->phrasing = static_cast<int>(i) + 1;
        return written;
      }
    }
    return std::nullopt;
  }

  const Specification& specification_;
  const Knowledge& knowledge_;
  const NounTable& nouns_;
  const WritingOptions& options_;
  TextChecker judge_;
  std::string last_;
};

}  // namespace

Result<Instruction> write_instruction(const Specification& specification, const Knowledge& knowledge,
                                      const NounTable& nouns, const WritingOptions& options, Rng rng) {
  const auto narrowed = narrowed_for(specification, knowledge, nouns);
  Writer writer(specification, knowledge, narrowed ? *narrowed : nouns, options);
  std::vector<Style> styles{specification.style};
  if (specification.style != Style::Direct) styles.push_back(Style::Direct);
  for (const Style style : styles)
    if (auto written = writer.write(style, rng)) return std::move(*written);
  return writer.failure();
}

Result<Formula> goal_of_text(const std::string& text, const Specification& specification, const Knowledge& knowledge,
                             const NounTable& nouns, const Scene& home) {
  return TextChecker(specification, knowledge, nouns, &home).goal_of(text);
}

std::string misreading(const std::string& text, const Specification& specification, const Knowledge& knowledge,
                       const NounTable& nouns, const Scene* home) {
  const auto narrowed = narrowed_for(specification, knowledge, nouns);
  return TextChecker(specification, knowledge, narrowed ? *narrowed : nouns, home).misreading(text);
}

std::vector<std::string> check_instruction(const std::string& text, const Specification& specification,
                                           const Knowledge& knowledge, const NounTable& nouns, const Scene* home) {
  const auto narrowed = narrowed_for(specification, knowledge, nouns);
  return TextChecker(specification, knowledge, narrowed ? *narrowed : nouns, home).faults(text);
}

}  // namespace unietp
