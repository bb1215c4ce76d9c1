#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "core/rng.h"
#include "logic/trace.h"

namespace unietp {

/// Sentences that are true in a home at its start, of things other than `own` categories that lie where the goal puts
/// something, in an order drawn by rng: "There's already a book on the desk." Only of places that the knowledge base
/// knows as usual for them, by the names that `text` has for them. All can be read back (parse.h). `start`: a trace
/// whose first state is the home's. Empty when nothing can be said.
std::vector<std::string> home_sentences(const Trace& start, const Formula& goal, const std::vector<std::string>& own,
                                        const std::string& text, const Knowledge& knowledge, const NounTable& nouns,
                                        Rng rng);

}  // namespace unietp
