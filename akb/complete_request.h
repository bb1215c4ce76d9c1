#pragma once

#include <string>
#include <vector>

#include "akb/completed.h"
#include "llm/ask.h"

namespace unietp {

/// Categories that are asked about together; all lack just these kinds of fact.
struct CompletionBatch {
  std::vector<std::string> categories;  // in the order of the tables
  std::vector<FactKind> facts;          // in the order of all_fact_kinds
};

/// Everything of `facts` that the tables lack, at most `size` (>= 1) categories a batch. Depends on the tables alone,
/// not on what was completed before, so that a run that goes on after an interruption asks the same.
std::vector<CompletionBatch> completion_batches(const Tables& tables, const std::vector<FactKind>& facts, int size);

/// What the model is asked: the rules of each kind of fact, what is known of each category, and the form of the answer:
/// `{"categories": [{"category": "Mug", "mass": 0.3, "function": ["something to drink from"]}]}`.
LlmRequest completion_request(const Tables& tables, const CompletionBatch& batch);

}  // namespace unietp
