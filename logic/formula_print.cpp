#include "logic/formula.h"
#include "logic/formula_words.h"

namespace unietp {
namespace {

std::string_view word_of(Formula::Op op) {
  if (op == Formula::Op::CountCompare) return "count";
  for (const auto& known : kOperatorWords) {
    if (known.op == op) return known.word;
  }
  return "";
}

std::string text_of(const Term& term) { return term.kind == Term::Kind::Variable ? "?" + term.name : term.name; }

std::string text_without_where(const Domain& domain) {
  switch (domain.kind) {
    case Domain::Kind::Object:
      return "object";
    case Domain::Kind::Room:
      return "room";
    case Domain::Kind::Agent:
      return "agent";
    case Domain::Kind::Categories:
      break;
  }
  const bool either = domain.members.size() != 1;
  std::string text = either ? "(either" : "";
  for (const auto& member : domain.members) {
    if (either) text += ' ';
    text += member.category;
    if (member.slice) text += "/slice";
  }
  if (either) text += ')';
  return text;
}

void print(const Formula& formula, std::string& out) {
  const bool is_atom = formula.op == Formula::Op::Atom;
  out += '(';
  out += is_atom ? info(formula.predicate).name : word_of(formula.op);
  if (formula.op == Formula::Op::Count || formula.op == Formula::Op::CountCompare) {
    out += ' ';
    out += symbol_of(formula.comparison);
  }
  if (formula.op == Formula::Op::Count) {
    out += ' ';
    out += std::to_string(formula.number);
  }
  for (const auto& term : formula.terms) {
    out += ' ';
    out += text_of(term);
  }
  if (!formula.variable.empty()) {
    out += " (?" + formula.variable + " - ";
    out += to_text(formula.domain);
    out += ')';
  }
  for (const auto& child : formula.children) {
    out += ' ';
    print(child, out);
  }
  out += ')';
}

}  // namespace

std::string_view symbol_of(Comparison comparison) {
  switch (comparison) {
    case Comparison::Equal:
      return "=";
    case Comparison::AtLeast:
      return ">=";
    case Comparison::AtMost:
      return "<=";
    case Comparison::Greater:
      return ">";
    case Comparison::Less:
      return "<";
  }
  return "";
}

std::string to_text(const Domain& domain) {
  if (domain.where.empty()) return text_without_where(domain);
  std::string text = "(";
  text += text_without_where(domain);
  text += " :where ";
  print(domain.where.front(), text);
  text += ')';
  return text;
}

std::string to_text(const Formula& formula) {
  std::string text;
  print(formula, text);
  return text;
}

}  // namespace unietp
