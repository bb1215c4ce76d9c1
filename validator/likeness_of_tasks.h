#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// The operators and atoms of a goal, each with the categories that it speaks of and the operator that it stands under,
/// whatever the variables are called and in whatever order `and` and `or` list their parts: hashes, sorted.
using GoalPrint = std::vector<std::uint64_t>;
GoalPrint print_of_goal(const Formula& goal);

/// The share of the parts of two goals that they have in common (Dice): 0 to 1, 1 for goals that differ in names only.
double likeness_of_goals(const GoalPrint& a, const GoalPrint& b);

/// The words of a text without case, punctuation and articles: hashes.
struct TextFingerprint {
  std::vector<std::uint32_t> words;   // in order
  std::vector<std::uint32_t> sorted;  // the same
};
TextFingerprint print_of_text(std::string_view text);

/// 1 - (words to insert, remove or replace to make one text of the other) / (words of the longer one): 0 to 1. Computed
/// only as far as it matters: what is not above `floor` may be told as any number that is not above it either.
double likeness_of_texts(const TextFingerprint& a, const TextFingerprint& b, double floor);

}  // namespace unietp
