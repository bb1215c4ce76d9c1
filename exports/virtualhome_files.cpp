#include <memory>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "exports/express.h"
#include "exports/virtualhome_program.h"
#include "exports/virtualhome_unity.h"
#include "interchange/formats.h"

namespace unietp {
namespace {

/// For each task of VirtualHome `<task>.json`, its start as an environment graph, `<task>.txt`, the demonstration in M1
/// as a program, and `<task>.names.json`, our ids with the numbers of their nodes; and left_out.jsonl.
Result<std::string> write_virtualhome_files(const ExportRequest& request) {
  return write_expressed(request, express_virtualhome(request));
}

/// The same of the tasks whose programs Unity's table allows.
Result<std::string> write_virtualhome_unity_files(const ExportRequest& request) {
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

/// `denied`: why a program is not allowed, or "".
ExpressTask express(FormatFacts read, const ExportRequest& request,
                    std::function<std::string(const std::vector<std::string>& program)> denied) {
  const auto facts = std::make_shared<const FormatFacts>(std::move(read));
  return [facts, &request, denied = std::move(denied)](const FinishedTask& task) -> Result<ExpressedTask> {
    if (task.start.simulator != Simulator::Virtualhome) return ExpressedTask{"not a task of VirtualHome", nullptr};
    const Knowledge& knowledge = *backend_of(request.backends, task.start).knowledge;
    auto program =
        virtualhome_program(task.shown.at(Mode::M1), task.start, virtualhome_names(task.start, knowledge, *facts));
    if (!program) return ExpressedTask{program.error().message, nullptr};
    if (auto why = denied(*program); !why.empty()) return ExpressedTask{std::move(why), nullptr};
    return ExpressedTask{"", [&task, &knowledge, facts, program = std::move(*program)] {
                           return files_of(task, program, knowledge, *facts);
                         }};
  };
}

}  // namespace

Result<ExpressTask> express_virtualhome(const ExportRequest& request) {
  auto [facts, wrong] = read_format_facts(request.data / "scene_files");
  if (!wrong.empty()) return wrong.front();
  return express(std::move(facts), request, [](const auto&) { return std::string(); });
}

Result<ExpressTask> express_virtualhome_unity(const ExportRequest& request) {
  auto [facts, wrong] = read_format_facts(request.data / "scene_files");
  if (!wrong.empty()) return wrong.front();
  auto classes = read_unity_classes(request.data / "scene_files" / "virtualhome_unity.csv");
  if (!classes) return classes.error();
  return express(std::move(facts), request,
                 [classes = std::move(*classes)](const auto& program) { return denied_by_unity(program, classes); });
}

ExportFormat virtualhome_format() {
  return {
      "virtualhome",         "VirtualHome's environment graphs and programs", {}, true, write_virtualhome_files, true,
      Simulator::Virtualhome};
}

ExportFormat virtualhome_unity_format() {
  return {"virtualhome-unity",
          "the same, of the tasks that Unity's table of classes allows",
          {},
          true,
          write_virtualhome_unity_files,
          true,
          Simulator::Virtualhome};
}

}  // namespace unietp
