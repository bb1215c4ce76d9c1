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
  record.bindings = {{"A", "Fridge"}};
  record.expert = {{Mode::M1, 2, 0}};
  task.record = record;
  DatabaseCheck check(folder.path());
  check.add(task, {"start", "text", "home", {"ai2thor/kitchen"}});
  const std::vector<Problem> problems = check.finish(1);
  for (const Problem& problem : problems) check_error(problem.error);

  return problems.empty();
}

}  // namespace unietp::fuzz
