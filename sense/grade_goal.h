#pragma once

#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "logic/formula.h"
#include "sense/common_sense.h"
#include "sense/wants.h"
#include "sense/word_kinds.h"

namespace unietp {

/// One thing that a goal asks for with its grade.
struct PartSense {
  std::string part;  // "mug on countertop", "wash mug", "cook potato, then put it in garbage can"
  Sense sense;
};

/// How much sense a task makes: the grade of its worst part.
struct TaskSense {
  Grade grade = Grade::Tolerable;
  std::vector<PartSense> parts;  // worst first, else in the goal's order
};

/// Stage: grades a goal over a simulator's categories: each relation and state that it asks for, each two things that
/// it brings to one place, and each two changes of one thing. Of alternatives (`either`) the worst counts. Pure; equal
/// arguments give equal results. Categories that the simulator has not, and substances that `words` has not, are
/// tolerable.
TaskSense grade_goal(const Formula& goal, const Knowledge& knowledge, const CommonSense& sense, const WordKinds& words);

/// What a goal asks for, cut into pieces that are graded apart: one want, or two that go together, with what their
/// vessels carry, on which the grade of where a vessel goes depends. The worst of their grades is the goal's. Each has
/// only the things that it speaks of.
std::vector<Wants> pieces_of(const Wants& wants);
/// The grade of such a piece; nullopt when it has no part that is graded.
std::optional<Grade> grade_piece(const Wants& piece, const Knowledge& knowledge, const CommonSense& sense,
                                 const WordKinds& words);

}  // namespace unietp
