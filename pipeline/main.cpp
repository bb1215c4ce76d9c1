#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>

#include "pipeline/commands.h"
#include "pipeline/manifest.h"

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
    "  unietp generate --count 40 --seed 1 --out out/first    make a data set\n"
    "  unietp validate out/first                              prove it again from its files\n"
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
  program.processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));

  CLI::App app(kAbout, "unietp");
  app.set_version_flag("--version", "unietp " + std::string(unietp::program_version()));
  app.add_option("--data", program.folders.root,
                 "Folder that holds data/ and templates/library/ (default: the source folder of this build)")
      ->check(CLI::ExistingDirectory);
  app.add_option("--overrides", program.folders.overrides,
                 "CSV files of your own facts, which win over all tables: simulator,category,fact,value,reason")
      ->allow_extra_args(false)  // one file each time it is given
      ->check(CLI::ExistingFile);
  app.require_subcommand(1);
  app.fallthrough();
  unietp::add_generate_command(app, program);
  unietp::add_validate_command(app, program);
  unietp::add_render_command(app, program);
  unietp::add_scene_command(app, program);
  unietp::add_template_command(app, program);
  unietp::add_knowledge_command(app, program);
  unietp::add_goal_command(app, program);
  unietp::add_actions_command(app, program);

  (void)std::signal(SIGINT, on_interrupt);
  (void)std::signal(SIGTERM, on_interrupt);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(unietp::Exit::BadInput);
  } catch (const std::exception& error) {
    (void)std::fprintf(stderr, "unietp: internal error: %s\n", error.what());
    return static_cast<int>(unietp::Exit::Wrong);
  }
  return static_cast<int>(program.exit);
}
