#pragma once

#include <vector>

#include "akb/knowledge.h"
#include "annotator/parse.h"
#include "logic/trace.h"

namespace unietp {

/// The readings that can be meant in a home: what they say is so is true at its start, all that they speak of is there,
/// and nothing speaks against their goal (consistency.h). `start`: the first state of a trace; nullptr: nothing is
/// known of the home, and only the last is asked. Deterministic; order is kept.
std::vector<Reading> readings_in_home(std::vector<Reading> readings, const Knowledge& knowledge, const Trace* start);

/// Whether what a reading says is so at the start of the home. Of a home that is not known all is, but that there is
/// none of something.
bool facts_hold(const Reading& reading, const Trace* start);

}  // namespace unietp
