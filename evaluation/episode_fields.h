#pragma once

#include <nlohmann/json_fwd.hpp>

#include "evaluation/episode_key.h"
#include "scene/json_reader.h"

namespace unietp {

// Fields that several files of an evaluation have. Errors go to the reader.

/// Adds "task", "mode" and "repeat".
void write_key(nlohmann::ordered_json& json, const EpisodeKey& key);
EpisodeKey read_key(JsonReader& reader, JsonFields& fields);

/// A mode by its name.
Mode read_mode(JsonReader& reader, const JsonAt& at);
/// A finite number of 0 or more.
double read_not_negative(JsonReader& reader, const JsonAt& at);

}  // namespace unietp
