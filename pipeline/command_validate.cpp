#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "pipeline/command_parser.h"
#include "pipeline/commands.h"
#include "validator/validate.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Prove a data set again from its files alone.\n"
    "\n"
    "  unietp validate out/first\n"
    "  unietp validate out/first --json > report.json\n"
    "\n"
    "Rebuilds each start scene in fresh physics, replays each demonstration and compares every outcome, view and "
    "change,\n"
    "and evaluates the goal on the replay. Tells everything that is wrong, with task, file and line. Exit code 0 only\n"
    "when nothing is.";

struct Options {
  std::filesystem::path folder;
  ValidationOptions validation;
  bool json = false;
};

/// Whether a data set was made with the extended library, and so by agents of the profile `wide`. A manifest that does
/// not read is told by the validator.
bool is_extended(const std::filesystem::path& folder) {
  const auto text = read_file(folder / "manifest.json");
  if (!text) return false;
  const auto manifest = nlohmann::json::parse(*text, nullptr, false);
  const nlohmann::json::json_pointer extended("/configuration/extended");
  return manifest.is_object() && manifest.contains(extended) && manifest[extended] == true;
}

void print_json(const ValidationReport& report) {
  auto problems = nlohmann::ordered_json::array();
  for (const auto& problem : report.problems) {
    const auto& error = problem.error;
    problems.push_back({{"task", problem.task},
                        {"where", error.where},
                        {"line", error.pos.line},
                        {"column", error.pos.column},
                        {"message", error.message}});
  }
  const nlohmann::ordered_json json{{"format", "unietp-validation/1"},
                                    {"tasks", report.tasks},
                                    {"proven", report.proven},
                                    {"problems", std::move(problems)}};
  std::printf("%s\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

Exit validate(const Options& options, const CommandLine& program) {
  if (std::error_code code; !std::filesystem::is_directory(options.folder, code))
    return refuse({Error::Kind::Usage, options.folder.string(), {}, "is no folder; a finished data set is expected"});
  auto folders = program.folders;
  folders.extended_library = is_extended(options.folder);
  const auto reading = load_backends(folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const auto digest = knowledge_digest(folders);
  if (!digest) return refuse(digest.error());
  std::vector<ValidationBackend> backends;
  for (const auto& backend : reading.backends) backends.push_back({&backend.knowledge, &backend.profile});

  const auto report = validate_dataset(options.folder, backends, *digest, options.validation);
  if (options.json) {
    print_json(report);
  } else {
    for (const auto& problem : report.problems)
      std::printf("%s: %s\n", problem.task.empty() ? "data set" : problem.task.c_str(), format(problem.error).c_str());
    std::printf("%d of %d proven\n", report.proven, report.tasks);
  }
  return report.sound() ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_validate_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  options->validation.threads = program.processors;
  auto* command = app.add_subcommand("validate", kHelp);
  command->add_option("folder", options->folder, "A finished data set")->required();
  command->add_option("--threads", options->validation.threads, "Threads (default: one a processor)")->within(1, 1024);
  command->add_flag("--json", options->json, "Report on stdout as JSON");
  command->callback([options, &program] { program.exit = validate(*options, program); });
}

}  // namespace unietp
