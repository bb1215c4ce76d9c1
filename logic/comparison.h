#pragma once

#include "logic/formula.h"

namespace unietp {

/// Whether `left comparison right` holds. The monitor has a function of its own for this, so that it shares no code
/// with the direct evaluator.
inline bool compares(int left, Comparison comparison, int right) {
  switch (comparison) {
    case Comparison::Equal:
      return left == right;
    case Comparison::AtLeast:
      return left >= right;
    case Comparison::AtMost:
      return left <= right;
    case Comparison::Greater:
      return left > right;
    case Comparison::Less:
      return left < right;
  }
  return false;
}

}  // namespace unietp
