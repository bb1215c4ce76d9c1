#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "akb/knowledge.h"

namespace unietp {

/// `metadata`, `derived`, `curated`, `override` or `llm`: what stands before the colon of a source.
std::string kind_of(const Source& source);

/// How many facts there are, from where, and how sure they are.
struct FactCounts {
  std::size_t facts = 0;
  double confidence_sum = 0;
  std::map<std::string, std::size_t> by_kind, by_source;  // facts by kind_of and by whole source
  /// 0 when there are no facts.
  double mean_confidence() const { return facts == 0 ? 0 : confidence_sum / static_cast<double>(facts); }
  /// Counts one more fact.
  void add(const Source& source);
};

/// How much one knowledge base says, and where it says nothing.
struct Coverage {
  std::size_t categories = 0;
  /// The table names, and `size` and `mass`, which have sources of their own.
  std::vector<std::pair<std::string, FactCounts>> tables;
  std::vector<std::pair<std::string, FactCounts>> affordances;  // every affordance, in the order of affordance_names
  /// `synset`, `rooms`, `placements`, `aliases`, and the names of the categories without any.
  std::vector<std::pair<std::string, std::vector<std::string>>> missing;
};

/// Counts all tables of one knowledge base.
Coverage coverage_of(const Knowledge& knowledge);

}  // namespace unietp
