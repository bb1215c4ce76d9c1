#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "record/task_record.h"
#include "scene/scene.h"

namespace unietp {

/// A demonstration in M1 as a program of VirtualHome, a line for each step: "[PutBack] <mug> (12) <table> (40)".
/// `names`: of our objects and rooms in the graph, "mug_12" by our id (write_virtualhome). What is switched on while
/// its plug is out is plugged in first, because VirtualHome switches nothing else on. What was on or in a thing that is
/// grabbed is put there again with the other hand, because VirtualHome forgets it. Steps that failed and `stop` are
/// left out. Errors: Unsatisfiable for an action that VirtualHome does not have, and for an object that is not in the
/// graph.
Result<std::vector<std::string>> virtualhome_program(const DemonstrationRecord& demonstration, const Scene& start,
                                                     const std::map<std::string, std::string>& names);

}  // namespace unietp
