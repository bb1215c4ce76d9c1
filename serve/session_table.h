#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "environment/environment.h"
#include "environment/settings.h"

namespace unietp {

/// A moment of the clock that idle sessions are closed by. No result depends on it.
using ServerTime = std::chrono::steady_clock::time_point;

/// What a client plays in: its settings, and the environment once it was reset.
struct Session {
  Settings settings;
  bool pictures = false;  // answers bring what the camera shows
  std::optional<Environment> environment;
  std::optional<StepResult> step;  // the last one since the reset, without its privileged part
  std::uint64_t turn = 0;          // resets and steps so far
  ServerTime used;
};

/// The open sessions by token: a bounded number, each closed when nobody has used it for a while.
class SessionTable {
 public:
  /// `token` makes a new token each time; over a network nobody may be able to guess one.
  SessionTable(std::size_t most, std::chrono::seconds idle, std::function<std::string()> token);

  /// The new session's token; nullopt when there are as many as may be.
  std::optional<std::string> open(Session session, ServerTime now);
  /// nullptr for a token of no session. Marks the session as used.
  Session* find(std::string_view token, ServerTime now);
  /// Whether there was one.
  bool close(std::string_view token);
  /// Closes the sessions that were not used in the time that they may idle.
  void reap(ServerTime now);

  std::size_t size() const { return sessions_.size(); }
  std::size_t most() const { return most_; }           // sessions that may be open at once
  std::chrono::seconds idle() const { return idle_; }  // after which a session ends

 private:
  std::size_t most_;
  std::chrono::seconds idle_;
  std::function<std::string()> token_;
  std::map<std::string, Session, std::less<>> sessions_;
};

/// Tokens for one client: "1", "2", …
std::function<std::string()> counted_tokens();
/// Tokens for whoever can reach a port: 128 random bits in hexadecimal, from the system.
std::function<std::string()> secret_tokens();

}  // namespace unietp
