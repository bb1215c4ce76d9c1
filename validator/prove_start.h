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

/// What is wrong with a start scene by physics alone: relations that are recorded but not there or there but not
/// recorded, and bodies that move when physics runs on. `physics` is that of the scene, `links` what it
/// shows of each node.
std::vector<Problem> prove_start(const Scene& start, const PhysicsWorld& physics, const LinkTable& links,
                                 RestCheck& rest, const std::string& file);

/// What is wrong with a goal in the start, of which `at_start` is the trace: it or one of its conjuncts holds already,
/// a category is unknown, a start constraint does not hold, a referring phrase means nothing or everything.
std::vector<Problem> prove_goal_at_start(const TaskRecord& task, const Formula& goal,
                                         const std::vector<Formula>& constraints, const Scene& start,
                                         const Trace& at_start, const Knowledge& knowledge, const std::string& where);

}  // namespace unietp
