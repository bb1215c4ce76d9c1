#include "evaluation/episode_fields.h"

#include <nlohmann/json.hpp>

#include "record/record_fields.h"

namespace unietp {

void write_key(nlohmann::ordered_json& json, const EpisodeKey& key) {
  json["task"] = key.task;
  json["mode"] = name_of(key.mode);
  json["repeat"] = key.repeat;
}

EpisodeKey read_key(JsonReader& reader, JsonFields& fields) {
  EpisodeKey key;
  if (const auto f = fields.required("task")) key.task = reader.plain_name(*f);
  if (const auto f = fields.required("mode")) key.mode = read_mode(reader, *f);
  if (const auto f = fields.required("repeat")) {
    key.repeat = read_whole(reader, *f);
    if (key.repeat < 1) reader.fail(*f, "expected a whole number from 1");
  }
  return key;
}

Mode read_mode(JsonReader& reader, const JsonAt& at) {
  const auto mode = mode_named(reader.text(at));
  if (!mode) reader.unknown_name(at, "mode", {"M1", "M2", "M3"});
  return mode.value_or(Mode::M1);
}

double read_not_negative(JsonReader& reader, const JsonAt& at) {
  const double value = reader.number(at);
  if (value < 0) reader.fail(at, "expected 0 or more");
  return value < 0 ? 0 : value;
}

}  // namespace unietp
