#pragma once

#include <string>
#include <vector>

#include "record/dataset_reader.h"
#include "record/manifest_record.h"
#include "validator/proof_counts.h"
#include "validator/rest.h"
#include "validator/review_check.h"
#include "validator/task_facts.h"
#include "validator/task_reading.h"
#include "validator/validation_options.h"

namespace unietp {

/// Inputs that all proofs of a data set share. Used by several threads.
struct ProofTools {
  const DatasetReader& reader;
  const std::vector<ValidationBackend>& backends;
  const ValidationOptions& options;
  RestCheck& rest;
  const ManifestRecord* manifest = nullptr;  // null when it does not read
  const FormerTexts& former;
};

/// Result of proving one task.
struct TaskProof {
  TaskFacts facts;  // keys are "" when the scene does not read
  ProofCounts counts;
  std::vector<Problem> problems;  // of this task
  std::vector<TriedPlan> plans;   // with ValidationOptions::take_plan only
};

/// Proves one task that reads, in fresh physics, with all that belongs to it. `lines`: those that it was read from.
TaskProof prove_task(const TaskReading& task, const TaskLines& lines, const ProofTools& tools);

/// The facts of TaskProof alone, without physics.
TaskFacts read_task_facts(const TaskReading& task, const TaskLines& lines, const ProofTools& tools);

}  // namespace unietp
