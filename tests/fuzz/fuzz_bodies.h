#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/sexpr.h"

namespace unietp::fuzz {

/// What must hold for every input; aborts, so that the fuzzer keeps the input.
inline void require(bool truth, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (truth) return;
  std::fprintf(stderr, "%s:%d: this does not hold\n", file, line);
  std::abort();
}

inline void check_positions(const Sexpr& expression) {
  require(expression.pos.line >= 1 && expression.pos.column >= 1);
  require(expression.end.line > expression.pos.line ||
          (expression.end.line == expression.pos.line && expression.end.column >= expression.pos.column));
  for (const auto& child : expression.children) check_positions(child);
}

/// Any bytes give expressions with positions or an error with one. True when they are expressions.
inline bool read_sexprs_body(std::string_view text) {
  const auto all = read_sexprs("fuzz", text);
  if (!all) {
    require(all.error().pos.line >= 1 && !all.error().message.empty());
    return false;
  }
  for (const auto& expression : *all) check_positions(expression);
  return true;
}

}  // namespace unietp::fuzz
