#pragma once

#include <vector>

#include "logic/formula.h"

namespace unietp {

/// One way to understand a text: what it asks for, and what it says is so at the start.
struct Reading {
  Formula goal;
  std::vector<Formula> facts;  // state formulas, with `:where`
  bool strained = false;       // takes "it" for something else than what was named last
};

}  // namespace unietp
