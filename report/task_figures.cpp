#include "report/task_figures.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

constexpr std::array<std::string_view, 64> kFunctionWords{
    "a",     "all",   "also", "an",   "and",    "any",    "are",  "as",    "at",   "be",   "been",  "but",   "by",
    "can",   "could", "do",   "each", "for",    "from",   "has",  "have",  "i",    "if",   "in",    "into",  "is",
    "it",    "its",   "just", "let",  "like",   "make",   "me",   "must",  "my",   "need", "needs", "not",   "of",
    "on",    "one",   "onto", "or",   "please", "should", "so",   "some",  "sure", "that", "the",   "them",  "then",
    "there", "they",  "this", "to",   "want",   "was",    "with", "would", "you",  "your", "see",   "ensure"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool joins = (text[i] == '-' || text[i] == '\'') && i + 1 < text.size() && is_letter(text[i + 1]);
    if (is_letter(text[i]) || (text[i] >= '0' && text[i] <= '9') || (joins && !words.back().empty())) {
      words.back() += static_cast<char>(text[i] >= 'A' && text[i] <= 'Z' ? text[i] - 'A' + 'a' : text[i]);
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

TaskFigures::Plan plan_of(const DemonstrationRecord& shown) {
  TaskFigures::Plan plan;
  plan.steps = static_cast<int>(shown.steps.size());
  for (const StepRecord& step : shown.steps) {
    ++plan.actions[step.command.action];
    plan.failed += step.success ? 0 : 1;
  }
  return plan;
}

void add_alternatives(const Formula& part, std::vector<std::vector<std::string>>& all) {
  const Domain& domain = part.domain;
  if (part.op == Formula::Op::Exists && domain.kind == Domain::Kind::Categories && domain.members.size() > 1) {
    std::vector<std::string> names;
    for (const auto& member : domain.members) names.push_back(member.category + (member.slice ? "/slice" : ""));
    std::sort(names.begin(), names.end());
    all.push_back(std::move(names));
  }
  for (const auto& where : domain.where) add_alternatives(where, all);
  for (const auto& child : part.children) add_alternatives(child, all);
}

}  // namespace

bool is_function_word(std::string_view word) {
  return std::find(kFunctionWords.begin(), kFunctionWords.end(), word) != kFunctionWords.end();
}

TaskFigures figures_of(const FinishedTask& task) {
  const TaskRecord& record = task.record;
  TaskFigures figures{record.id,
                      record.simulator,
                      record.split,
                      record.template_name,
                      record.layout,
                      record.purpose,
                      record.style,
                      record.phenomena,
                      record.writer,
                      record.instruction,
                      words_of(record.instruction),
                      {},
                      {},
                      census_of(record.goal_tree),
                      {}};
  add_alternatives(record.goal_tree, figures.alternatives);
  for (const auto& [placeholder, category] : record.bindings) figures.categories.push_back(category);
  for (const auto& [mode, shown] : task.shown) figures.plans[mode] = plan_of(shown);
  figures.things = goal_things_of(task);
  return figures;
}

}  // namespace unietp
