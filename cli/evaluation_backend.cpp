#include "cli/evaluation_backend.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "evaluation/evaluate.h"
#include "evaluation/evaluation_manifest.h"
#include "exports/formats.h"
#include "exports/own_scene.h"
#include "record/manifest_record.h"
#include "resources/resources.h"
#include "scene/simulator.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTasks = "tasks";  // in the folder
constexpr const char* kProgram = "program";

/// A file that the form has for each task that it expresses.
fs::path file_of_task(Simulator backend, const std::string& id) {
  return backend == Simulator::Habitat ? fs::path("scenes") / (id + ".scene_instance.json") : fs::path(id + ".json");
}

Result<fs::path> scratch_folder() {
  std::error_code code;
  std::string name = (fs::temp_directory_path(code) / "unietp-backend-XXXXXX").string();
  if (code || ::mkdtemp(name.data()) == nullptr)
    return Error{Error::Kind::Io, name, {}, std::string("no folder can be made here: ") + std::strerror(errno)};
  return fs::path(name);
}

/// Writes the form below `folder`. Errors: those of the export.
Result<Done> write_form(const std::string& form, const fs::path& dataset, const fs::path& folder,
                        const CommandLine& program) {
  DataFolders folders = program.folders;
  folders.extended_library = records_extended_library(dataset);
  const auto reading = load_backends(folders);
  if (!reading.errors.empty()) return reading.errors.front();
  ExportRequest request{dataset, folder / kTasks, program.folders.root / "data", {}, 1, {}};
  for (const auto& backend : reading.backends) request.backends.push_back({&backend.knowledge, &backend.profile});
  for (const ExportFormat& format : export_formats()) {
    if (format.name != form) continue;
    const auto written = format.write(request);
    if (!written) return written.error();
  }
  return Done{};
}

}  // namespace

BackendTasks::BackendTasks(fs::path folder)
    : folder_(new fs::path(std::move(folder)), [](const fs::path* path) {
        std::error_code code;
        fs::remove_all(*path, code);
        delete path;
      }) {}

Result<Done> BackendTasks::write_program(const std::string& backend) {
  auto command = simulator_command(backend, *folder_ / kProgram);
  if (!command) return command.error();
  command_ = std::move(*command);
  return Done{};
}

SimulatorMaker BackendTasks::simulators(double reply_s, const CommandLine& program) const {
  if (!folder_) return {};
  return [command = command_, folder = folder_, reply_s, stop = program.interrupted] {
    SimulatorProgramOptions options;
    options.arguments = command;
    options.folder = *folder / kTasks;
    options.reply_s = reply_s;
    options.stop = stop;
    return simulator_program(std::move(options));
  };
}

Result<BackendTasks> backend_tasks(const std::string& backend, const fs::path& dataset, const TaskSource& tasks,
                                   EpisodeSelection& selection, const CommandLine& program) {
  if (backend == kOwnBackend) return BackendTasks();
  auto folder = scratch_folder();
  if (!folder) return folder.error();
  BackendTasks made(*folder);
  if (auto written = made.write_program(backend); !written) return written.error();
  const Simulator simulator = *simulator_named(backend);  // a backend is called as its simulator
  const std::vector<std::string> own{backend};
  if (!selection.simulators.empty() && selection.simulators != own)
    return Error{Error::Kind::Usage, "--simulators", {}, "the backend " + backend + " has only tasks of " + backend};
  selection.simulators = own;
  const auto plan = plan_episodes(tasks, selection, false);
  if (!plan) return plan.error();
  if (auto written = write_form(backend, dataset, *folder, program); !written) return written.error();
  std::vector<std::string> kept;
  int left_out = 0;
  for (const PlannedEpisode& planned : plan->episodes) {
    const std::string& id = planned.key.task;
    if (!kept.empty() && kept.back() == id) continue;
    const auto task = tasks.task(planned.position);
    if (!task) return task.error();
    const bool expressed = fs::exists(*folder / kTasks / file_of_task(simulator, id));
    if (expressed && !untold_in((*task)->simulator, (*task)->goal)) {
      kept.push_back(id);
    } else {
      ++left_out;
    }
  }
  if (left_out > 0)
    (void)std::fprintf(stderr, "left out: %d episodes of tasks that %s cannot express or tell of\n", left_out,
                       backend.c_str());
  if (kept.empty())
    return Error{Error::Kind::Usage, "--backend", {}, "no task of the data set can be acted out in " + backend};
  selection.tasks = std::move(kept);
  return made;
}

}  // namespace unietp
