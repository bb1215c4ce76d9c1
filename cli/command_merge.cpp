#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "run/merge.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Put the shards of a run together to the data set that one process would have made, to the byte.\n"
    "\n"
    "  unietp training --shard 1/2 --out out/part-1      on one machine\n"
    "  unietp training --shard 2/2 --out out/part-2      on another\n"
    "  unietp merge out/part-1 out/part-2 --out out/training";

struct Options {
  std::vector<std::filesystem::path> shards;
  std::filesystem::path out;
};

Exit merge(const Options& options, CommandLine& program) {
  const auto shards = read_shards(options.shards);
  if (!shards) return refuse(shards.error());
  program.folders.extended_library = shards->configuration.extended;
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const auto merged = merge_shards(*shards, reading.resources, program.folders.licences(), options.out);
  if (!merged) return refuse(merged.error());
  std::printf("%zu shards of %d tasks put together in %s\n", options.shards.size(), shards->configuration.count,
              options.out.string().c_str());
  return Exit::Ok;
}

}  // namespace

void add_merge_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("merge", kHelp);
  command->add_option("SHARDS", options->shards, "Folders that runs with --shard have made, all of them")
      ->required()
      ->existing_folder();
  command->add_option("--out", options->out, "Folder to make")->required();
  command->callback([options, &program] { program.exit = merge(*options, program); });
}

}  // namespace unietp
