#pragma once

#include "logic/formula.h"

namespace unietp {

/// Whether `left ⋈ right`. Shared by what makes and reads goals; the monitor has its own, so that it and the direct
/// evaluator stay apart.
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
