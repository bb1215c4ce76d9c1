#include "annotator/parse.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "annotator/compose.h"
#include "annotator/meaning.h"
#include "annotator/message_reading.h"
#include "annotator/word_choices.h"
#include "core/text.h"

namespace unietp {
namespace {

Result<Reading> one_reading(const std::vector<Token>& tokens, const NounTable& lexicon, WordChoices& choices) {
  const auto message = read_message(tokens, lexicon, choices);
  if (!message) return message.error();
  return compose(*message, choices);
}

bool same_reading(const Reading& a, const Reading& b) { return a.facts == b.facts && same_meaning(a.goal, b.goal); }

}  // namespace

Result<std::vector<Reading>> readings_of(std::string_view text, const NounTable& lexicon) {
  const std::vector<Token> tokens = tokens_of(text);
  std::vector<Reading> found;
  std::optional<Error> first;
  WordChoices choices;
  for (int combinations = 1; combinations == 1 || choices.next(); ++combinations) {
    if (combinations > kMostReadings)
      return Error{Error::Kind::Parse, "instruction", {1, 1}, "the text can be read in too many ways"};
    auto reading = one_reading(tokens, lexicon, choices);
    if (!reading) {
      if (!first) first = reading.error();
      continue;
    }
    const auto known =
        std::find_if(found.begin(), found.end(), [&](const Reading& other) { return same_reading(*reading, other); });
    if (known != found.end()) {
      known->strained = known->strained && reading->strained;
    } else {
      found.push_back(std::move(*reading));
    }
  }
  if (found.empty()) return *first;
  return found;
}

Result<Formula> parse_with(std::string_view text, const NounTable& lexicon) {
  auto readings = readings_of(text, lexicon);
  if (!readings) return readings.error();
  if (readings->size() == 1 && readings->front().strained)
    return Error{Error::Kind::Parse, "instruction", {1, 1}, kStrainedPronoun};
  if (readings->size() == 1) return std::move(readings->front().goal);
  return Error{Error::Kind::Parse,
               "instruction",
               {1, 1},
               "the text can be read in " + std::to_string(readings->size()) + " ways, such as " +
                   to_text((*readings)[0].goal) + " and " + to_text((*readings)[1].goal)};
}

}  // namespace unietp
