#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "core/result.h"
#include "scene/scene.h"

namespace unietp {

/// Reads many scene files that have most lines in common, as those of tasks in one home have: a node or an edge that
/// stood on an equal line before is not read again. What it remembers never matters to what is read. Not thread-safe.
class SceneLines {
 public:
  /// As scene_from_json, with the same errors.
  Result<Scene> read(std::string_view where, std::string_view text);

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view line) const { return std::hash<std::string_view>()(line); }
  };
  template <class T>
  using Known = std::unordered_map<std::string, T, Hash, std::equal_to<>>;  // by line; never iterated

  Known<Node> nodes_;
  Known<Edge> edges_;
};

/// What a scene file must be beyond its parts: no id twice, nothing that speaks of what is not there, no edge twice.
/// Sorts the edges. Errors: Schema with a JSON pointer.
Result<Scene> check_whole(std::string_view where, Scene scene);

}  // namespace unietp
