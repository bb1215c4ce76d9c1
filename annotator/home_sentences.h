#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "core/rng.h"
#include "logic/trace.h"

namespace unietp {

/// Sentences that are true in a home at its start, of things other than `own` categories, in an order drawn by rng:
/// "Never mind the pillow on the sofa.", "The TV is on, but never mind that." Of where things are, only what the
/// knowledge base knows as a place for them; of states, only those that people notice, of things of which the home has
/// one. All can be read back (parse.h). `start`: a trace whose first state is the home's. Empty when nothing can be
/// said.
std::vector<std::string> home_sentences(const Trace& start, const std::vector<std::string>& own,
                                        const Knowledge& knowledge, const NounTable& nouns, Rng rng);

}  // namespace unietp
