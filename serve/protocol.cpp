#include "serve/protocol.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "core/in_quotes.h"
#include "scene/json_parse.h"
#include "serve/methods.h"
#include "serve/parameters.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// On one line and always UTF-8.
std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json error_json(const CallError& error) {
  return {{"code", static_cast<int>(error.failure)}, {"message", error.message}};
}

std::string response(const Json& id, const MethodResult& result) {
  Json json{{"jsonrpc", "2.0"}, {"id", id}};
  if (const auto* error = std::get_if<CallError>(&result)) {
    json["error"] = error_json(*error);
  } else {
    json["result"] = std::get<Json>(result);
  }
  return text_of(json);
}

/// "line 1, byte 7: expected ':'" or "/params/seed: expected …".
CallError unreadable(const Error& error) {
  if (error.kind != Error::Kind::Parse) return {CallFailure::NotARequest, in_call(error)};
  return {CallFailure::NotJson, "line " + std::to_string(error.pos.line) + ", byte " +
                                    std::to_string(error.pos.column) + ": " + error.message};
}

/// A request of JSON-RPC: what is asked for, or why not.
struct Request {
  Json id;  // null until it is known
  std::string method;
  Json parameters = Json::object();
  std::optional<CallError> error;
};

Request read_request(std::string_view text) {
  Request request;
  const auto refuse = [&](std::string message) {
    request.error = CallError{CallFailure::NotARequest, std::move(message)};
    return request;
  };
  auto json = parse_json(kCallName, text);
  if (!json) {
    request.error = unreadable(json.error());
    return request;
  }
  if (!json->is_object()) return refuse("expected one JSON object; batches are not accepted");
  const auto id = json->find("id");
  const bool has_id = id != json->end() && (id->is_string() || id->is_number_integer());
  if (has_id) request.id = *id;
  if (!has_id) return refuse("expected \"id\", a string or a whole number; notifications are not accepted");
  if (json->value("jsonrpc", Json()) != Json("2.0")) return refuse("expected \"jsonrpc\": \"2.0\"");
  const auto method = json->find("method");
  if (method == json->end() || !method->is_string()) return refuse("expected \"method\", a string");
  request.method = method->get<std::string>();
  const auto parameters = json->find("params");
  if (parameters != json->end() && !parameters->is_object()) return refuse("expected \"params\", an object");
  if (parameters != json->end()) request.parameters = std::move(*parameters);
  for (const auto& [name, value] : json->items()) {
    if (name != "jsonrpc" && name != "id" && name != "method" && name != "params")
      return refuse("expected no field but \"jsonrpc\", \"id\", \"method\" and \"params\"");
  }
  return request;
}

}  // namespace

struct Protocol::Impl {
  ServedTasks tasks;
  ProtocolOptions options;
  SessionTable sessions;

  MethodResult run(std::string_view name, const Json& parameters, Caller* caller, ServerTime now) {
    const auto& methods = all_methods();
    const auto found = std::find_if(methods.begin(), methods.end(), [&](const Method& m) { return m.name == name; });
    if (found == methods.end())
      return CallError{CallFailure::UnknownMethod, "no method " + in_quotes(name) + "; `hello` lists them"};
    return found->run({tasks, options, sessions, caller, now, parameters});
  }
};

Protocol::Protocol(ServedTasks tasks, const ProtocolOptions& options)
    : impl_(new Impl{std::move(tasks), options, SessionTable(options.sessions, options.idle, options.token)}) {}
Protocol::Protocol(Protocol&&) noexcept = default;
Protocol& Protocol::operator=(Protocol&&) noexcept = default;
Protocol::~Protocol() = default;

std::string Protocol::message(std::string_view text, Caller& caller, ServerTime now) {
  const Request request = read_request(text);
  if (request.error) return response(request.id, *request.error);
  return response(request.id, impl_->run(request.method, request.parameters, &caller, now));
}

std::string Protocol::too_long() {
  return response(nullptr, CallError{CallFailure::NotARequest, "the message is too long"});
}

Protocol::Answered Protocol::call(std::string_view method, std::string_view parameters, ServerTime now) {
  const auto refuse = [](const CallError& error) -> Answered {
    return {error.failure, text_of(Json{{"error", error_json(error)}})};
  };
  const auto json = parse_json(kCallName, parameters.empty() ? "{}" : parameters);
  if (!json) return refuse(unreadable(json.error()));
  if (!json->is_object()) return refuse({CallFailure::NotARequest, "expected a JSON object"});
  const auto result = impl_->run(method, *json, nullptr, now);
  if (const auto* error = std::get_if<CallError>(&result)) return refuse(*error);
  return {std::nullopt, text_of(std::get<Json>(result))};
}

void Protocol::leave(Caller& caller) {
  for (const auto& token : caller.sessions) (void)impl_->sessions.close(token);
  caller.sessions.clear();
}

void Protocol::reap(ServerTime now) { impl_->sessions.reap(now); }

}  // namespace unietp
