#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "record/dataset_reader.h"
#include "record/manifest_record.h"
#include "record/task_record.h"
#include "record/wordings_record.h"
#include "scene/scene.h"
#include "simulation/profile.h"
#include "validator/must_fail.h"
#include "validator/problem.h"
#include "validator/stated_goal.h"

namespace unietp {

/// Facts and limits of one simulator, as physics needs them to rebuild its scenes.
struct ValidationBackend {
  const Knowledge* knowledge = nullptr;
  const Profile* profile = nullptr;
};

/// What the manifest says follows from other files, made again by the functions that wrote it. Whoever calls the
/// validator brings them.
struct DerivedFiles {
  std::string card;                     // the text of README.md
  std::vector<RecordedSource> sources;  // of the facts
  std::string benchmark;                // the frozen benchmark with the listed tasks and homes, or ""
};
using DeriveFiles = std::function<Result<DerivedFiles>(const ManifestRecord&)>;

/// Holds a task against its template: what is wrong with it, without task and place. Called by several threads at once.
using TemplateCheck =
    std::function<std::vector<Problem>(const TaskRecord&, const Formula& goal, const ManifestRecord&)>;

/// What is wrong with a home as the one in which the run fills this slot, or "". Called by one thread at a time, and
/// only where the run has hardly more slots than the data set has candidates.
using HomeInRun = std::function<std::string(int slot, const std::string& home, const ManifestRecord&)>;

/// Makes a home of a run again by its name. Errors: Usage for a name that no home of the run has. Called by several
/// threads at once.
using MakeHome = std::function<Result<Scene>(const ManifestRecord&, const std::string& name)>;

/// What the run made of a task's goal, start constraints, home and seed.
struct RemadeTask {
  Delta changes;                   // of the home, which make the start
  std::vector<std::string> edits;  // the same in words
  /// What the grammar writes with the seed of the run, or of its rewriting. One of the texts that it has in place of
  /// one that another task of the home has, where the task's is one. "": the template is not known here.
  std::string instruction;
  int phrasing = 0;  // the template's own that it is; 0: none
};
/// Makes start and instruction of a task again, from its record with goal and start constraints read, in its home.
/// Errors: why there is none. Called by several threads at once, and only for a task of which nothing else is wrong.
using RemakeTask =
    std::function<Result<RemadeTask>(const TaskRecord&, const Formula& goal, const std::vector<Formula>& constraints,
                                     const std::shared_ptr<const Scene>& home, const ManifestRecord&)>;

/// Makes a task's line of wordings.jsonl again, with what the manifest says of it; nullopt where the template, whose
/// phrasings it may have, is not known here. Errors: why there is none. Called by several threads at once, and only for
/// a task of which nothing else is wrong.
using RemakeWordings = std::function<Result<std::optional<WordingsRecord>>(
    const TaskRecord&, const Scene& start, const DemonstrationRecord& in_m1, const ManifestRecord&)>;

/// The forms of its simulator that express a task with its demonstration in M1. Called by several threads at once.
using FormsOf = std::function<std::vector<std::string>(FinishedTask)>;

/// A changed plan of a task's demonstration that was run.
struct TriedPlan {
  Mode mode = Mode::M1;
  AlteredPlan plan;
};
/// Called by one thread at a time, task by task in their order.
using TakePlan = std::function<void(const std::string& task, const TriedPlan& plan)>;

class ProofMemory;

/// What a verification reads and compares, and on how many threads.
struct ValidationOptions {
  int threads = 1;
  int part = 1, parts = 1;       // only this one of so many parts of the tasks is proven: 1 <= part <= parts
  double rest_m = 0.005;         // a body that moves farther than this when physics runs on was not at rest
  TextCheck check_text;          // none: instructions are not read
  TemplateCheck check_template;  // none: templates are not looked up
  std::map<std::string, std::string> known_homes;  // of the benchmark: the SHA-256 of their JSON, by name
  HomeInRun home_in_run;                           // none: tasks may be in any home
  MakeHome make_home;                              // none: homes are only held against physics
  RemakeTask remake_task;                          // none: starts are only held against physics
  RemakeWordings remake_wordings;                  // none: paired wordings are only read back
  FormsOf forms_of;                                // none: a task's forms are only counted
  DeriveFiles derive_files;                        // none: README.md and the sources are not compared
  std::vector<std::filesystem::path> against;      // finished data sets with which nothing may be shared
  bool accept_unchecked = false;                   // texts that failed the checks are counted, not reported
  TakePlan take_plan;                              // none: changed plans are run and forgotten
  ProofMemory* memory = nullptr;                   // proofs of an earlier call, to which those of this one are added
};

}  // namespace unietp
