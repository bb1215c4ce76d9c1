#pragma once

#include <memory>
#include <string>
#include <vector>

#include "llm/exchange.h"

namespace unietp {

/// How one HTTP attempt ended.
struct HttpAnswer {
  std::size_t id = 0;
  std::string failure;                        // why there is no complete answer, without the key; "" when there is one
  bool timed_out = false, too_large = false;  // what the failure was
  long status = 0;
  std::string body, retry_after, date;
};

/// Sends concurrent POST requests from one thread. Follows no redirects, so that the key is sent to one host only. The
/// destructor abandons requests in progress.
class Transport {
 public:
  /// attempt_s bounds each attempt, in seconds.
  Transport(const LlmEndpoint& endpoint, double attempt_s);
  ~Transport();
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  /// Sends a request; `id` returns in its answer.
  void start(std::size_t id, std::string body);
  /// Number of requests in progress.
  int in_progress() const;
  /// Waits at most that long until requests end, and returns those that ended.
  std::vector<HttpAnswer> wait(double seconds);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
