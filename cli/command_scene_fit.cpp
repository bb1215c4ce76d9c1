#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/command_scene.h"
#include "grounding/layout_fit.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Fit the tables that homes are drawn from to real homes, and write them.\n"
    "\n"
    "  unietp scene fit ../shared/upstream\n"
    "      into the program's own data/layouts; `curated/` there says where furniture goes\n"
    "  unietp scene fit ../shared/upstream --out out/layouts\n"
    "\n"
    "The committed tables are what this writes, byte for byte.";

struct Options {
  std::filesystem::path upstream, out;
};

Exit fit(const Options& options, const DataFolders& folders) {
  auto reading = load_backends(folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  std::vector<Knowledge> knowledge;
  for (auto& backend : reading.backends) knowledge.push_back(std::move(backend.knowledge));
  const auto out = options.out.empty() ? folders.layouts() : options.out;
  const auto done = fit_layouts_into(out, options.upstream, folders.layouts() / "curated", knowledge);
  if (!done) return refuse(done.error());
  std::printf("wrote the tables of %zu simulators to %s\n", knowledge.size(), out.string().c_str());
  return Exit::Ok;
}

}  // namespace

void add_scene_fit_command(CommandParser& group, CommandLine& program) {
  auto* command = group.add_subcommand("fit", kHelp);
  auto options = std::make_shared<Options>();
  command->add_option("upstream", options->upstream, "folder of the simulators' own files")->required();
  command->add_option("--out", options->out, "folder to write to");
  command->callback([options, &program] { program.exit = fit(*options, program.folders); });
}

}  // namespace unietp
