#include "templates/template_text.h"

#include <algorithm>

#include "templates/constraint_kinds.h"
#include "templates/purpose_reading.h"

namespace unietp {
namespace {

constexpr std::size_t kWidth = 120;

std::string one_line(const Sexpr& expression) {
  if (expression.is_atom()) return expression.text;
  if (!expression.is_list()) return quoted_string(expression.text);
  std::string text = "(";
  for (const auto& child : expression.children) {
    if (text.size() > 1) text += ' ';
    text += one_line(child);
  }
  return text + ")";
}

/// `(?x - D)`, `(A - movable)`
bool is_declaration(const Sexpr& expression) {
  return expression.is_list() && expression.children.size() == 3 && expression.children[1].is_atom("-");
}

std::string laid_out_formula(const Formula& formula, std::size_t indent) {
  const auto expression = read_sexpr("", to_text(formula));
  return laid_out(*expression, indent);  // what to_text prints can be read
}

std::string section(const std::string& name, const std::vector<std::string>& items) {
  std::string text = "\n  (" + name;
  for (const auto& item : items) text += "\n    " + item;
  return text + ")";
}

}  // namespace

std::string quoted_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

std::string laid_out(const Sexpr& expression, std::size_t indent) {
  auto line = one_line(expression);
  if (indent + line.size() <= kWidth || !expression.is_list() || expression.children.size() < 2) return line;
  std::string text = "(" + one_line(expression.children.front());
  std::size_t next = 1;
  // What tells the form stays on its line: comparison, number, variable and domain.
  while (next < expression.children.size() &&
         (!expression.children[next].is_list() || is_declaration(expression.children[next]))) {
    text += " " + one_line(expression.children[next++]);
  }
  for (; next < expression.children.size(); ++next) {
    text += "\n" + std::string(indent + 2, ' ') + laid_out(expression.children[next], indent + 2);
  }
  return text + ")";
}

std::string to_text(const Template& source) {
  std::string text = "(template " + source.name;
  text += "\n  (name " + quoted_string(source.title) + ")";
  if (!source.purpose.name.empty()) text += "\n  (purpose " + to_text(source.purpose) + ")";
  text += "\n  (split " + std::string(name_of(source.split)) + ")";
  if (!source.refinement.empty()) text += "\n  (refinement " + source.refinement + ")";
  text += "\n  (simulators";
  for (const auto simulator : source.simulators) text += " " + std::string(name_of(simulator));
  text += ")\n  (parameters";
  for (const auto& parameter : source.parameters) {
    text += " (" + parameter.name + " -";
    for (const auto& word : parameter.affordances) text += " " + word;
    text += ")";
  }
  text += ")";
  if (!source.constraints.empty()) {
    text += "\n  (constraints";
    for (const auto& constraint : source.constraints) text += " " + to_text(constraint);
    text += ")";
  }
  std::vector<std::string> starts;
  for (const auto& start : source.init) starts.push_back(laid_out_formula(start, 4));
  if (!starts.empty()) text += section("init", starts);
  text += section("goal", {laid_out_formula(source.goal, 4)});
  std::vector<std::string> phrasings;
  for (const auto& phrasing : source.instructions) phrasings.push_back(quoted_string(phrasing));
  return text + section("instruction", phrasings) + ")\n";
}

bool same_content(const Template& left, const Template& right) {
  const auto same_parameter = [](const Parameter& a, const Parameter& b) {
    return a.name == b.name && a.affordances == b.affordances;
  };
  const auto same_constraint = [](const DomainConstraint& a, const DomainConstraint& b) {
    return a.type == b.type && a.arguments == b.arguments;
  };
  return left.name == right.name && left.title == right.title && to_text(left.purpose) == to_text(right.purpose) &&
         left.split == right.split && left.refinement == right.refinement && left.simulators == right.simulators &&
         std::equal(left.parameters.begin(), left.parameters.end(), right.parameters.begin(), right.parameters.end(),
                    same_parameter) &&
         std::equal(left.constraints.begin(), left.constraints.end(), right.constraints.begin(),
                    right.constraints.end(), same_constraint) &&
         left.init == right.init && left.goal == right.goal && left.instructions == right.instructions;
}

}  // namespace unietp
