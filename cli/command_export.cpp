#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "core/text.h"
#include "exports/bddl_files.h"
#include "exports/finished_tasks.h"
#include "exports/pddl_files.h"
#include "exports/release_files.h"
#include "exports/sft.h"
#include "exports/start_files.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Write a data set in a format of others.\n"
    "\n"
    "  unietp export out/first --format sft --out out/sft      chats for fine-tuning (TRL, LLaMA-Factory, ms-swift)\n"
    "  unietp export out/first --format unietp-release --out out/release    as the paper's authors released theirs\n"
    "  unietp export out/first --format bddl --out out/bddl    BEHAVIOR's tasks as its own problem files\n"
    "  unietp export out/first --format pddl --out out/pddl    a domain per simulator, a problem and a plan per task\n"
    "  unietp export out/first --format starts --out out/starts    the start scene of each task, whole\n"
    "\n"
    "What the format does not say is left out, with the reason, in a file of its own.";

struct Options {
  std::filesystem::path dataset, out;
  std::string format, unit = "episode", observation = "boxes";
  std::vector<std::string> modes;
  SftOptions sft;
};

using Backends = std::vector<ValidationBackend>;

Exit tell(const Result<ExportedTasks>& made, const Options& options) {
  if (!made) return refuse(made.error());
  std::printf("%zu tasks in %s, %zu left out\n", made->said, options.out.string().c_str(), made->left_out);
  return Exit::Ok;
}

Exit write_pddl(const Options& options, const Backends& backends) {
  return tell(export_pddl(options.dataset, backends, options.out), options);
}

Exit write_bddl(const Options& options, const Backends& backends, const DataFolders& folders) {
  const auto synsets = folders.root / "data" / "bddl" / "synsets.csv";
  return tell(export_bddl(options.dataset, backends, synsets, options.out), options);
}

Exit write_release(const Options& options, const Backends& backends) {
  const auto made = export_release(options.dataset, backends, options.out);
  if (!made) return refuse(made.error());
  std::printf("%zu tasks in %s, %zu of them with a scene record; %zu tasks left out\n", made->tasks,
              options.out.string().c_str(), made->with_scene, made->left_out);
  return Exit::Ok;
}

std::string names_of(const std::vector<Mode>& modes) {
  std::vector<std::string> names;
  names.reserve(modes.size());
  for (const Mode mode : modes) names.emplace_back(name_of(mode));
  return join(names, ", ");
}

Exit write_sft(const Options& options, const Backends& backends) {
  SftOptions sft = options.sft;
  sft.unit = options.unit == "step" ? SftUnit::Step : SftUnit::Episode;
  sft.observation = options.observation == "both"    ? SftObservation::Both
                    : options.observation == "image" ? SftObservation::Image
                                                     : SftObservation::Boxes;
  for (const auto& name : options.modes) sft.modes.push_back(*mode_named(name));
  const auto made = export_sft(options.dataset, backends, sft, options.out);
  if (!made) return refuse(made.error());
  std::printf("%zu samples of %s in %s", made->samples, names_of(made->modes).c_str(), options.out.string().c_str());
  if (made->pictures > 0) std::printf(", %zu pictures", made->pictures);
  std::printf("\n");
  if (!made->left_out.empty())
    std::printf("%s shows pictures alone: --observation image or both\n", names_of(made->left_out).c_str());
  return Exit::Ok;
}

Exit export_dataset(const Options& options, const CommandLine& program) {
  if (std::error_code code; !std::filesystem::is_directory(options.dataset, code))
    return refuse({Error::Kind::Usage, options.dataset.string(), {}, "is not a folder; expected a finished data set"});
  if (options.format == "starts") return tell(export_starts(options.dataset, options.out), options);
  DataFolders folders = program.folders;
  folders.extended_library = records_extended_library(options.dataset);
  const auto reading = load_backends(folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  Backends backends;
  for (const auto& backend : reading.backends) backends.push_back({&backend.knowledge, &backend.profile});
  if (options.format == "bddl") return write_bddl(options, backends, folders);
  if (options.format == "unietp-release") return write_release(options, backends);
  return options.format == "sft" ? write_sft(options, backends) : write_pddl(options, backends);
}

}  // namespace

void add_export_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  options->sft.threads = program.processors;
  auto* command = app.add_subcommand("export", kHelp);
  command->add_option("dataset", options->dataset, "A finished data set")->required();
  command->add_option("--format", options->format, "sft, unietp-release, bddl, pddl or starts")
      ->required()
      ->one_of({"sft", "unietp-release", "bddl", "pddl", "starts"});
  command->add_option("--out", options->out, "A folder that does not exist yet")->required();
  command->add_option("--unit", options->unit, "sft: a sample is a whole episode or one step")
      ->one_of({"episode", "step"})
      ->shows_default();
  command->add_option("--observation", options->observation, "sft: what is shown of the home")
      ->one_of({"boxes", "image", "both"})
      ->shows_default();
  command->add_option("--modes", options->modes, "sft: of these modes (default: all that there are)")
      ->one_of({"M1", "M2", "M3"})
      ->type_name("MODE,...")
      ->delimiter(',');
  command->add_flag("--reasoning", options->sft.reasoning, "sft: a few words on what is seen, held and missing");
  command->add_option("--threads", options->sft.threads, "sft: threads; never changes the result")->within(1, 256);
  command->callback([options, &program] { program.exit = export_dataset(*options, program); });
}

}  // namespace unietp
