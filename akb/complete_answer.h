#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "akb/complete_request.h"
#include "akb/wordnet.h"

namespace unietp {

/// One thing that a model said and that is not used.
struct RejectedFact {
  std::string category;
  std::string fact;    // a kind of fact, or "" when the whole entry is meant
  std::string value;   // as one short plain line
  std::string reason;  // from a closed list
  bool operator==(const RejectedFact&) const = default;
};

/// The parts of an answer that are used and those that are not.
struct CheckedAnswer {
  CompletedFacts accepted;
  std::vector<RejectedFact> rejected;
};

/// Takes from an answer what was asked and is within bounds, each with `source`. Strict: known names only, finite
/// numbers within the tables' bounds and of a possible density, plain English phrases of bounded length that name no
/// other thing, places that fit, affordances that the body allows, synsets that WordNet has (when it is here), nothing
/// twice. An empty list or synset is neither taken nor rejected. Depends on its arguments alone, so answers may come in
/// any order.
CheckedAnswer check_completion(std::string_view answer, const Tables& tables, const CompletionBatch& batch,
                               const Source& source, const WordNet* wordnet);

}  // namespace unietp
