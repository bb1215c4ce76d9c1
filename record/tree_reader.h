#pragma once

#include "logic/formula.h"
#include "scene/json_reader.h"

namespace unietp {

/// A goal's tree as docs/files.md says it; problems go to the reader.
Formula read_tree(JsonReader& reader, const JsonAt& at);

}  // namespace unietp
