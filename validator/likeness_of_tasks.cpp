#include "validator/likeness_of_tasks.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include "core/sort_unique.h"
#include "core/text.h"
#include "simulation/digest.h"
#include "validator/task_facts.h"

namespace unietp {
namespace {

using Op = Formula::Op;

/// Adds the parts of a formula to a print.
class GoalPrinter {
 public:
  explicit GoalPrinter(GoalPrint& print) : print_(print) {}

  /// `above`: the operator that the formula stands under, and in which place if that matters.
  void add(const Formula& formula, const std::string& above) {
    const auto outer = categories_;
    const std::string op = "op" + std::to_string(static_cast<int>(formula.op));
    std::string label = op;
    if (formula.op == Op::Atom) label += " " + std::string(info(formula.predicate).name);
    for (const Term& term : formula.terms) label += " " + name_of(term);
    if (!formula.variable.empty()) {
      const std::string domain = name_of(formula.domain);
      categories_[formula.variable] = domain;
      label += " " + domain;
      for (const Formula& where : formula.domain.where) add(where, above + " where");
    }
    if (formula.op == Op::Count) label += " " + std::to_string(formula.number);
    if (formula.op == Op::Count || formula.op == Op::CountCompare)
      label += " " + std::string(symbol_of(formula.comparison));
    print_.push_back(Digester().add(above).add(label).digest().a);
    const bool ordered = formula.op == Op::Imply || formula.op == Op::CountCompare || formula.op == Op::Until ||
                         formula.op == Op::Before;
    for (std::size_t i = 0; i < formula.children.size(); ++i)
      add(formula.children[i], ordered ? op + "." + std::to_string(i) : op);
    categories_ = outer;
  }

 private:
  std::string name_of(const Term& term) const {
    const auto bound = categories_.find(term.name);
    return term.kind == Term::Kind::Variable && bound != categories_.end() ? bound->second : term.name;
  }
  static std::string name_of(const Domain& domain) {
    std::vector<std::string> members{"kind" + std::to_string(static_cast<int>(domain.kind))};
    for (const auto& member : domain.members) members.push_back(member.category + (member.slice ? "/slice" : ""));
    sort_unique(members);
    return join(members, "|");
  }

  GoalPrint& print_;
  std::map<std::string, std::string> categories_;  // of the variables in scope
};

/// How many of two sorted lists they have in common, repeats counted.
template <class T>
std::size_t count_common(const std::vector<T>& a, const std::vector<T>& b) {
  std::size_t i = 0, j = 0, common = 0;
  while (i < a.size() && j < b.size()) {
    if (a[i] == b[j]) {
      ++common, ++i, ++j;
    } else if (a[i] < b[j]) {
      ++i;
    } else {
      ++j;
    }
  }
  return common;
}

std::size_t edit_distance(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

GoalPrint print_of_goal(const Formula& goal) {
  GoalPrint print;
  GoalPrinter(print).add(normal_form(goal), "");
  std::sort(print.begin(), print.end());
  return print;
}

double likeness_of_goals(const GoalPrint& a, const GoalPrint& b) {
  return 2.0 * static_cast<double>(count_common(a, b)) / static_cast<double>(a.size() + b.size());
}

TextFingerprint print_of_text(std::string_view text) {
  TextFingerprint print;
  for (const auto& word : split(plain_words(text), ' ')) {
    if (word.empty() || word == "a" || word == "an" || word == "the") continue;
    print.words.push_back(static_cast<std::uint32_t>(Digester().add(word).digest().a));
  }
  print.sorted = print.words;
  std::sort(print.sorted.begin(), print.sorted.end());
  return print;
}

double likeness_of_texts(const TextFingerprint& a, const TextFingerprint& b, double floor) {
  const auto longer = static_cast<double>(std::max(a.words.size(), b.words.size()));
  if (longer == 0) return 1;
  const double at_most = static_cast<double>(count_common(a.sorted, b.sorted)) / longer;
  if (at_most <= floor) return at_most;
  return 1 - static_cast<double>(edit_distance(a.words, b.words)) / longer;
}

}  // namespace unietp
