#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "exports/express.h"
#include "exports/own_scene.h"
#include "exports/virtualhome_program.h"
#include "exports/virtualhome_unity.h"
#include "interchange/formats.h"
#include "interchange/virtualhome_prefab.h"

namespace unietp {
namespace {

/// For each task of VirtualHome `<task>.json`, its start as an environment graph, `<task>.txt`, the demonstration in M1
/// as a program, and `<task>.names.json`, our ids with the numbers of their nodes; and left_out.jsonl.
Result<ExportSummary> write_virtualhome_files(const ExportRequest& request) {
  return write_expressed(request, express_virtualhome(request));
}

/// The same of the tasks that Unity can do.
Result<ExportSummary> write_virtualhome_unity_files(const ExportRequest& request) {
  return write_expressed(request, express_virtualhome_unity(request));
}

Result<std::vector<AssetFile>> files_of(const FinishedTask& task, const std::vector<std::string>& program,
                                        const Knowledge& knowledge, const FormatFacts& facts) {
  auto graph = write_virtualhome(task.start, knowledge, facts);
  if (!graph) return graph.error();
  const TaskRecord& record = task.record;
  const nlohmann::ordered_json names(graph->names);
  return std::vector<AssetFile>{
      {record.id + ".json", std::move(graph->text)},
      {record.id + ".txt", record.template_name + "\n" + record.instruction + "\n\n\n" + join(program, "\n") + "\n"},
      {record.id + ".names.json", names.dump(1) + "\n"}};
}

/// Why Unity cannot place an object that the demonstration names or holds; "" where it has prefabs of all.
std::string without_prefab(const FinishedTask& task, const Knowledge& knowledge, const FormatFacts& facts) {
  std::vector<std::string> named = task.start.agent.held;
  for (const StepRecord& step : task.shown.at(Mode::M1).steps) {
    for (const Argument& argument : step.command.args) named.push_back(argument.id);
  }
  for (const std::string& id : named) {
    const Node* const node = find_node(task.start, id);  // none for a room
    if (node != nullptr && virtualhome_prefab(*node, knowledge, facts).name.empty())
      return node->category + ": Unity has no prefab of it";
  }
  return "";
}

/// `unity`: what Unity's classes can do, for the tasks that it can do; nothing for all.
ExpressTask express(FormatFacts read, const ExportRequest& request, std::optional<UnityProperties> unity) {
  const auto facts = std::make_shared<const FormatFacts>(std::move(read));
  return [facts, &request, unity = std::move(unity)](const FinishedTask& task) -> Result<ExpressedTask> {
    if (task.start.simulator != Simulator::Virtualhome) return ExpressedTask{"not a task of VirtualHome", nullptr};
    if (auto why = beyond_own_simulator(task); !why.empty()) return ExpressedTask{std::move(why), nullptr};
    const Knowledge& knowledge = *backend_of(request.backends, task.start).knowledge;
    auto program =
        virtualhome_program(task.shown.at(Mode::M1), task.start, virtualhome_names(task.start, knowledge, *facts));
    if (!program) return ExpressedTask{program.error().message, nullptr};
    if (unity) {
      auto why = denied_by_unity(*program, *unity);
      if (why.empty()) why = without_prefab(task, knowledge, *facts);
      if (!why.empty()) return ExpressedTask{std::move(why), nullptr};
    }
    return ExpressedTask{"", [&task, &knowledge, facts, program = std::move(*program)] {
                           return files_of(task, program, knowledge, *facts);
                         }};
  };
}

}  // namespace

Result<ExpressTask> express_virtualhome(const ExportRequest& request) {
  auto [facts, wrong] = read_format_facts(request.data / "scene_files");
  if (!wrong.empty()) return wrong.front();
  return express(std::move(facts), request, std::nullopt);
}

Result<ExpressTask> express_virtualhome_unity(const ExportRequest& request) {
  auto [facts, wrong] = read_format_facts(request.data / "scene_files");
  if (!wrong.empty()) return wrong.front();
  auto unity = read_unity_properties(request.data / "scene_files" / "virtualhome_unity.csv");
  if (!unity) return unity.error();
  return express(std::move(facts), request, std::move(*unity));
}

ExportFormat virtualhome_format() {
  return {
      "virtualhome",         "VirtualHome's environment graphs and programs", {}, true, write_virtualhome_files, true,
      Simulator::Virtualhome};
}

ExportFormat virtualhome_unity_format() {
  return {"virtualhome-unity",
          "the same, of tasks that Unity's classes and prefabs allow",
          {},
          true,
          write_virtualhome_unity_files,
          true,
          Simulator::Virtualhome};
}

}  // namespace unietp
