#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/home_shelf.h"
#include "record/wordings_record.h"
#include "validator/folder_reading.h"
#include "validator/proof_counts.h"
#include "validator/rest.h"
#include "validator/task_facts.h"
#include "validator/validation_options.h"

namespace unietp {

/// What all proofs of a data set share. Read by several threads.
struct ProofTools {
  const FolderReading& folder;
  const std::vector<ValidationBackend>& backends;
  const ValidationOptions& options;
  RestCheck& rest;
  HomeShelf& homes;
  std::string phrasings = "all";                   // of the instructions
  std::map<std::string, WordingsRecord> wordings;  // by task
};

struct TaskProof {
  TaskFacts facts;  // keys are "" when the scene does not read
  ProofCounts counts;
  std::vector<Problem> problems;  // of this task
};

/// Proves one task that reads, in fresh physics, with all that belongs to it.
TaskProof prove_task(const TaskReading& task, const ProofTools& tools);

}  // namespace unietp
