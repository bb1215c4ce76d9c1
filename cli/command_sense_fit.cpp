#include <cstdio>
#include <memory>

#include "cli/command_knowledge.h"
#include "cli/command_parser.h"
#include "cli/sense_folder.h"
#include "core/folder_lock.h"
#include "sense/fit.h"

namespace unietp {
namespace {

struct SenseFitOptions {
  std::filesystem::path metadata, activities, out;
};

Exit fit(const SenseFitOptions& options, const CommandLine& program) {
  std::vector<Error> errors;
  const auto knowledge = load_some(program, {kSimulators.begin(), kSimulators.end()}, errors);
  if (!errors.empty()) return refuse(errors);
  const auto tables = sense_folder(program);
  const auto out = options.out.empty() ? tables : options.out;
  const auto lock = FolderLock::take(out);
  if (!lock) return refuse(lock.error());
  const auto done = fit_sense_into(
      out, tables, {options.metadata, options.activities, program.folders.root / "data/bddl"}, knowledge);
  if (!done) return refuse(done.error());
  std::printf("wrote categories.csv, counts.csv and companions.csv to %s\n", out.string().c_str());
  return Exit::Ok;
}

}  // namespace

void add_sense_fit_command(CommandParser& knowledge, CommandLine& program) {
  auto options = std::make_shared<SenseFitOptions>();  // shared: the callback outlives this function
  auto* command = knowledge.add_subcommand("fit-sense", "Fit the tables to what people wrote");
  command->explain(
      "Writes categories.csv, counts.csv and companions.csv. The committed tables are what this writes, byte for byte; "
      "docs/sense.md "
      "lists the files.",
      {{"unietp knowledge fit-sense metadata --activities bddl/activity_definitions", ""}});
  command->add_option("FOLDER", options->metadata, "Folder with virtualhome/, housekeep/ and ai2thor/")
      ->required()
      ->folder();
  command->add_option("--activities", options->activities, "Folder of BEHAVIOR's activity definitions")
      ->required()
      ->folder();
  command->add_option("--out", options->out, "Folder to write to (default: data/sense)")->folder()->output();
  command->callback([options, &program] { program.exit = fit(*options, program); });
}

}  // namespace unietp
