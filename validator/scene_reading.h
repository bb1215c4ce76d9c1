#pragma once

#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

#include "scene/scene_lines.h"

namespace unietp {

/// Reads scene files for several threads: each takes a reader that others have left, with the lines that it knows.
class SceneReading {
 public:
  /// As scene_from_json.
  Result<Scene> read(std::string_view where, std::string_view text);

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<SceneLines>> free_;
};

}  // namespace unietp
