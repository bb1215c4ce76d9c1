#pragma once

#include <string>

#include "akb/knowledge.h"
#include "interchange/source_scene.h"
#include "scene/json_reader.h"

namespace unietp {

/// A list of labeled boxes along the axes, `{"objects": [{"category", "name", "center", "size"}]}`, as HSSD scenes are
/// given for perception: already z up, so its axes are those of W. Which way a thing faces is told by its longer side
/// and, there being no rooms, by nothing else.
SourceScene read_labeled_boxes(JsonReader& reader, const JsonAt& home, std::string id, const Knowledge& knowledge);

}  // namespace unietp
