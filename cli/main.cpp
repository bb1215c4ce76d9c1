#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include "cli/command_parser.h"
#include "cli/command_shape.h"
#include "cli/commands.h"
#include "cli/help_topics.h"
#include "cli/output.h"
#include "core/share_work.h"
#include "core/version.h"
#include "resources/find_data_folder.h"

namespace {

std::atomic<bool> interrupted{false};  // all that the signal handler may touch
static_assert(std::atomic<bool>::is_always_lock_free);

/// Work that has not stopped by itself is given up. What it was writing stays as a kill would leave it.
void on_time_over(int) { ::_exit(static_cast<int>(unietp::Exit::Interrupted)); }

void on_interrupt(int signal) {
  interrupted = true;
  (void)std::signal(signal, SIG_DFL);  // a second Ctrl-C ends the program at once
  constexpr itimerval kGrace{{0, 0}, {1, 500'000}};
  (void)::setitimer(ITIMER_REAL, &kGrace, nullptr);
}

std::string from_environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

std::filesystem::path cache_folder() {
  const std::filesystem::path cache = from_environment("XDG_CACHE_HOME"), home = from_environment("HOME");
  if (!cache.empty()) return cache / "unietp";
  if (!home.empty()) return home / ".cache" / "unietp";
  std::error_code code;
  const auto temporary = std::filesystem::temp_directory_path(code);
  return (code ? std::filesystem::path("/tmp") : temporary) / "unietp-cache";
}

unietp::Result<std::filesystem::path> data_folder() {
  std::error_code code;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", code);
  return unietp::find_data_folder(program, from_environment("UNIETP_DATA"));
}

std::string version_text(const unietp::DataFolders& folders) {
  const auto digest = unietp::knowledge_digest(folders);
  return "unietp " + std::string(unietp::program_version()) + "\nknowledge " + (digest ? *digest : "not found") +
         "\nbuild " + std::string(unietp::program_build());
}

void add_commands(unietp::CommandParser& app, unietp::CommandLine& program) {
  unietp::add_generate_command(app, program);
  unietp::add_benchmark_command(app, program);
  unietp::add_training_command(app, program);
  unietp::add_merge_command(app, program);
  unietp::add_validate_command(app, program);
  unietp::add_audit_command(app, program);
  unietp::add_review_command(app, program);
  unietp::add_stats_command(app, program);
  unietp::add_report_command(app, program);
  unietp::add_render_command(app, program);
  unietp::add_export_command(app, program);
  unietp::add_play_command(app, program);
  unietp::add_evaluate_command(app, program);
  unietp::add_compare_command(app, program);
  unietp::add_serve_command(app, program);
  unietp::add_annotate_command(app, program);
  unietp::add_template_command(app, program);
  unietp::add_knowledge_command(app, program);
  unietp::add_sense_command(app, program);
  unietp::add_scene_command(app, program);
  unietp::add_shape_command(app, program);
  unietp::add_goal_command(app, program);
  unietp::add_actions_command(app, program);
  unietp::add_schemas_command(app, program);
  unietp::add_help_command(app, program);
  unietp::add_completion_command(app, program);
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto sound = unietp::prepare_output(); !sound) return static_cast<int>(unietp::refuse(sound.error()));
  unietp::CommandLine program;
  const auto data = data_folder();
  program.folders = {data ? *data : std::filesystem::path(), cache_folder(), {}};
  program.interrupted = &interrupted;
  program.llm_key = from_environment("UNIETP_LLM_KEY");
  program.terminal = ::isatty(STDERR_FILENO) != 0;
  program.processors = unietp::processor_count();

  unietp::CommandParser app("unietp", "Make and verify embodied-planning tasks, offline");
  app.help_screen(unietp::main_screen());
  app.explain(
      "unietp makes data sets of embodied-planning tasks for AI2-THOR, VirtualHome, Habitat and BEHAVIOR. Each task "
      "has "
      "a furnished home at rest in a physics engine, a formal goal, an English instruction, and a demonstration that "
      "reaches the goal when it is replayed.",
      {});
  app.add_option("--data", program.folders.root, "The program's data: a folder with data/ and templates/library/")
      ->existing_folder();
  app.add_option("--overrides", program.folders.overrides,
                 "CSV file of your own facts, which win over all tables (simulator,category,fact,value,reason); may be "
                 "repeated")
      ->one_each()
      ->existing_file();
  app.version_flag("--version", [&program] { return version_text(program.folders); });
  app.require_subcommand();
  app.fall_through();
  add_commands(app, program);

  (void)std::signal(SIGALRM, on_time_over);
  for (const int signal : {SIGINT, SIGTERM}) (void)std::signal(signal, on_interrupt);
  const auto needs_data = [&](const std::string& command) {
    if (!program.folders.root.empty() || command == "help" || command == "completion") return 0;
    return static_cast<int>(unietp::refuse(data.error()));
  };
  try {
    if (const int refused = app.parse(argc, argv, needs_data); refused != 0) return refused;
    if (const auto printed = unietp::finish_output(); !printed) {
      const auto unprinted = unietp::refuse(printed.error());
      if (program.exit == unietp::Exit::Ok) program.exit = unprinted;
    }
  } catch (const std::exception& error) {
    (void)std::fprintf(stderr, "unietp: internal error: %s\n", error.what());
    return static_cast<int>(unietp::Exit::Wrong);
  }
  return static_cast<int>(program.exit);
}
