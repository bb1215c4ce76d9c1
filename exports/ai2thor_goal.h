#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "exports/ai2thor_plan.h"
#include "logic/trace.h"
#include "record/dataset_reader.h"

namespace unietp {

/// A goal that AI2-THOR's metadata decides.
struct ThorGoal {
  std::string formula;                            // as LTLf (ltlf_formula.h) has it
  std::string propositions;                       // JSON: `{"name", "predicate", "arguments", "test"}` for each
  std::vector<std::vector<std::string>> holding;  // for the start and each moment after it, names of those that hold
  std::set<std::string> objects;                  // ids of the objects that it names
};

/// A piece of something that AI2-THOR cuts.
struct ThorPiece {
  Node node;             // as in our scene, where it is there
  std::string objectId;  // `<whole>|BreadSliced_3`
  std::string beside;    // of one that our scene does not have: id of the whole, or of the piece that the start has
};

/// The pieces that may come in a house: as many of each whole as AI2-THOR's models have. `task` and `names` as in
/// thor_goal; `wholes`: of pieces that the start has, the objectIds of what is cut for them.
std::vector<ThorPiece> thor_pieces(const FinishedTask& task, const ThorNames& names,
                                   const std::map<std::string, std::string>& wholes, const Knowledge& knowledge);

/// The goal of a task among what is in the house alone: quantifiers range over it, and over the pieces that come.
/// `names` has every object of the house and every piece of the demonstration, and `task` none but these. Errors:
/// Unsatisfiable with the reason: what LTLf does not say, what the metadata does not tell, a goal that holds at the
/// start or not after the demonstration, seen so.
Result<ThorGoal> thor_goal(const FinishedTask& task, ThorNames names, const std::vector<ThorPiece>& pieces,
                           const Knowledge& knowledge);

}  // namespace unietp
