#pragma once

#include <optional>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "generator/specification.h"

namespace unietp {

/// "something to drink from" means, in this task, the categories that could ever satisfy the goal: when the goal ranges
/// over these alone, that is what the phrase says. nullopt: the phrases mean what they always do (every other style).
std::optional<NounTable> narrowed_for(const Specification& specification, const Knowledge& knowledge,
                                      const NounTable& usual);

}  // namespace unietp
