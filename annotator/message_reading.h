#pragma once

#include <vector>

#include "annotator/clause.h"
#include "annotator/noun_table.h"
#include "annotator/word_choices.h"
#include "core/result.h"

namespace unietp {

/// One reading of a text, sentence by sentence, with the meanings that `choices` has for words of several. The error is
/// of the first word that does not fit, with its column.
Result<Message> read_message(const std::vector<Token>& tokens, const NounTable& lexicon, WordChoices& choices);

}  // namespace unietp
