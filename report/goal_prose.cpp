#include "report/goal_prose.h"

#include <cctype>

#include "annotator/words_for_writing.h"
#include "core/text.h"

namespace unietp {
namespace {

using Op = Formula::Op;

std::string inline_text(const Formula& formula, bool negated);

std::string words_of_domain(const Domain& domain) {
  std::string words;
  if (domain.kind == Domain::Kind::Object) words = "object";
  if (domain.kind == Domain::Kind::Room) words = "room";
  if (domain.kind == Domain::Kind::Agent) words = "agent";
  for (const auto& member : domain.members)
    words += (words.empty() ? "" : " or ") + std::string(member.slice ? "slice of " : "") +
             words_of_category(member.category);
  return words;
}

/// The variable with what it ranges over: "mug a", "mug a (which is dirty at the start)".
std::string named(const Formula& quantifier) {
  std::string text = words_of_domain(quantifier.domain) + " " + quantifier.variable;
  for (const Formula& where : quantifier.domain.where)
    text += " (such that, at the start, " + inline_text(where, false) + ")";
  return text;
}

std::string words_of(const Term& term) { return term.kind == Term::Kind::Agent ? "the agent" : term.name; }

std::string words_of_atom(const Formula& atom, bool negated) {
  const std::string is = negated ? " is not " : " is ";
  const std::string first = words_of(atom.terms[0]);
  const std::string second = atom.terms.size() > 1 ? words_of(atom.terms[1]) : "";
  switch (atom.predicate) {
    case Predicate::Filled:
      return first + is + "filled with " + second;
    case Predicate::Covered:
      return first + is + "covered with " + second;
    case Predicate::Color:
    case Predicate::Size:
      return first + is + second;
    case Predicate::Material:
      return first + is + "made of " + second;
    case Predicate::Held:
      return first + is + "held";
    case Predicate::SatOn:
      return first + is + "sat on";
    case Predicate::LainOn:
      return first + is + "lain on";
    case Predicate::SliceOf:
      return first + is + "a slice of " + second;
    case Predicate::OnFloor:
      return first + is + "on the floor of " + second;
    case Predicate::InRoom:
      return first + is + "in " + second;
    default:
      break;
  }
  const std::string state = second.empty() ? state_word(atom.predicate) : before_object(atom.predicate);
  const std::string word = state.empty() ? replace_all(std::string(info(atom.predicate).name), "_", " ") : state;
  return first + is + word + (second.empty() ? "" : " " + second);
}

std::string comparison_words(Comparison comparison) {
  switch (comparison) {
    case Comparison::Equal:
      return "exactly";
    case Comparison::AtLeast:
      return "at least";
    case Comparison::AtMost:
      return "at most";
    case Comparison::Greater:
      return "more than";
    case Comparison::Less:
      return "fewer than";
  }
  return "";
}

std::string quantifier_words(const Formula& formula) {
  switch (formula.op) {
    case Op::Forall:
      return "for every " + named(formula);
    case Op::Count:
      return "for " + comparison_words(formula.comparison) + " " + std::to_string(formula.number) + " " +
             named(formula);
    default:
      return "for some " + named(formula);
  }
}

bool is_quantifier(Op op) { return op == Op::Exists || op == Op::Forall || op == Op::Count; }

std::string joined(const Formula& formula, const std::string& word) {
  std::vector<std::string> parts;
  for (const Formula& child : formula.children) {
    const bool nested = child.op == Op::And || child.op == Op::Or || child.op == Op::Imply;
    parts.push_back(nested ? "(" + inline_text(child, false) + ")" : inline_text(child, false));
  }
  return join(parts, " " + word + " ");
}

/// The formula in one line.
std::string inline_text(const Formula& formula, bool negated) {
  if (negated && formula.op != Op::Atom && formula.op != Op::Equal && formula.op != Op::Not)
    return "it is not the case that " + inline_text(formula, false);
  switch (formula.op) {
    case Op::Atom:
      return words_of_atom(formula, negated);
    case Op::Equal:
      return words_of(formula.terms[0]) + (negated ? " is a different object than " : " is the same as ") +
             words_of(formula.terms[1]);
    case Op::And:
      return formula.children.empty() ? "nothing is required" : joined(formula, "and");
    case Op::Or:
      return formula.children.empty() ? "this cannot be satisfied" : joined(formula, "or");
    case Op::Not:
      return negated ? inline_text(formula.children[0], false) : inline_text(formula.children[0], true);
    case Op::Imply:
      return "if " + inline_text(formula.children[0], false) + " then " + inline_text(formula.children[1], false);
    case Op::Forall:
    case Op::Exists:
    case Op::Count:
      return quantifier_words(formula) + ": " + inline_text(formula.children[0], false);
    case Op::Number:
      return "the number of " + named(formula) + " with " + inline_text(formula.children[0], false);
    case Op::CountCompare: {
      const char* is = formula.comparison == Comparison::Equal     ? " equals "
                       : formula.comparison == Comparison::AtLeast ? " is at least "
                       : formula.comparison == Comparison::AtMost  ? " is at most "
                       : formula.comparison == Comparison::Greater ? " is greater than "
                                                                   : " is less than ";
      return inline_text(formula.children[0], false) + is + inline_text(formula.children[1], false);
    }
    case Op::AtEnd:
      return "at the end, " + inline_text(formula.children[0], false);
    case Op::Sometime:
      return "at some time, " + inline_text(formula.children[0], false);
    case Op::Always:
      return "at all times, " + inline_text(formula.children[0], false);
    case Op::Until:
      return inline_text(formula.children[0], false) + " until " + inline_text(formula.children[1], false);
    case Op::Before:
      return "first " + inline_text(formula.children[0], false) + ", and later for the first time " +
             inline_text(formula.children[1], false);
  }
  return "";
}

bool is_short(const Formula& formula) {
  constexpr std::size_t kLine = 80;
  if (formula.op == Op::Atom || formula.op == Op::Equal) return true;
  if (is_quantifier(formula.op)) return false;
  for (const Formula& child : formula.children) {
    if (!is_short(child)) return false;
  }
  return inline_text(formula, false).size() <= kLine;
}

class Outline {
 public:
  std::vector<ProseLine> lines;

