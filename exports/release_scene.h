#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "scene/scene.h"

namespace unietp {

/// A start as far as the paper's release can say it.
struct ReleaseScene {
  std::optional<std::string> record;         // an item of `sampled_scenes` as JSON; nullopt: their runner loads none
  std::string file, file_text;               // that goes with it, by path in the export; "" when there is none
  std::vector<std::string> not_said;         // for people
  std::map<std::string, std::string> names;  // of our objects there, by id
};

/// `name` names the scene's own file. Errors: those of the writers in interchange/.
Result<ReleaseScene> release_scene(const std::string& name, const Scene& start, const Knowledge& knowledge);

}  // namespace unietp
