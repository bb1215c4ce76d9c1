#include "serve/method_call.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace unietp {

CallError wrong_parameters(std::string message) { return {CallFailure::WrongParameters, std::move(message)}; }

CallError unknown_session() {
  return {CallFailure::UnknownSession, "no such session; it may have been idle for too long"};
}

std::optional<std::string> session_token(const MethodCall& call, Parameters& parameters) {
  auto named = parameters.text("session");
  if (!named && call.caller != nullptr && call.caller->sessions.size() == 1) return call.caller->sessions.front();
  return named;
}

}  // namespace unietp
