#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "annotator/instruction.h"

namespace unietp {

/// Up to `count` more texts of the grammar for the same goal in the same style, all different from each other and from
/// those in `known`; fewer where further draws bring no new ones. Deterministic in rng.
std::vector<Instruction> other_wordings(const Specification& specification, const Knowledge& knowledge,
                                        const NounTable& nouns, const WritingOptions& options,
                                        std::set<std::string> known, std::size_t count, const Rng& rng);

/// The same for texts that are requests of the given command: "Please empty both cups.", "Can you empty both cups?",
/// "If the lamp is on, please turn it off.". Of several sentences the first is asked for, or the last where the text
/// first tells something (anaphora, context). None of questions and statements.
std::vector<Instruction> requests_for(const Instruction& command, const Specification& specification,
                                      const Knowledge& knowledge, const NounTable& nouns, const Scene& home,
                                      std::set<std::string> known, std::size_t count);

}  // namespace unietp
