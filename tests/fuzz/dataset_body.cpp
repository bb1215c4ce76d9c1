#include "bodies.h"
#include "fuzz_bodies.h"
#include "record/trait_table.h"
#include "support.h"
#include "validator/database_check.h"

namespace unietp::fuzz {

bool database_body(std::string_view bytes) {
  static const Folder folder("database");
  folder.write("dataset.sqlite", bytes);
  const auto file = folder.path() / "dataset.sqlite";
  const auto counts = trait_counts(file);
  if (!check_result(counts)) return false;

  TaskReading task;  // what the seeds hold
  task.name = "ai2thor-00001";
  TaskRecord record;
  record.id = task.name;
  record.template_name = "open-one";
  record.split = "atomic";
  record.simulator = "ai2thor";
  record.scene = record.layout = "ai2thor-home-1";
  record.goal_text = "(at-end (exists (?a - Fridge) (open ?a)))";
  record.instruction = "Open a fridge.";
  record.style = "direct";
  record.writer = "grammar";
  record.grade = "usual";
  record.bindings = {{"A", "Fridge"}};
  record.expert = {{Mode::M1, 2, 0}};
  task.record = record;
  DatabaseCheck check(folder.path());
  TaskFacts facts;
  facts.start_key = "start";
  facts.rooms = {"ai2thor/kitchen"};
  facts.bound_categories = {"ai2thor/Fridge"};
  facts.steps = {{"M1", "1", "open", "fridge_1", "1", "none"}, {"M1", "2", "stop", "", "1", "none"}};
  check.add(task, facts);
  RejectionRecord rejection;
  rejection.slot = 1;
  rejection.template_name = "open-one";
  rejection.simulator = "ai2thor";
  rejection.split = "atomic";
  rejection.stage = "physics";
  rejection.reason = "unrest";
  check.add(rejection);
  const std::vector<Problem> problems = check.finish().take();
  for (const Problem& problem : problems) check_error(problem.error);
  return problems.empty();
}

}  // namespace unietp::fuzz
