#include "annotator/equivalence.h"

#include "annotator/meaning.h"
#include "annotator/trace_draft.h"
#include "logic/evaluate.h"

namespace unietp {

std::optional<Trace> distinguishing_trace(const Formula& left, const Formula& right, int traces, Rng rng) {
  for (int i = 0; i < traces; ++i) {
    Rng own = rng.fork("trace", static_cast<std::uint64_t>(i));
    TraceDraft draft({&left, &right}, own.fork("draft", 0));
    const Formula& first = i % 2 == 0 ? left : right;
    const Formula& second = i % 2 == 0 ? right : left;
    switch (i / 2 % 5) {
      case 0:
        break;
      case 1:
        draft.enforce(first, true);
        break;
      case 2:
        draft.enforce(second, false);
        draft.enforce(first, true);
        break;
      case 3:
        draft.enforce(first, true);
        draft.enforce(second, false);
        break;
      default:
        draft.enforce(first, true);
        for (std::uint64_t k = 1 + own.below(3); k > 0; --k) draft.nudge();
    }
    auto trace = draft.trace();
    if (holds(left, trace) != holds(right, trace) && empty_domains(left, trace).empty() &&
        empty_domains(right, trace).empty())
      return trace;
  }
  return std::nullopt;
}

bool equivalent(const Formula& left, const Formula& right) {
  constexpr std::uint64_t kSeed = 6;
  return same_meaning(left, right) || !distinguishing_trace(left, right, kTracesCompared, Rng(kSeed));
}

}  // namespace unietp
