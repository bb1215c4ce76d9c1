#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "core/error.h"
#include "resources/resources.h"

namespace unietp {

class CommandParser;

/// Exit codes of the program.
enum class Exit : int { Ok = 0, Wrong = 1, BadInput = 2, Interrupted = 130 };

/// What commands know of their environment; only `main` looks it up.
struct CommandLine {
  DataFolders folders;
  const std::atomic<bool>* interrupted = nullptr;
  std::string llm_key;    // from UNIETP_LLM_KEY; never shown or stored
  bool terminal = false;  // stderr is a terminal, so a progress line may be drawn
  int processors = 1;
  Exit exit = Exit::Ok;  // set by the command that ran
};

// Each adds a command, whose callback runs it and sets `program.exit`. `program` and `app` outlive the parse.
void add_generate_command(CommandParser& app, CommandLine& program);
void add_benchmark_command(CommandParser& app, CommandLine& program);
void add_training_command(CommandParser& app, CommandLine& program);
void add_merge_command(CommandParser& app, CommandLine& program);
void add_validate_command(CommandParser& app, CommandLine& program);
void add_audit_command(CommandParser& app, CommandLine& program);
void add_schemas_command(CommandParser& app, CommandLine& program);
void add_stats_command(CommandParser& app, CommandLine& program);
void add_report_command(CommandParser& app, CommandLine& program);
void add_review_command(CommandParser& app, CommandLine& program);
void add_export_command(CommandParser& app, CommandLine& program);
void add_render_command(CommandParser& app, CommandLine& program);
void add_serve_command(CommandParser& app, CommandLine& program);
void add_play_command(CommandParser& app, CommandLine& program);
void add_evaluate_command(CommandParser& app, CommandLine& program);
void add_compare_command(CommandParser& app, CommandLine& program);
void add_knowledge_command(CommandParser& app, CommandLine& program);
void add_sense_command(CommandParser& app, CommandLine& program);
void add_template_command(CommandParser& app, CommandLine& program);
void add_annotate_command(CommandParser& app, CommandLine& program);
void add_goal_command(CommandParser& app, CommandLine& program);
void add_scene_command(CommandParser& app, CommandLine& program);
void add_actions_command(CommandParser& app, CommandLine& program);
void add_help_command(CommandParser& app, CommandLine& program);
void add_completion_command(CommandParser& app, CommandLine& program);

/// Prints each error on its own line to stderr. Returns Exit::BadInput.
Exit refuse(const std::vector<Error>& errors);
Exit refuse(const Error& error);

}  // namespace unietp
