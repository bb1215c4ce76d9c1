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

}  // namespace

Result<ExpressTask> express_virtualhome(const ExportRequest& request) {
  auto [facts, wrong] = read_format_facts(request.data / "scene_files");
  if (!wrong.empty()) return wrong.front();
  return ExpressTask([facts = std::move(facts), &request](const FinishedTask& task) -> Result<ExpressedTask> {
    if (task.start.simulator != Simulator::Virtualhome) return ExpressedTask{{}, "not a task of VirtualHome"};
    auto graph = write_virtualhome(task.start, *backend_of(request.backends, task.start).knowledge, facts);
    if (!graph) return graph.error();
    const auto program = virtualhome_program(task.shown.at(Mode::M1), task.start, graph->names);
    if (!program) return ExpressedTask{{}, program.error().message};
    const TaskRecord& record = task.record;
    const nlohmann::ordered_json names(graph->names);
    return ExpressedTask{{{record.id + ".json", std::move(graph->text)},
                          {record.id + ".txt",
                           record.template_name + "\n" + record.instruction + "\n\n\n" + join(*program, "\n") + "\n"},
                          {record.id + ".names.json", names.dump(1) + "\n"}},
                         ""};
  });
}

Result<ExpressTask> express_virtualhome_unity(const ExportRequest& request) {
  auto express = express_virtualhome(request);
  if (!express) return express;
  auto classes = read_unity_classes(request.data / "scene_files" / "virtualhome_unity.csv");
  if (!classes) return classes.error();
  return ExpressTask([express = std::move(*express),
                      classes = std::move(*classes)](const FinishedTask& task) -> Result<ExpressedTask> {
    auto made = express(task);
    if (!made || !made->refused.empty()) return made;
    for (const AssetFile& file : made->files) {
      if (!file.path.ends_with(".txt")) continue;
      if (auto denied = denied_by_unity(split(file.content, '\n'), classes); !denied.empty())
        return ExpressedTask{{}, std::move(denied)};
    }
    return made;
  });
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
