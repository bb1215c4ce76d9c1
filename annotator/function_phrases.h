#pragma once

#include <optional>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "generator/specification.h"

namespace unietp {

/// In a task whose goal ranges over exactly those categories of "something to drink from" that could satisfy it, the
/// phrase means these categories. nullopt: the phrases keep their usual meaning, since style and goal have no use for
/// one.
std::optional<NounTable> narrowed_for(const Specification& specification, const Knowledge& knowledge,
                                      const NounTable& usual);

}  // namespace unietp
