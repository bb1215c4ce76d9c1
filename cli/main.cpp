#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "core/share_work.h"
#include "dataset/manifest.h"

namespace {

std::atomic<bool> interrupted{false};  // the one thing that a signal handler may touch
static_assert(std::atomic<bool>::is_always_lock_free);

void on_interrupt(int signal) {
  interrupted = true;
  (void)std::signal(signal, SIG_DFL);  // a second Ctrl-C ends the program at once
}

std::filesystem::path cache_folder() {
  const auto from = [](const char* variable) {
    const char* value = std::getenv(variable);
    return std::filesystem::path(value == nullptr ? "" : value);
  };
  if (const auto cache = from("XDG_CACHE_HOME"); !cache.empty()) return cache / "unietp";
  if (const auto home = from("HOME"); !home.empty()) return home / ".cache" / "unietp";
  return std::filesystem::temp_directory_path() / "unietp-cache";
}

std::string llm_key() {
  const char* value = std::getenv("UNIETP_LLM_KEY");
  return value == nullptr ? "" : value;
}

constexpr const char* kAbout =
    "Makes verified embodied-planning tasks for four simulators, offline.\n"
    "\n"
    "  unietp benchmark --out out/benchmark                   make the benchmark of 536 tasks\n"
    "  unietp training --out out/training                     make 9,000 tasks to learn from\n"
    "  unietp generate --count 40 --seed 1 --out out/first    make a data set of another kind\n"
    "  unietp validate out/first                              prove it again from its files\n"
    "  unietp annotate out/first --writer llm --llm-url URL --llm-model M    have a language model word it\n"
    "  unietp render out/first ai2thor-00001 --out home.svg   see a task from above\n"
    "\n"
    "Exit codes: 0 done; 1 finished, but something is wrong; 2 bad input; 130 interrupted.\n"
    "`unietp COMMAND --help` explains a command with examples.";

}  // namespace

int main(int argc, char** argv) {
  unietp::CommandLine program;
  program.folders = {UNIETP_DATA_DIR, cache_folder(), {}};
  program.interrupted = &interrupted;
  program.llm_key = llm_key();
  program.terminal = ::isatty(STDERR_FILENO) != 0;
  program.processors = unietp::processor_count();

  unietp::CommandParser app(kAbout, "unietp");
  app.version_flag("--version", "unietp " + std::string(unietp::program_version()));
  app.add_option("--data", program.folders.root,
                 "Folder that holds data/ and templates/library/ (default: the source folder of this build)")
      ->existing_folder();
  app.add_option("--overrides", program.folders.overrides,
                 "CSV files of your own facts, which win over all tables: simulator,category,fact,value,reason")
      ->one_each()  // one file each time it is given
      ->existing_file();
  app.require_subcommand();
  app.fall_through();
  unietp::add_benchmark_command(app, program);
  unietp::add_training_command(app, program);
  unietp::add_generate_command(app, program);
  unietp::add_merge_command(app, program);
  unietp::add_validate_command(app, program);
  unietp::add_stats_command(app, program);
  unietp::add_report_command(app, program);
  unietp::add_review_command(app, program);
  unietp::add_export_command(app, program);
  unietp::add_schemas_command(app, program);
  unietp::add_render_command(app, program);
  unietp::add_scene_command(app, program);
  unietp::add_template_command(app, program);
  unietp::add_knowledge_command(app, program);
  unietp::add_annotate_command(app, program);
  unietp::add_goal_command(app, program);
  unietp::add_actions_command(app, program);

  (void)std::signal(SIGINT, on_interrupt);
  (void)std::signal(SIGTERM, on_interrupt);
  try {
    if (const int refused = app.parse(argc, argv); refused != 0) return refused;
  } catch (const std::exception& error) {
    (void)std::fprintf(stderr, "unietp: internal error: %s\n", error.what());
    return static_cast<int>(unietp::Exit::Wrong);
  }
  return static_cast<int>(program.exit);
}
