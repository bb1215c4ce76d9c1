#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// Why a call failed: the codes of JSON-RPC 2.0, and ours in the range that it leaves to servers.
enum class CallFailure : int {
  NotJson = -32700,
  NotARequest = -32600,
  UnknownMethod = -32601,
  WrongParameters = -32602,
  UnknownSession = -32001,
  TooManySessions = -32002,
  NotAllowed = -32003,  // only a server that was started with --privileged does it
  NoTask = -32004,      // there is no such task, or it cannot be loaded or made
  NotReset = -32005,    // the session has no episode yet
};
/// The status that HTTP has for it.
int http_status(CallFailure failure);

/// Why a call has no result.
struct CallError {
  CallFailure failure = CallFailure::NotARequest;
  std::string message;
};

}  // namespace unietp
