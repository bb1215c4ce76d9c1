#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/file_writer.h"
#include "exports/formats.h"
#include "exports/ltlf_formula.h"
#include "exports/task_folder.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Whether cutting something in the scene gives objects of this category, which are then not in the start.
bool made_by_cutting(const std::string& category, const Scene& start, const Knowledge& knowledge) {
  return std::any_of(start.nodes.begin(), start.nodes.end(), [&](const Node& node) {
    const auto cuts = knowledge.effects_on(node.category, Treatment::Slices);
    return std::any_of(cuts.begin(), cuts.end(), [&](const Effect* cut) { return cut->gives == category; });
  });
}

/// Names of the propositions that hold at each moment of a demonstration, the start first.
Json trace_of(const FinishedTask& task, const DemonstrationRecord& demonstration, const LtlfGoal& goal,
              bool with_comparisons) {
  auto states = Json::array();
  for (const Facts& facts : to_logic(task.start, changes_by_moment(demonstration), with_comparisons).states) {
    auto holding = Json::array();
    for (const auto& proposition : goal.propositions) {
      if (proposition.holds_in(facts)) holding.push_back(proposition.name);
    }
    states.push_back(std::move(holding));
  }
  return states;
}

/// A line of goals.jsonl, or why LTLf cannot express the task.
Result<std::string> goal_line(const FinishedTask& task, const std::vector<Mode>& modes, const Knowledge& knowledge) {
  for (const auto& category : categories_of(task.record.goal_tree)) {
    if (made_by_cutting(category, task.start, knowledge))
      return Error{Error::Kind::Unsatisfiable, "", {}, "it ranges over pieces that do not exist at the start"};
  }
  const bool with_comparisons = reads_comparisons(task.record.goal_tree);
  const auto goal = ltlf_goal(task.record.goal_tree, to_logic(task.start, {}, with_comparisons));
  if (!goal) return goal.error();
  auto propositions = Json::array();
  for (const auto& one : goal->propositions)
    propositions.push_back({{"name", one.name}, {"predicate", one.predicate}, {"arguments", one.arguments}});
  auto traces = Json::object();
  for (const Mode mode : modes)
    traces[std::string(name_of(mode))] = trace_of(task, task.shown.at(mode), *goal, with_comparisons);
  const Json json{{"task", task.record.id},
                  {"simulator", task.record.simulator},
                  {"template", task.record.template_name},
                  {"instruction", task.record.instruction},
                  {"goal", task.record.goal_text},
                  {"formula", goal->formula},
                  {"propositions", std::move(propositions)},
                  {"traces", std::move(traces)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// goals.jsonl and left_out.jsonl.
Result<ExportSummary> write_ltlf(const ExportRequest& request) {
  const auto modes = shown_modes(request.dataset);
  std::optional<FileWriter> file;
  const auto write = [&](const fs::path& folder, const std::string& line) -> Result<Done> {
    if (!file) {
      auto begun = FileWriter::begin(folder / "goals.jsonl");
      if (!begun) return begun.error();
      file.emplace(std::move(*begun));
    }
    return file->add(line);
  };
  const auto made = write_task_folder(
      request.dataset, modes, request.out,
      [&](const FinishedTask& task, const fs::path& folder) -> Result<std::optional<std::string>> {
        const auto line = goal_line(task, modes, *backend_of(request.backends, task.start).knowledge);
        if (!line) return std::optional(line.error().message);
        if (auto written = write(folder, *line); !written) return written.error();
        return std::optional<std::string>();
      },
      [&](const fs::path& folder) {
        auto written = write(folder, "");
        return written ? file->finish() : written;
      });
  if (!made) return made.error();
  return summary_of(*made, request.out);
}

}  // namespace

ExportFormat ltlf_format() {
  return {"ltlf", "goals as LTLf formulas with traces, for planners and rewards", {}, true, write_ltlf, true};
}

}  // namespace unietp
