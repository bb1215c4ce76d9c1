#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"
#include "serve/protocol.h"

namespace unietp {

/// What a person plays.
struct PlayChoice {
  std::string mode = "M1";
  std::optional<std::string> task;  // id; nullopt: the order of the seed
  std::uint64_t seed = 0;
  bool procedural = false;  // new tasks, from this seed on
};

/// A person's episode in a terminal: what to print for what is typed. It is a client of the protocol like any other and
/// knows no more than an agent is told. Texts of the data set are made safe for a terminal.
class PlayTerminal {
 public:
  /// Opens a session of `protocol`, which must outlive this. Errors: Usage, as the protocol says, when the session or
  /// its first task cannot be had.
  static Result<PlayTerminal> open(Protocol& protocol, const PlayChoice& choice);
  PlayTerminal(PlayTerminal&&) noexcept;
  PlayTerminal& operator=(PlayTerminal&&) noexcept;
  ~PlayTerminal();

  /// The token of the session, for a page that shows it.
  const std::string& session() const;
  /// What is printed first.
  std::string begin() const;
  /// What is printed for a line. Empty lines print where things stand.
  std::string typed(std::string_view line);
  /// What is printed when someone else, such as the page, has acted in the session; "" when nobody has.
  std::string watch();
  /// Whether `quit` was typed.
  bool is_over() const;

 private:
  struct Impl;
  explicit PlayTerminal(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
