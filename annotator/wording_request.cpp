#include "annotator/wording_request.h"

#include <array>

#include "core/text.h"
#include "llm/one_field.h"

namespace unietp {
namespace {

constexpr const char* kField = "instruction";

constexpr const char* kRules =
    "You word tasks for a household robot, in natural English as a person at home would say them. Say every object, "
    "number, quantifier, order, state, place and description of the goal, and demand nothing else. Things that the "
    "goal "
    "speaks of without saying which may be any: 'a mug'. Never write ids such as mug_3, coordinates, names of "
    "templates, "
    "formulas or markup. Answer with JSON: {\"instruction\": \"...\"}.";

struct StyleWords {
  std::string_view style, says;
};
constexpr std::array kStyles = {
    StyleWords{"direct", "plain and direct"},
    StyleWords{"alias", "call things by their other names, never by their usual ones"},
    StyleWords{"function", "name one thing by what it is for, with the very phrase of the wordings below"},
    StyleWords{"context", "begin with a sentence that gives the occasion and demands nothing"},
    StyleWords{"background", "begin with some sentences of background that demand nothing"},
    StyleWords{"bystander", "name something that is around and ask for nothing with it ('never mind the bowl')"},
    StyleWords{"distractor", "mention what has to stay as it is the whole time"},
    StyleWords{"negation", "say a part by what must not be"},
    StyleWords{"relative-clause", "name a thing by what is done to it ('that you put a mug into')"},
    StyleWords{"inverted-order", "say what comes later first ('before you …')"},
    StyleWords{"coreference", "name a place by what is kept there ('where a plate is kept')"},
    StyleWords{"implicit-need", "say what someone wants ('someone wants a hot potato on a table')"},
    StyleWords{"vague-quantity", "say 'a couple of' for at least two, 'a few' for at least three"},
    StyleWords{"nested-syntax", "put all into one long sentence with clauses inside clauses"},
    StyleWords{"condition", "tie the task to a condition ('if …, …') that the facts below fulfil"},
};

}  // namespace

LlmRequest wording_request(const WordingTask& task, const std::vector<std::string>& samples,
                           const std::string& complaint) {
  const Specification& specification = task.specification;
  std::string_view style = specification.style;
  for (const StyleWords& known : kStyles)
    if (known.style == specification.style) style = known.says;
  std::string text = "Kind of task: " + replace_all(specification.template_name, "-", " ") +
                     "\nGoal as a formula: " + to_text(specification.goal) + "\nStyle: " + std::string(style) +
                     "\nThe home:\n" + task.facts + "\nWordings of this goal that are right:\n";
  for (const std::string& sample : samples) text += "- " + sample + "\n";
  text += "Write another one.";
  if (!complaint.empty()) text += "\nYour last answer was refused: " + complaint;
  return one_field_request(kRules, std::move(text), kField);
}

Result<std::string> worded(const LlmAnswer& answer) {
  const auto text = field_of(answer, kField);
  if (!text) return text.error();
  return std::string(trim(*text));
}

}  // namespace unietp
