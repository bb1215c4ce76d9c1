#include "annotator/instruction.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "annotator/meaning.h"
#include "annotator/noun_table.h"
#include "annotator/parse.h"
#include "annotator/plan.h"
#include "annotator/realise.h"
#include "annotator/style.h"
#include "core/text.h"
#include "generator/consistency.h"

namespace unietp {
namespace {

constexpr int kDraws = 120;      // forms tried before the grammar gives up on a style
constexpr int kPlainDraws = 30;  // of these without an opening "Choose a …"

/// The text behind a context sentence of the alias table.
std::string_view without_context(std::string_view text, const Knowledge& knowledge) {
  std::size_t longest = 0;
  for (const Alias& alias : knowledge.aliases())
    if (alias.kind == "context" && text.starts_with(alias.text)) longest = std::max(longest, alias.text.size());
  text.remove_prefix(longest);
  return trim(text);
}

/// A word such as `mug_3`: an id of the scene, not English.
bool leaks_id(const Token& token) {
  const std::size_t mark = token.text.rfind('_');
  if (mark == std::string::npos || mark == 0 || mark + 1 == token.text.size()) return false;
  return std::all_of(token.text.begin() + static_cast<std::ptrdiff_t>(mark) + 1, token.text.end(),
                     [](unsigned char c) { return std::isdigit(c); });
}

/// The categories of a domain that the goal or start ranges over become another domain.
Formula with_domain(Formula formula, const Domain& from, const Domain& to) {
  if (formula.domain.kind == from.kind && formula.domain.members == from.members) formula.domain.members = to.members;
  for (Formula& where : formula.domain.where) where = with_domain(where, from, to);
  for (Formula& child : formula.children) child = with_domain(child, from, to);
  return formula;
}

void collect_domains(const Formula& formula, std::vector<Domain>& into) {
  Domain bare = formula.domain;
  bare.where.clear();
  if (bare.kind == Domain::Kind::Categories && !bare.members.empty() && !bare.members[0].slice &&
      std::find(into.begin(), into.end(), bare) == into.end())
    into.push_back(bare);
  for (const Formula& child : formula.children) collect_domains(child, into);
}

bool holds_member(const Domain& domain, const Domain::Member& member) {
  return std::find(domain.members.begin(), domain.members.end(), member) != domain.members.end();
}

/// "something to drink from" means, in this task, the categories that could ever satisfy the goal: when the goal ranges
/// over these alone, that is what the phrase says.
/// nullopt: the phrases mean what they always do.
std::optional<NounTable> narrowed_for(const Specification& specification, const Knowledge& knowledge,
                                      const NounTable& usual) {
  if (specification.style != "function") return std::nullopt;
  NounTable nouns = usual;
  std::vector<Domain> domains;
  collect_domains(specification.goal, domains);
  const auto phrases = nouns.function_phrases();
  for (const auto& [phrase, served] : phrases) {
    for (const Domain& domain : domains) {
      bool means = std::all_of(domain.members.begin(), domain.members.end(),
                               [&all = served](const auto& member) { return holds_member(all, member); });
      for (const Domain::Member& member : served.members) {
        if (!means || holds_member(domain, member)) continue;
        Specification other = specification;
        const Domain alone = of_category(member.category);
        other.goal = with_domain(other.goal, domain, alone);
        for (Formula& start : other.init) start = with_domain(start, domain, alone);
        means = contradiction(other, knowledge).has_value();
      }
      if (!means) continue;
      nouns.narrow(phrase, domain);
      break;
    }
  }
  return nouns;
}

std::vector<std::string> faults(const std::string& text, const Specification& specification, const Knowledge& knowledge,
                                const NounTable& lexicon) {
  std::vector<std::string> found;
  for (const Token& token : tokens_of(text))
    if (leaks_id(token)) found.push_back("the text names the object id '" + token.text + "'");
  const auto read = parse_with(without_context(text, knowledge), lexicon);
  if (!read) {
    found.push_back(format(read.error()));
  } else if (!same_meaning(*read, specification.goal)) {
    found.push_back("the text asks for " + to_text(normal_form(*read)) + ", the goal is " +
                    to_text(normal_form(specification.goal)));
  }
  return found;
}

/// A context sentence of one of the goal's categories, or "".
std::string context_of(const Specification& specification, const Knowledge& knowledge, Rng& rng) {
  std::vector<std::string> sentences;
  for (const std::string& category : categories_of(specification.goal))
    for (const Alias* alias : knowledge.aliases_of(category, "context")) sentences.push_back(alias->text);
  return sentences.empty() ? "" : rng.pick(sentences);
}

bool has_material(const Specification& specification, const NounTable& lexicon) {
  if (specification.style != "alias") return true;
  const auto categories = categories_of(specification.goal);
  return std::any_of(categories.begin(), categories.end(),
                     [&](const std::string& c) { return !lexicon.synonyms(c).empty(); });
}

}  // namespace

Result<Instruction> write_instruction(const Specification& specification, const Knowledge& knowledge, Rng rng) {
  return write_instruction(specification, knowledge, NounTable(knowledge), rng);
}

Result<Instruction> write_instruction(const Specification& specification, const Knowledge& knowledge,
                                      const NounTable& nouns, Rng rng) {
  const auto narrowed = narrowed_for(specification, knowledge, nouns);
  const NounTable& lexicon = narrowed ? *narrowed : nouns;
  std::string last = "no form was drawn";
  std::vector<std::string> styles{specification.style};
  if (specification.style != "direct") styles.push_back("direct");
  for (const std::string& style : styles) {
    Specification asked = specification;
    asked.style = style;
    if (!has_material(asked, lexicon)) continue;
    for (int draw = 0; draw < kDraws; ++draw) {
      Rng own = rng.fork(style, static_cast<std::uint64_t>(draw));
      auto plan = plan_message(asked.goal, asked.init, draw >= kPlainDraws, own.fork("plan", 0));
      if (!plan) return plan.error();
      if (!turn_to_style(*plan, style)) continue;
      const auto text = realise(*plan, lexicon, style, own.fork("words", 0));
      if (!text) continue;
      std::string whole = *text;
      if (style == "context") {
        const std::string sentence = context_of(asked, knowledge, own);
        if (sentence.empty()) break;
        whole = sentence + " " + whole;
      }
      auto wrong = faults(whole, asked, knowledge, lexicon);
      if (std::string fault = style_fault(whole, style, asked.goal, lexicon); !fault.empty())
        wrong.push_back(std::move(fault));
      if (wrong.empty()) return Instruction{whole, "grammar", style, {"parses-back", "no-ids", "style"}};
      last = "\"" + whole + "\": " + wrong.front();
    }
  }
  return Error{Error::Kind::Unsatisfiable,
               specification.template_name,
               {},
               "the grammar found no text that says the goal and nothing else; the last one was " + last};
}

Result<Formula> parse_instruction(std::string_view text, const Knowledge& knowledge) {
  const std::string_view rest = without_context(text, knowledge);
  auto read = parse_with(rest, NounTable(knowledge));
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
  return faults(text, specification, knowledge, narrowed ? *narrowed : nouns);
}

}  // namespace unietp
