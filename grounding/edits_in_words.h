#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "grounding/home.h"
#include "scene/trace.h"

namespace unietp {

/// How a start differs from its home, for people: the net effect only, whatever was tried on the way. In this order:
///
///   removed mug_2
///   added Mug mug_4 inside sink_1, dirty    (the states that such a thing does not have by default)
///   moved mug_1 on desk_1 | moved mug_1 on the floor of kitchen_1
///   made mug_1 dirty | made mug_1 not covered | made mug_1 blue | made mug_1 larger
///   the agent starts in kitchen_1
///
/// Each object in order of its id. What rides along in an opened drawer is not said. `changes` lead from the home to
/// the start, which has its relations.
std::vector<std::string> edits_in_words(const Home& home, const Scene& start, const Delta& changes,
                                        const Knowledge& knowledge);

}  // namespace unietp
