#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "interchange/format_facts.h"
#include "scene/scene.h"

namespace unietp {

/// A start scene as far as the paper's release can express it.
struct ReleaseScene {
  std::optional<std::string> record;  // an item of `sampled_scenes` as JSON; nullopt: their runner cannot load it
  std::string file, file_text;        // a file that belongs to it, by path in the export; "" for none
  std::vector<std::string> not_said;  // what is missing, in words
  std::map<std::string, std::string> names;  // names of our objects in it, by our id
};

/// `name`: of the scene's file. Errors: those of the writers in interchange/.
Result<ReleaseScene> release_scene(const std::string& name, const Scene& start, const Knowledge& knowledge,
                                   const FormatFacts& facts);

}  // namespace unietp
