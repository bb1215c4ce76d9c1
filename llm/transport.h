#pragma once

#include <memory>
#include <string>
#include <vector>

#include "llm/exchange.h"

namespace unietp {

/// How one HTTP attempt ended.
struct HttpAnswer {
  std::size_t id = 0;
  std::string failure;  // why there is no whole answer, without the key; "" when there is one
  long status = 0;
  std::string body, retry_after, date;
};

/// Sends POST requests side by side from one thread. Follows no redirects, so the key goes to the one host that was
/// named. What is under way when this value goes is given up.
class Transport {
 public:
  /// attempt_s bounds each attempt, in seconds.
  Transport(const LlmEndpoint& endpoint, double attempt_s);
  ~Transport();
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  void start(std::size_t id, std::string body);
  int under_way() const;
  /// Waits until something ends, at most that long, and gives what ended.
  std::vector<HttpAnswer> wait(double seconds);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
