#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "core/rng.h"
#include "logic/trace.h"

namespace unietp {

/// Sentences that are true in a home at its start, of things other than `own` categories that lie where the goal puts
/// something, in an order drawn by rng: "The book can stay where it is." Only of the only thing of its kind, in a place
/// that the knowledge base knows as usual for it. All can be read back (parse.h). `start`: a trace whose first state is
/// the home's. Empty when nothing can be said.
std::vector<std::string> home_sentences(const Trace& start, const Formula& goal, const std::vector<std::string>& own,
                                        const Knowledge& knowledge, const NounTable& nouns, Rng rng);

/// Whether what the speaker says of what he is up to can be so in this home: it has what the sentence names, "the
/// steak", "some eggs", "a shower", and of "all those lamps" more than one. Names that the knowledge base does not
/// have, measures ("a pot of tea"), verbs ("to watch the news") and what is still to be made ("write a letter") are not
/// looked for. True of a home that is not known.
bool can_be_said(const std::string& sentence, const Trace& start, const NounTable& nouns);

}  // namespace unietp
