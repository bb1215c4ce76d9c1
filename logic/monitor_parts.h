#pragma once

#include <vector>

#include "logic/progression.h"

namespace unietp::monitoring {

/// The goal's structure down to its outermost temporal operators, with an instance for every object that has existed so
/// far, so that parts that are already met still count. Each leaf has the residual of its temporal formula.
struct Part {
  /// The instances of one variable, or the parts of an and/or.
  struct Group {
    std::vector<Part> parts;
    std::vector<Part> waiting;  // none or one: the instance for objects that are yet to appear
    Slot slot = 0;
    bool quantified = false;
    int weight = 1;
  };
  NodeId node = 0;
  Ref origin = kFalse;        // of a leaf: its pending residual at the first position
  Ref residual = kFalse;      // of a leaf: what is asked of the states after the last one
  bool now = false;           // truth if the trace ends with the last state
  std::vector<Group> groups;  // empty: a leaf
};

/// The part of a node before the first state.
Part build_part(const Program& program, NodeId node, Residuals& residuals);
/// Takes in the last state: new objects get instances, residuals advance.
void update_part(Part& part, const Program& program, const KnownEntities& known, Residuals& residuals,
                 Progression& step);

/// Whether every continuation makes the part false (`Lost`) or true (`Won`); `Open` where that is not known.
enum class PartVerdict : std::uint8_t { Violated, Satisfied, Undecided };
/// The verdict of one part after the states so far.
PartVerdict verdict_of(const Part& part, const Program& program);

}  // namespace unietp::monitoring
