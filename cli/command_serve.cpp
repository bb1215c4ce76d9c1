#include <unistd.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/served_tasks.h"
#include "core/limits.h"
#include "serve/http_origin.h"
#include "serve/http_protocol.h"
#include "serve/http_server.h"
#include "serve/line_server.h"
#include "serve/play_page.h"
#include "serve/protocol.h"

namespace unietp {
namespace {

struct ServeOptions {
  TaskChoice tasks;
  std::string host = "127.0.0.1";
  int port = -1, sessions = 16, idle_s = 1800;
  bool privileged = false;
};

/// Until the program is interrupted.
Exit serve_port(const ServeOptions& options, Protocol& protocol, const std::atomic<bool>& stop) {
  HttpOptions http;
  http.host = options.host;
  http.port = options.port;
  http.message_bytes = limits::kMessageBytes;
  http.connections = static_cast<std::size_t>(limits::kServedConnections);
  auto server = HttpServer::listen(std::move(http), http_service(protocol, play_page()));
  if (!server) return refuse(server.error());
  if (!is_loopback(options.host))
    (void)std::fprintf(stderr,
                       "warning: whoever reaches %s can open sessions; nothing is encrypted and nobody is asked "
                       "for a password\n",
                       server->url().c_str());
  std::printf("%s\n", server->url().c_str());
  (void)std::fflush(stdout);
  while (!stop) {
    server->serve(std::chrono::milliseconds(500));
    protocol.reap(std::chrono::steady_clock::now());
  }
  return Exit::Interrupted;
}

Exit serve(const ServeOptions& options, const CommandLine& program) {
  if (options.tasks.folder.empty() && !options.tasks.procedural)
    return refuse({Error::Kind::Usage, "unietp serve", {}, "expected the folder of a data set, or --procedural"});
  auto reading = served_tasks(options.tasks, program);
  if (!reading.errors.empty()) return refuse(reading.errors);
  ProtocolOptions settings;
  settings.sessions = static_cast<std::size_t>(options.sessions);
  settings.idle = std::chrono::seconds(options.idle_s);
  settings.privileged = options.privileged;
  settings.log = [](const Error& error) { (void)refuse(error); };
  const bool has_port = options.port >= 0;
  if (has_port) settings.token = secret_tokens();
  Protocol protocol(std::move(reading.tasks), settings);
  const std::atomic<bool>& stop = *program.interrupted;
  if (has_port) return serve_port(options, protocol, stop);
  serve_lines(STDIN_FILENO, stdout, limits::kMessageBytes, protocol, stop);
  return stop ? Exit::Interrupted : Exit::Ok;
}

}  // namespace

void add_serve_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<ServeOptions>();  // shared: the callback outlives this function
  auto* command =
      app.add_subcommand("serve", "Let an agent in any language act in tasks, over stdio, HTTP or WebSocket");
  command->explain(
      "Without --port, requests are read from standard input, one a line, and answered on standard output, one a line "
      "(JSON-RPC 2.0). With --port the same methods are at POST /v1/METHOD and at the WebSocket /v1/ws, and a page to "
      "play in is at /; the address is printed. Only this machine can reach it unless --host says otherwise. No "
      "request can read a file other than the data set's. docs/protocol.md describes the methods.",
      {{"unietp serve out/first", "requests from standard input"},
       {"unietp serve out/first --port 8080", "HTTP, WebSocket and the page at http://127.0.0.1:8080"},
       {"unietp serve --procedural --simulators habitat --port 0", "new tasks without end, at a port that is free"}});
  command->add_option("FOLDER", options->tasks.folder, "A finished data set")->existing_folder();
  add_procedural_options(*command, options->tasks);
  auto* port =
      command->add_option("--port", options->port, "Serve HTTP and WebSocket at this port; 0: one that is free");
  port->within(0, 65'535);
  command->add_option("--host", options->host, "IP address to listen at")->needs(port)->shows_default();
  command->add_option("--sessions", options->sessions, "Sessions open at once, each some 20 MB of memory")
      ->within(1, limits::kServedSessions)
      ->shows_default();
  command->add_option("--idle", options->idle_s, "Seconds after which a session that nobody uses is closed")
      ->within(1, limits::kIdle_s)
      ->shows_default();
  command->add_flag("--privileged", options->privileged,
                    "Also answer what agents must not know: goal, progress, scene graph");
  command->callback([options, &program] { program.exit = serve(*options, program); });
}

}  // namespace unietp
