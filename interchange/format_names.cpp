#include <algorithm>

#include "interchange/formats.h"

namespace unietp {

const std::vector<std::string>& scene_format_names() {
  static const std::vector<std::string> names{"ithor", "procthor", "virtualhome", "replicacad", "hssd", "behavior"};
  return names;
}

std::string_view name_of(SceneFormat format) { return scene_format_names()[static_cast<std::size_t>(format)]; }

std::optional<SceneFormat> scene_format_named(std::string_view name) {
  const auto& names = scene_format_names();
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<SceneFormat>(found - names.begin());
}

}  // namespace unietp
