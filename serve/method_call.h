#pragma once

#include <optional>
#include <string>
#include <variant>

#include <nlohmann/json_fwd.hpp>

#include "serve/call.h"
#include "serve/parameters.h"
#include "serve/protocol_options.h"
#include "serve/session_table.h"

namespace unietp {

/// What a method works on.
struct MethodCall {
  const ServedTasks& tasks;
  const ProtocolOptions& options;
  SessionTable& sessions;
  Caller* caller;  // nullptr: one without a connection of its own
  ServerTime now;
  const nlohmann::ordered_json& parameters;  // an object
};

/// The `result` of an answer, or its `error`.
using MethodResult = std::variant<nlohmann::ordered_json, CallError>;

/// Errors that several methods answer with; `message` is for the client and names no file.
CallError wrong_parameters(std::string message);
CallError unknown_session();
/// The token of the parameter "session", or of the caller's only session; nullopt when there is neither.
std::optional<std::string> session_token(const MethodCall& call, Parameters& parameters);

}  // namespace unietp
