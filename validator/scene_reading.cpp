#include "validator/scene_reading.h"

#include <utility>

namespace unietp {

Result<Scene> SceneReading::read(std::string_view where, std::string_view text) {
  std::unique_ptr<SceneLines> lines;
  {
    const std::scoped_lock lock(mutex_);
    if (!free_.empty()) {
      lines = std::move(free_.back());
      free_.pop_back();
    }
  }
  if (lines == nullptr) lines = std::make_unique<SceneLines>();
  auto scene = lines->read(where, text);
  const std::scoped_lock lock(mutex_);
  free_.push_back(std::move(lines));
  return scene;
}

}  // namespace unietp
