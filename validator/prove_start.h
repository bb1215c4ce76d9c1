#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "record/task_record.h"
#include "simulation/link_table.h"
#include "simulation/physics.h"
#include "simulation/relations.h"
#include "validator/problem.h"
#include "validator/rest.h"

namespace unietp {

/// Problems of a start scene in physics: relations that are recorded but do not hold or hold but are not recorded, and
/// objects that move when the simulation continues. `physics` is that of the scene, `links` the contacts of its nodes.
std::vector<Problem> prove_start(const Scene& start, const PhysicsWorld& physics, const LinkTable& links,
                                 RestCheck& rest, const std::string& file);

/// Problems of a goal at the start, of which `at_start` is the trace: it or one of its parts already holds, a category
/// is unknown, a start constraint does not hold, a referring phrase selects no object or excludes none.
std::vector<Problem> prove_goal_at_start(const TaskRecord& task, const Formula& goal,
                                         const std::vector<Formula>& constraints, const Scene& start,
                                         const Trace& at_start, const Knowledge& knowledge, const std::string& where);

}  // namespace unietp
