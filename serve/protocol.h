#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "serve/call.h"
#include "serve/protocol_options.h"
#include "serve/session_table.h"

namespace unietp {

/// The protocol of `unietp serve` (docs/protocol.md) without a transport: a call and what is answered. Whatever the
/// bytes of a call are, it is answered; no answer names a file of this machine. Deterministic but for tokens and for
/// the sessions that were idle too long: equal calls to a session give equal bytes, whatever others do meanwhile.
class Protocol {
 public:
  Protocol(ServedTasks tasks, const ProtocolOptions& options);
  Protocol(Protocol&&) noexcept;
  Protocol& operator=(Protocol&&) noexcept;
  ~Protocol();

  /// A request of JSON-RPC 2.0 with an id, and its response. A call without "session" is for the caller's only one.
  std::string message(std::string_view text, Caller& caller, ServerTime now);
  /// The response to a message of more than limits that a transport has.
  static std::string too_long();

  struct Answered {
    std::optional<CallFailure> failure;
    std::string body;  // the result, or {"error": {"code", "message"}}
  };
  /// A method and its parameters, a JSON object or nothing. Sessions belong to whoever has their token.
  Answered call(std::string_view method, std::string_view parameters, ServerTime now);

  /// Closes the sessions of a caller who is gone.
  void leave(Caller& caller);
  /// Closes idle sessions.
  void reap(ServerTime now);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
