#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/served_tasks.h"
#include "core/limits.h"
#include "record/dataset_lines.h"
#include "serve/http_protocol.h"
#include "serve/http_server.h"
#include "serve/line_input.h"
#include "serve/play_page.h"
#include "serve/play_terminal.h"
#include "serve/protocol.h"

namespace unietp {
namespace {

struct PlayOptions {
  std::filesystem::path what;
  TaskChoice tasks;
  PlayChoice choice;
  std::optional<std::uint64_t> seed;
  int port = 0;
  bool no_page = false;
};

/// DATASET or DATASET/TASK.
void take_apart(PlayOptions& options) {
  if (options.what.empty()) return;
  std::error_code code;
  options.tasks.folder = options.what;
  if (std::filesystem::exists(options.what / kTasksFile, code)) return;
  if (!std::filesystem::exists(options.what.parent_path() / kTasksFile, code)) return;
  options.tasks.folder = options.what.parent_path();
  options.choice.task = options.what.filename().string();
}

Result<HttpServer> page_server(const PlayOptions& options, Protocol& protocol) {
  HttpOptions http;
  http.port = options.port;
  http.message_bytes = limits::kMessageBytes;
  http.connections = static_cast<std::size_t>(limits::kServedConnections);
  return HttpServer::listen(std::move(http), http_service(protocol, play_page()));
}

void print(const std::string& text) {
  (void)std::fputs(text.c_str(), stdout);
  (void)std::fflush(stdout);
}

/// Until the person leaves, the input ends or the program is interrupted. While a line is awaited, the page is served.
Exit converse(PlayTerminal& terminal, HttpServer* page, const std::atomic<bool>& stop) {
  LineInput lines(STDIN_FILENO, limits::kTextBytes);
  constexpr const char* kPrompt = "> ";
  print(terminal.begin() + kPrompt);
  while (!stop && !terminal.is_over()) {
    if (page != nullptr) page->serve(std::chrono::milliseconds(20));
    if (const auto news = terminal.watch(); !news.empty()) print("\n" + news + kPrompt);
    const auto got = lines.next(std::chrono::milliseconds(page != nullptr ? 0 : 500));
    if (got == LineInput::Got::End) break;
    if (got == LineInput::Got::TooLong) print(std::string("This line is too long.\n") + kPrompt);
    if (got != LineInput::Got::Line) continue;
    print(terminal.typed(lines.line()));
    if (!terminal.is_over()) print(kPrompt);
  }
  return stop ? Exit::Interrupted : Exit::Ok;
}

Exit play(PlayOptions& options, const CommandLine& program) {
  take_apart(options);
  if (options.tasks.folder.empty() && !options.tasks.procedural)
    return refuse({Error::Kind::Usage, "unietp play", {}, "expected a data set, DATASET/TASK, or --procedural"});
  auto reading = served_tasks(options.tasks, program);
  if (!reading.errors.empty()) return refuse(reading.errors);
  ProtocolOptions settings;
  settings.idle = std::chrono::hours(24 * 365);  // a person may take a break
  settings.token = secret_tokens();
  settings.log = [](const Error& error) { (void)refuse(error); };
  Protocol protocol(std::move(reading.tasks), settings);
  options.choice.seed = options.seed.value_or(0);
  options.choice.procedural = options.tasks.procedural && options.tasks.folder.empty();
  auto terminal = PlayTerminal::open(protocol, options.choice);
  if (!terminal) return refuse(terminal.error());
  std::optional<HttpServer> page;
  if (!options.no_page) {
    auto server = page_server(options, protocol);
    if (!server) return refuse(server.error());
    page.emplace(std::move(*server));
    print("Open this page beside the terminal to see the picture: " + page->url() + "/#" + terminal->session() + "\n");
  }
  print("`help` explains how to play.\n\n");
  return converse(*terminal, page ? &*page : nullptr, *program.interrupted);
}

}  // namespace

void add_play_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<PlayOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("play", "Play a task yourself, in the terminal with the picture in a browser");
  command->explain(
      "You get what an agent gets: the instruction, what is in view, what became of your actions. The page shows the "
      "camera's picture with the boxes; you can act there, too, by clicking on them. `stop` ends the episode and says "
      "whether the goal is reached.",
      {{"unietp play out/first/ai2thor-00001", "one task"},
       {"unietp play out/first --seed 7 --mode M3", "tasks in an order that depends on the seed, by pictures only"},
       {"unietp play --procedural --no-page", "new tasks, without the page"}});
  command->add_option("TASK", options->what, "DATASET/TASK, or DATASET for one task after the other")->folder();
  command->add_option("--mode", options->choice.mode, "What you are told and how you name things")
      ->one_of({"M1", "M2", "M3"})
      ->shows_default();
  command->add_option("--seed", options->seed, "Seed for choosing and ordering tasks (default: 0)");
  add_procedural_options(*command, options->tasks);
  auto* port = command->add_option("--port", options->port, "Port of the page (default: one that is free)");
  port->within(0, 65'535);
  command->add_flag("--no-page", options->no_page, "Only the terminal")->excludes(port);
  command->callback([options, &program] { program.exit = play(*options, program); });
}

}  // namespace unietp
