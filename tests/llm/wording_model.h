#pragma once

#include <map>
#include <mutex>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "server.h"

namespace unietp::test {

/// A model that words tasks and judges texts without a slip: it says the last wording that the prompt shows, and
/// remembers which goal it was of.
class WordingModel {
 public:
  /// What it says to the body of a chat request.
  std::string content_for(const nlohmann::json& body);
  /// The whole HTTP text of it.
  std::string operator()(const Received& received);

 private:
  std::mutex mutex_;
  std::map<std::string, std::string> goal_of_;  // by text
};

}  // namespace unietp::test
