#include <nlohmann/json.hpp>

#include "../serve/kitchen_tasks.h"
#include "bodies.h"
#include "core/text.h"
#include "fuzz_bodies.h"
#include "serve/protocol.h"

namespace unietp::fuzz {
namespace {

/// A response of JSON-RPC 2.0. True when it is no error.
bool check_response(const std::string& response) {
  require(response.find('\n') == std::string::npos);
  const auto json = nlohmann::json::parse(response, nullptr, false);
  require(json.is_object() && json.value("jsonrpc", "") == "2.0" && json.contains("id"));
  require(json.contains("result") != json.contains("error"));
  if (json.contains("result")) return json["result"].is_object();
  require(json["error"]["code"].get<int>() < 0 && !json["error"]["message"].get<std::string>().empty());
  return false;
}

}  // namespace

bool serve_body(std::string_view text) {
  static const ServedTasks kTasks = testing::kitchen_tasks();
  ProtocolOptions options;
  options.sessions = 3;
  Protocol protocol(kTasks, std::move(options));
  Caller caller{3};
  bool accepted = true;
  for (const auto& line : split(text, '\n')) {
    if (!line.empty()) accepted = check_response(protocol.message(line, caller, {})) && accepted;
    require(caller.sessions.size() <= 3);
  }
  protocol.leave(caller);
  const auto answered = protocol.call("open", text, {});
  require(nlohmann::json::accept(answered.body));
  return accepted;
}

}  // namespace unietp::fuzz
