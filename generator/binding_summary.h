#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "generator/specification.h"
#include "templates/template.h"

namespace unietp {

/// What may fill a template over a knowledge base.
struct BindingSummary {
  std::size_t count = 0;  // of bindings
  bool more = false;      // there are more than `count`, which is the limit
  /// For each placeholder, in order of parameters, every category that some binding gives it, sorted.
  std::vector<std::pair<std::string, std::vector<std::string>>> fills;
  std::vector<Binding> examples;  // the first ones, at most three
};

/// Counts bindings up to `limit`; `fills` is complete all the same. Nothing for a simulator that is not claimed.
BindingSummary summarize_bindings(const Template& source, const Knowledge& knowledge, std::size_t limit);

}  // namespace unietp
