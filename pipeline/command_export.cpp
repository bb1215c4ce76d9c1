#include <cstdio>
#include <memory>

#include "pipeline/command_parser.h"
#include "pipeline/commands.h"
#include "pipeline/export_pddl.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Write a data set in a format of others.\n"
    "\n"
    "  unietp export --format pddl out/first --out out/pddl    a domain per simulator, a problem and a plan per task\n"
    "\n"
    "What the format does not say is left out, with the reason, in left-out.csv.";

struct Options {
  std::filesystem::path dataset, out;
  std::string format;
};

Exit export_dataset(const Options& options, const CommandLine& program) {
  if (std::error_code code; !std::filesystem::is_directory(options.dataset, code))
    return refuse({Error::Kind::Usage, options.dataset.string(), {}, "is no folder; a finished data set is expected"});
  const auto reading = load_backends(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const auto made = export_pddl(options.dataset, reading.backends, options.out);
  if (!made) return refuse(made.error());
  std::printf("%zu problems in %s, %zu tasks left out\n", made->problems, options.out.string().c_str(), made->left_out);
  return Exit::Ok;
}

}  // namespace

void add_export_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("export", kHelp);
  command->add_option("dataset", options->dataset, "A finished data set")->required();
  command->add_option("--format", options->format, "pddl")->required()->one_of({"pddl"});
  command->add_option("--out", options->out, "A folder that does not exist yet")->required();
  command->callback([options, &program] { program.exit = export_dataset(*options, program); });
}

}  // namespace unietp
