#include "annotator/instruction.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "annotator/asides.h"
#include "annotator/conditions.h"
#include "annotator/function_phrases.h"
#include "annotator/meaning.h"
#include "annotator/parse.h"
#include "annotator/phrasing_sets.h"
#include "annotator/plan.h"
#include "annotator/realise.h"
#include "annotator/style.h"
#include "annotator/word_check.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr int kDraws = 120;      // forms tried before the grammar gives up on a style
constexpr int kPlainDraws = 30;  // of these, draws without an opening "Choose a …"
constexpr int kFreeDraws = 90;   // of these, draws that are not operator by operator

/// The goal of a text, in the style `condition` without the conditions that the start meets.
Formula intended_goal(const Formula& read, const Specification& specification) {
  Formula all = expanded(read);
  return specification.style == Style::Condition ? without_conditions(all, specification.init) : all;
}

/// `goal`: that of the specification, expanded.
bool reads_back(const std::string& text, const Specification& specification, const Formula& goal,
                const NounTable& lexicon) {
  const auto read = parse_with(lexicon.behind_context(text), lexicon);
  return read && same_expanded(intended_goal(*read, specification), goal) && form_faults(text, specification).empty();
}

std::vector<std::string> faults(const std::string& text, const Specification& specification, const NounTable& lexicon) {
  std::vector<std::string> found = form_faults(text, specification);
  const auto read = parse_with(lexicon.behind_context(text), lexicon);
  if (!read) {
    found.push_back(format(read.error()));
  } else if (!same_expanded(intended_goal(*read, specification), expanded(specification.goal))) {
    found.push_back("the text asks for " + to_text(normal_form(*read)) + ", the goal is " +
                    to_text(normal_form(specification.goal)));
  }
  return found;
}

/// A context sentence of one of the goal's categories, or "".
std::string context_of(const Specification& specification, const Knowledge& knowledge, Rng& rng) {
  std::vector<std::string> sentences;
  for (const std::string& category : categories_of(specification.goal))
    for (const Alias* alias : knowledge.aliases_of(category, AliasKind::Context)) sentences.push_back(alias->text);
  return sentences.empty() ? "" : rng.pick(sentences);
}

std::string with_capital(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// "Never mind the bowl.": a remark on an object of the scene that the goal does not involve; "" when there is none.
std::string bystander(const Specification& specification, const Knowledge& knowledge,
                      const std::vector<std::string>& around, Rng& rng) {
  const auto own = categories_of(specification.goal);
  std::vector<std::string> others;
  for (const std::string& name : around) {
    const Category* category = knowledge.find(name);
    const bool usable = category != nullptr && category->movable && category->countable;
    if (usable && std::find(own.begin(), own.end(), name) == own.end()) others.push_back(category->display);
  }
  if (others.empty()) return "";
  const auto words = never_minds();
  return with_capital(std::string(words[rng.below(words.size())])) + " the " + rng.pick(others) + ".";
}

/// Adds the sentences that a style adds around a text. False when there are none.
bool add_style_frame(std::string& text, Style style, const Specification& specification, const Knowledge& knowledge,
                     const std::vector<std::string>& around, Rng& rng) {
  if (style == Style::Context) {
    const std::string sentence = context_of(specification, knowledge, rng);
    text.insert(0, sentence + " ");
    return !sentence.empty();
  }
  if (style == Style::Background) {
    std::vector<std::string_view> sentences(backgrounds().begin(), backgrounds().end());
    rng.shuffle(sentences);
    const std::size_t count = 2 + rng.below(2);
    for (std::size_t i = 0; i < count; ++i) text.insert(0, std::string(sentences[i]) + " ");
  }
  if (style == Style::Bystander) {
    const std::string sentence = bystander(specification, knowledge, around, rng);
    text += " " + sentence;
    return !sentence.empty();
  }
  return true;
}

/// A wording of the plan from the set of phrasings asked for; about half of all wordings are.
std::optional<std::string> worded(const Plan& plan, const NounTable& lexicon, Style style, Phrasings phrasings,
                                  const Rng& rng) {
  constexpr std::uint64_t kWordings = 4;
  for (std::uint64_t i = 0; i < kWordings; ++i) {
    auto text = realise(plan, lexicon, style, rng.fork("words", i));
    if (!text || phrasings == Phrasings::All || phrasings_of(*text, lexicon) == phrasings) return text;
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
  const Formula goal = expanded(specification.goal);
  std::string last;
  std::vector<Style> styles{specification.style};
  if (specification.style != Style::Direct) styles.push_back(Style::Direct);
  for (const Style style : styles) {
    if (!has_material(specification, style, lexicon)) continue;
    bool exactly = false;
    for (int draw = 0; draw < kDraws; ++draw) {
      Rng own = rng.fork(name_of(style), static_cast<std::uint64_t>(draw));
      exactly = exactly || (draw >= kFreeDraws && style == Style::Direct);
      auto plan = plan_message(exactly ? specification.goal : goal, specification.init,
                               {draw >= kPlainDraws, style == Style::Condition, exactly}, own.fork("plan", 0));
      if (!plan && (exactly || style != Style::Direct)) break;
      if (!plan) {
        exactly = true;
        continue;
      }
      if (!turn_to_style(*plan, style)) continue;
      auto text = worded(*plan, lexicon, style, options.phrasings, own);
      if (!text) continue;
      if (!add_style_frame(*text, style, specification, knowledge, options.around, own)) break;
      if (reads_back(*text, specification, goal, lexicon) &&
          style_fault(*text, style, specification.goal, options.around, lexicon).empty())
        return Instruction{std::move(*text), "grammar", style, {"form", "parses-back", "style"}, ""};
      last = std::move(*text);
    }
  }
  std::string why = last.empty() ? "no form says it" : "\"" + last + "\"";
  for (const std::string& fault : last.empty() ? std::vector<std::string>() : faults(last, specification, lexicon))
    why += ": " + fault;
  return Error{Error::Kind::Unsatisfiable,
               specification.template_name,
               {},
               "the grammar found no text that says the goal and nothing else; the last one was " + why};
}

Result<Formula> parse_instruction(std::string_view text, const Knowledge& knowledge) {
  const NounTable nouns(knowledge);
  const std::string_view rest = nouns.behind_context(text);
  auto read = parse_with(rest, nouns);
  if (read) return read;
  Error error = read.error();
  // Nothing left: trimmed away, it is no part of the text any more.
  error.pos.column +=
      static_cast<int>(rest.empty() ? text.size() : static_cast<std::size_t>(rest.data() - text.data()));
  return error;
}

std::vector<std::string> check_instruction(const std::string& text, const Specification& specification,
                                           const Knowledge& knowledge) {
  return check_instruction(text, specification, knowledge, NounTable(knowledge));
}

std::vector<std::string> check_instruction(const std::string& text, const Specification& specification,
                                           const Knowledge& knowledge, const NounTable& nouns) {
  const auto narrowed = narrowed_for(specification, knowledge, nouns);
  return faults(text, specification, narrowed ? *narrowed : nouns);
}

}  // namespace unietp
