#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "core/folder_lock.h"
#include "grounding/layout_fit.h"

namespace unietp {
namespace {

struct SceneFitOptions {
  std::filesystem::path upstream, out;
};

Exit fit(const SceneFitOptions& options, const DataFolders& folders) {
  auto reading = load_backends(folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  std::vector<Knowledge> knowledge;
  for (auto& backend : reading.backends) knowledge.push_back(std::move(backend.knowledge));
  const auto out = options.out.empty() ? folders.layouts() : options.out;
  const auto lock = FolderLock::take(out);
  if (!lock) return refuse(lock.error());
  const auto done = fit_layouts_into(out, options.upstream, folders.layouts() / "curated", knowledge);
  if (!done) return refuse(done.error());
  std::printf("wrote the tables of %zu simulators to %s\n", knowledge.size(), out.string().c_str());
  return Exit::Ok;
}

}  // namespace

void add_scene_fit_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<SceneFitOptions>();  // shared: the callback outlives this function
  auto* command = group.add_subcommand("fit", "Fit the tables that new homes are drawn from to real homes");
  command->explain(
      "Where furniture goes comes from data/layouts/curated/. The committed tables are what this writes, "
      "byte for byte.",
      {{"unietp scene fit metadata", "into the program's own data/layouts"},
       {"unietp scene fit metadata --out out/layouts", ""}});
  command->add_option("FOLDER", options->upstream, "Folder of the simulators' own files")->required()->folder();
  command->add_option("--out", options->out, "Folder to write to (default: data/layouts)")->folder()->output();
  command->callback([options, &program] { program.exit = fit(*options, program.folders); });
}

}  // namespace unietp
