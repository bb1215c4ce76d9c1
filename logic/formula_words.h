#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "logic/formula.h"

namespace unietp {

/// The operator words of the text form; `number` stands only inside a `count` of two counts.
struct OperatorWord {
  Formula::Op op;
  std::string_view word;
};
inline constexpr std::array<OperatorWord, 14> kOperatorWords = {{
    {Formula::Op::Equal, "="},
    {Formula::Op::And, "and"},
    {Formula::Op::Or, "or"},
    {Formula::Op::Not, "not"},
    {Formula::Op::Imply, "imply"},
    {Formula::Op::Forall, "forall"},
    {Formula::Op::Exists, "exists"},
    {Formula::Op::Count, "count"},
    {Formula::Op::Number, "number"},
    {Formula::Op::AtEnd, "at-end"},
    {Formula::Op::Sometime, "sometime"},
    {Formula::Op::Always, "always"},
    {Formula::Op::Until, "until"},
    {Formula::Op::Before, "before"},
}};

inline constexpr std::array<Comparison, 5> kComparisons = {Comparison::Equal, Comparison::AtLeast, Comparison::AtMost,
                                                           Comparison::Greater, Comparison::Less};

}  // namespace unietp
