#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"
#include "logic/monitor.h"

namespace unietp {

/// What a part of a goal asks for.
enum class ScoredPartKind : std::uint8_t {
  State,       // something to reach
  Count,       // a number of things
  Order,       // one thing before another
  Constraint,  // what must stay as it is
};
std::string_view name_of(ScoredPartKind kind);  // "state"

/// A conjunct of a goal, with the quantifiers that bind its variables, so that it can be read by itself. Where two
/// parts share a variable, each may be met by another object: parts tell how far an agent came, the whole goal decides.
struct ScoredPart {
  ScoredPartKind kind = ScoredPartKind::State;
  Formula formula;
  Formula relaxed;  // of an order: both things happen; of a constraint: without what is to be reached; else the formula
};

/// Whether parts of a kind can be lost: an order or a constraint.
inline bool can_be_lost(ScoredPartKind kind) {
  return kind == ScoredPartKind::Order || kind == ScoredPartKind::Constraint;
}
/// Whether a part that is not met was lost: both things happened in the wrong order, or the constraint was broken.
/// `relaxed_met`: its relaxed formula is met.
bool is_lost(const ScoredPart& part, bool met, bool relaxed_met);

/// The parts of a goal, in order of its text. Without "is another object"; each part once. At least one.
std::vector<ScoredPart> scored_parts(const Formula& goal);

}  // namespace unietp
