#pragma once

#include <string_view>

#include "akb/knowledge.h"
#include "core/result.h"
#include "logic/formula.h"
#include "sense/word_kinds.h"

namespace unietp {

/// Reads what a person asks about as a goal: "place Mug on CounterTop", "wash Cup then put Cup in Cabinet",
/// "fill Mug with coffee", "heat Potato in Microwave", "throw away Newspaper", "bring Pillow to bedroom". Categories
/// are those of the simulator, by their names or display names, in capital or small letters. Errors: Usage; for an
/// unknown verb, category or preposition, with the nearest known one.
Result<Formula> read_question(std::string_view text, const Knowledge& knowledge);

/// The names that a goal has, which a person may have mistyped. Errors: Usage for a category that the simulator has
/// not, where no room can be meant, and for a substance that neither the knowledge base nor `words` has, with the
/// nearest known one.
Result<Done> check_names(const Formula& goal, const Knowledge& knowledge, const WordKinds& words);

}  // namespace unietp
