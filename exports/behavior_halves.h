#pragma once

#include <map>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "logic/formula.h"
#include "logic/trace.h"
#include "record/dataset_reader.h"

namespace unietp {

/// What OmniGibson puts in the place of a thing that is cut.
struct Halves {
  std::string category;       // of both: "half_apple"
  std::string first, second;  // entities: what remains of the whole, which here keeps its id, and the piece that comes
};

/// A demonstration as states in which each thing that can be cut has both its halves. Here a thing that is cut stays,
/// as what remains of it, beside one new piece; in OmniGibson it is gone, and there are two halves.
struct HalvedTrace {
  Trace trace;                           // the start, and each moment since
  std::map<std::string, Halves> halves;  // by the whole's id
};

/// `task` has a demonstration in M1. Halves are there only where the goal speaks of cutting or of pieces, and exist
/// from the step on that cuts; those of what is not cut never do. Pure.
HalvedTrace halved_trace(const FinishedTask& task, const Knowledge& knowledge);

}  // namespace unietp
