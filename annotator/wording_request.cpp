#include "annotator/wording_request.h"

#include <array>

#include "core/text.h"
#include "llm/one_field.h"

namespace unietp {
namespace {

constexpr const char* kField = "instruction";

/// The register of people's own words, as the grammar has it.
constexpr const char* kRules =
    "You word tasks for a household robot as people ask for things at home: short imperatives with everyday names, "
    "like "
    "the wordings that you are shown. Say 'the' for what the home has one of, and 'a' or 'one of the' where it has "
    "several and any will do; number words, not digits; 'it' or 'them' for what you have just named. Leave out all "
    "that "
    "is about the request itself ('I want you to', 'your task is', 'make sure that', 'at the end'). Do not be polite "
    "('please', 'could you', 'kindly'), unless the style asks for it. Say every object, number, quantifier, order, "
    "state, place and description of the goal, and demand nothing else. Never write ids such as mug_3, coordinates, "
    "names of templates, formulas or markup. Answer with JSON: {\"instruction\": \"...\"}.";

struct StyleWords {
  Style style;
  std::string_view says;
};
constexpr std::array kStyles = {
    StyleWords{Style::Direct, "plain and direct"},
    StyleWords{Style::Alias, "call things by their other names, never by their usual ones"},
    StyleWords{Style::Function, "name one thing by what it is for, with the very phrase of the wordings below"},
    StyleWords{Style::Hypernym, "name one thing by its kind, with the very phrase of the wordings below"},
    StyleWords{Style::Description, "describe one thing, with the very phrase of the wordings below"},
    StyleWords{Style::Context, "begin with the sentence of the wordings below, which decides what is needed"},
    StyleWords{Style::Request, "say only why something is wanted, as the wordings below do"},
    StyleWords{
        Style::Aside,
        "add a sentence about another thing in this home that does not matter ('never mind the bowl on the table')"},
    StyleWords{Style::Exception, "say that all but one are meant ('every mug but the red one')"},
    StyleWords{Style::Ellipsis, "tell the thing that is meant from another that is there ('…, not the blue one')"},
    StyleWords{Style::Anaphora, "first say where the thing is, then ask for something with 'it'"},
    StyleWords{Style::Compound, "name a thing after its room ('the kitchen cabinet')"},
    StyleWords{Style::Distractor, "mention what has to stay as it is the whole time"},
    StyleWords{Style::Negation, "say a part by what must not be"},
    StyleWords{Style::SubordinateClause,
               "say in a subordinate clause what is done first ('once you've put a mug in it, …')"},
    StyleWords{Style::InvertedOrder, "say what comes later first ('open the oven, but close the dishwasher first')"},
    StyleWords{Style::Coreference, "name a place by what is kept there ('where a plate is kept')"},
    StyleWords{Style::ImplicitNeed, "say what you would like ('I'd like a hot potato'), then where to put it"},
    StyleWords{Style::VagueQuantity, "say 'a couple of' for at least two, 'a few' for at least three"},
    StyleWords{Style::Condition, "tie the task to a condition ('if …, …') that the facts below fulfill"},
};

}  // namespace

LlmRequest wording_request(const WordingTask& task, const std::vector<std::string>& samples,
                           const std::string& complaint) {
  const Specification& specification = task.specification;
  std::string_view style = name_of(specification.style);
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
