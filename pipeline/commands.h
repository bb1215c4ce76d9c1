#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "core/error.h"
#include "pipeline/resources.h"

namespace CLI {
class App;
}

namespace unietp {

/// What the program's end tells a script.
enum class Exit : int { Ok = 0, Wrong = 1, BadInput = 2, Interrupted = 130 };

/// What a command needs to know of the world; only `main` looks it up.
struct CommandLine {
  DataFolders folders;
  const std::atomic<bool>* interrupted = nullptr;
  std::string llm_key;    // from UNIETP_LLM_KEY; shown and stored nowhere
  bool terminal = false;  // stderr is one: a progress line may be drawn
  int processors = 1;
  Exit exit = Exit::Ok;  // set by the command that ran
};

// Each adds a command whose parsing runs it and sets `program.exit`. `program` outlives the parse.
void add_generate_command(CLI::App& app, CommandLine& program);
void add_validate_command(CLI::App& app, CommandLine& program);
void add_render_command(CLI::App& app, CommandLine& program);
void add_knowledge_command(CLI::App& app, CommandLine& program);
void add_template_command(CLI::App& app, CommandLine& program);
void add_goal_command(CLI::App& app, CommandLine& program);
void add_scene_command(CLI::App& app, CommandLine& program);
void add_actions_command(CLI::App& app, CommandLine& program);

/// Writes each error on a line of its own to stderr; Exit::BadInput.
Exit refuse(const std::vector<Error>& errors);
Exit refuse(const Error& error);

}  // namespace unietp
