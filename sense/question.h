#pragma once

#include <string_view>

#include "akb/knowledge.h"
#include "core/result.h"
#include "logic/formula.h"

namespace unietp {

/// Reads what a person asks about as a goal: "place Mug on CounterTop", "wash Cup then put Cup in Cabinet",
/// "fill Mug with coffee", "heat Potato in Microwave", "throw away Newspaper", "bring Pillow to bedroom". Categories
/// are those of the simulator, by their names or display names, in capital or small letters. Errors: Usage; for an
/// unknown verb, category or preposition, with the nearest known one.
Result<Formula> read_question(std::string_view text, const Knowledge& knowledge);

}  // namespace unietp
