#pragma once

#include <span>
#include <string_view>

#include "templates/template.h"

namespace unietp {

/// A word of the language with what it means, in one line for people.
struct WordMeaning {
  std::string_view word, says;
};
/// Those of pseudo_affordances(), in its order.
std::span<const WordMeaning> pseudo_affordance_meanings();
/// Those of the splits, in the order of the enum.
std::span<const WordMeaning> split_meanings();

}  // namespace unietp
