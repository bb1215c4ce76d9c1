#include "annotator/judge.h"

#include <algorithm>

#include "llm/one_field.h"
#include "logic/formula_words.h"

namespace unietp {
namespace {

constexpr const char* kField = "formula";

std::string rules() {
  std::string text =
      "You read an instruction to a household robot and write down what it demands, all of it and nothing else, as one "
      "formula. The formula is read on the sequence of states from the start to the end of the robot's "
      "work.\n\nForms:\n";
  for (const OperatorWord& word : kOperatorWords)
    text += std::string(word.usage) + ": " + std::string(word.says) + "\n";
  text += "\nDomains, behind the dash:\n";
  for (const DomainForm& form : kDomainForms) text += std::string(form.usage) + ": " + std::string(form.says) + "\n";
  text += "\nPredicates:\n";
  for (const PredicateInfo& predicate : all_predicates()) {
    text += "(" + std::string(predicate.name);
    for (std::size_t i = 0; i < predicate.arguments.size(); ++i)
      text += predicate.arguments[i] == ArgumentKind::Symbol ? " word" : (i == 0 ? " ?x" : " ?y");
    text += "): " + std::string(predicate.meaning) + "\n";
  }
  return text +
         "\nEvery predicate stands under at-end, sometime, always, until or before, or inside a :where. What the text "
         "wants done has to hold at the end. A thing that is described as it is now (\"the dirty mug\") has a :where. "
         "\"a mug\" and \"the mug\" are an exists; a thing that is named again is the same variable. \"First A, then "
         "B\" is (and (before A B) (at-end B)). Example: \"Put a mug that is dirty on every table.\" is (forall (?t - "
         "Table) (exists (?m - (Mug :where (dirty ?m))) (at-end (on ?m ?t)))). Answer with JSON: {\"formula\": "
         "\"...\"}.";
}

/// "Mug (mug, beaker)", and phrases that name things by what they are for.
std::string vocabulary(const WordingTask& task) {
  std::string text;
  for (const std::string& category : task.categories) {
    const auto* name = task.nouns->display(category);
    if (name == nullptr) continue;
    text += "- " + category + ": " + name->singular;
    for (const auto& other : task.nouns->synonyms(category)) text += ", " + other.singular;
    text += "\n";
  }
  for (const auto& [key, phrase] : task.nouns->phrases()) {
    Domain here;
    for (const Domain::Member& member : phrase.noun.members)
      if (std::find(task.categories.begin(), task.categories.end(), member.category) != task.categories.end())
        here.members.push_back(member);
    if (!here.members.empty()) text += "- " + to_text(here) + ": " + phrase.text + "\n";
  }
  return text;
}

}  // namespace

LlmRequest judging_request(const std::string& text, const WordingTask& task, const std::string& complaint) {
  std::string asked = "Categories in this home, with what they are called:\n" + vocabulary(task) +
                      "\nThe instruction:\n" + text + "\n\nThe formula of all that it demands?";
  if (!complaint.empty()) asked += "\nYour last answer could not be read: " + complaint;
  return one_field_request(rules(), std::move(asked), kField);
}

Result<Formula> judged(const LlmAnswer& answer) {
  const auto text = field_of(answer, kField);
  if (!text) return text.error();
  return parse_formula("formula", *text, FormulaUse::Goal);
}

}  // namespace unietp