  void say(const Formula& formula, int depth) {
    if (formula.op == Op::And && !formula.children.empty()) {
      for (const Formula& child : formula.children) say(child, depth);
      return;
    }
    if (is_short(formula) || formula.children.empty()) return line(depth, inline_text(formula, false));
    switch (formula.op) {
      case Op::Forall:
      case Op::Exists:
      case Op::Count:
        return quantified(formula, depth);
      case Op::Or:
        line(depth, "at least one of these:");
        for (const Formula& child : formula.children) {
          line(depth + 1, "either");
          say(child, depth + 2);
        }
        return;
      case Op::Not:
        return below(formula, "it is not the case that:", depth);
      case Op::AtEnd:
        return below(formula, "at the end:", depth);
      case Op::Sometime:
        return below(formula, "at some time:", depth);
      case Op::Always:
        return below(formula, "at all times:", depth);
      case Op::Imply:
        return two(formula, "if", "then", depth);
      case Op::Until:
        return two(formula, "continuously,", "until", depth);
      case Op::Before:
        return two(formula, "first", "and later, for the first time,", depth);
      default:
        return line(depth, inline_text(formula, false));
    }
  }

 private:
  void line(int depth, std::string text) { lines.push_back({depth, std::move(text)}); }

  /// Quantifiers of one kind that follow each other share a line.
  void quantified(const Formula& formula, int depth) {
    std::string text = quantifier_words(formula);
    const Formula* inner = &formula;
    while (inner->children[0].op == formula.op && formula.op != Op::Count) {
      inner = &inner->children[0];
      text += (formula.op == Op::Exists ? " and some " : " and every ") + named(*inner);
    }
    line(depth, text + ":");
    say(inner->children[0], depth + 1);
  }

  void below(const Formula& formula, const char* head, int depth) {
    line(depth, head);
    say(formula.children[0], depth + 1);
  }

  void two(const Formula& formula, const char* first, const char* second, int depth) {
    line(depth, first);
    say(formula.children[0], depth + 1);
    line(depth, second);
    say(formula.children[1], depth + 1);
  }
};

}  // namespace

std::vector<ProseLine> goal_prose(const Formula& goal) {
  Outline outline;
  outline.say(goal, 0);
  return std::move(outline.lines);
}

std::string words_of_category(const std::string& category) {
  const std::string name = category.substr(0, category.find(".n."));
  std::string words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool begins = std::isupper(c) != 0 && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1])) != 0;
    if (begins) words += ' ';
    words += c == '_' ? ' ' : static_cast<char>(std::tolower(c));
  }
  return words;
}

}  // namespace unietp
