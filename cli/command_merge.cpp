#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "run/merge.h"

namespace unietp {
namespace {

struct MergeOptions {
  std::vector<std::filesystem::path> shards;
  std::filesystem::path out;
};

Exit merge(const MergeOptions& options, CommandLine& program) {
  const auto shards = read_shards(options.shards);
  if (!shards) return refuse(shards.error());
  program.folders.extended_library = shards->configuration.extended;
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const auto merged = merge_shards(*shards, reading.resources, program.folders.licenses(), options.out);
  if (!merged) return refuse(merged.error());
  std::printf("joined %zu shards with %d tasks in %s\n", options.shards.size(), shards->configuration.count,
              options.out.string().c_str());
  return Exit::Ok;
}

}  // namespace

void add_merge_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<MergeOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("merge", "Join the shards of a run into one data set");
  command->explain("The result is byte for byte what a single process would have made.",
                   {{"unietp training --shard 1/2 --out out/part-1", "on one machine"},
                    {"unietp training --shard 2/2 --out out/part-2", "on another"},
                    {"unietp merge out/part-1 out/part-2 --out out/training", ""}});
  command->add_option("SHARD", options->shards, "The folders that runs with --shard made, all of them")
      ->required()
      ->existing_folder();
  command->add_option("--out", options->out, "Folder to make")->required()->folder()->output();
  command->callback([options, &program] { program.exit = merge(*options, program); });
}

}  // namespace unietp
