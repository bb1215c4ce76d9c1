#include "simulation/feedback.h"

#include <cctype>
#include <string_view>

namespace unietp {
namespace {

/// The sentence of a cause with names in place of {object} and {other}.
std::string filled_in(FailureCause cause, const std::string& object, const std::string& other) {
  constexpr std::string_view kObject = "{object}", kOther = "{other}";
  std::string text;
  std::string_view rest = info(cause).sentence;
  while (!rest.empty()) {
    const std::size_t brace = std::min(rest.find('{'), rest.size());
    text += rest.substr(0, brace);
    rest.remove_prefix(brace);
    if (rest.starts_with(kObject)) {
      text += object;
      rest.remove_prefix(kObject.size());
    } else if (rest.starts_with(kOther)) {
      text += other;
      rest.remove_prefix(kOther.size());
    }
  }
  return text;
}

std::string with_tool(const std::string& tool, const std::string& sentence) {
  return tool.empty() ? sentence : "Could not use " + tool + ": " + sentence;
}

const std::string& id_of(const FailureReference& reference) {
  return reference.id.empty() ? reference.phrase : reference.id;
}

}  // namespace

FailureWithoutIds without_ids(const FailureDetail& failure) {
  return {failure.cause, failure.object.phrase, failure.other.phrase, failure.tool.phrase};
}

std::string feedback_with_ids(const FailureDetail& failure) {
  return with_tool(id_of(failure.tool), filled_in(failure.cause, id_of(failure.object), id_of(failure.other)));
}

std::string feedback_in_words(const FailureWithoutIds& failure) {
  std::string text = with_tool(failure.tool, filled_in(failure.cause, failure.object, failure.other));
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

Outcome outcome_of(const ActionResult& result, bool with_ids) {
  if (result.success) return {true, Failure::None, ""};
  return {false, result.failure,
          with_ids ? feedback_with_ids(result.detail) : feedback_in_words(without_ids(result.detail))};
}

Outcome outcome_in(Mode mode, const ActionResult& result) { return outcome_of(result, mode == Mode::M1); }

}  // namespace unietp
