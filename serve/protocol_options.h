#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/result.h"
#include "environment/task.h"
#include "environment/task_source.h"
#include "serve/session_table.h"

namespace unietp {

/// The tasks that a server has: those of a data set, new ones by seed, or both.
struct ServedTasks {
  std::optional<TaskSource> stored;
  std::function<Result<SharedTask>(std::uint64_t seed)> made;  // empty: none
};

/// Bounds of what clients may have open and for how long.
struct ProtocolOptions {
  std::size_t sessions = 16;        // open at once
  std::chrono::seconds idle{1800};  // after which a session is closed
  bool privileged = false;          // `state` is answered
  std::function<std::string()> token = counted_tokens();
  std::function<void(const Error&)> log{};  // what the answers keep to themselves, such as paths; may be empty
};

/// A client whose sessions end with its connection.
struct Caller {
  std::size_t most_sessions = 1;
  std::vector<std::string> sessions{};  // tokens
};

}  // namespace unietp
