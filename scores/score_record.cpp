#include <nlohmann/json.hpp>

#include "evaluation/episode_fields.h"
#include "record/record_fields.h"
#include "scores/episode_score.h"
#include "scores/failure_class.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

void read_counts(JsonReader& reader, JsonFields& fields, EpisodeScore& score) {
  const std::pair<const char*, int*> counts[] = {{"steps", &score.steps},
                                                 {"failures", &score.failures},
                                                 {"replies", &score.replies},
                                                 {"actions", &score.actions},
                                                 {"no_json", &score.no_json},
                                                 {"truncated", &score.truncated},
                                                 {"unknown_action", &score.unknown_action},
                                                 {"bad_argument", &score.bad_argument},
                                                 {"boxes", &score.boxes},
                                                 {"hits", &score.hits}};
  for (const auto& [name, count] : counts) {
    if (const auto f = fields.required(name)) *count = read_whole(reader, *f);
  }
  const std::pair<const char*, std::int64_t*> tokens[] = {{"prompt_tokens", &score.prompt_tokens},
                                                          {"completion_tokens", &score.completion_tokens}};
  for (const auto& [name, count] : tokens) {
    if (const auto f = fields.required(name)) *count = static_cast<std::int64_t>(read_seed(reader, *f));
  }
}

void read_classes(JsonReader& reader, JsonFields& fields, EpisodeScore& score) {
  const auto f = fields.required("classes");
  if (!f) return;
  score.classes = reader.texts(*f);
  for (const std::string& one : score.classes) {
    if (!failure_class_of(one)) reader.fail(*f, "expected classes of failure as \"output: truncated\"");
  }
  if (score.classes.empty() != score.success) reader.fail(*f, "expected no class exactly for a success");
}

}  // namespace

std::string score_line(const EpisodeScore& score) {
  Json json{{"format", "unietp-score/1"}};
  write_key(json, score.key);
  json.update({{"simulator", score.simulator},
               {"split", score.split},
               {"template", score.template_name},
               {"layout", score.layout},
               {"held_out", score.held_out},
               {"end", name_of(score.end)},
               {"success", score.success},
               {"progress", score.progress},
               {"steps", score.steps},
               {"failures", score.failures},
               {"replies", score.replies},
               {"actions", score.actions},
               {"no_json", score.no_json},
               {"truncated", score.truncated},
               {"unknown_action", score.unknown_action},
               {"bad_argument", score.bad_argument},
               {"premature_stop", score.premature_stop},
               {"missed_stop", score.missed_stop},
               {"boxes", score.boxes},
               {"hits", score.hits},
               {"overlap", score.overlap}});
  if (score.shortest) json["shortest"] = *score.shortest;
  json["prompt_tokens"] = score.prompt_tokens;
  json["completion_tokens"] = score.completion_tokens;
  json["cost"] = score.cost;
  json["classes"] = score.classes;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<EpisodeScore> read_score(std::string_view where, int line, std::string_view text) {
  EpisodeScore score;
  const auto read = read_line(where, line, text, "unietp-score/1", [&](JsonReader& reader, JsonFields& fields) {
    score.key = read_key(reader, fields);
    const std::pair<const char*, std::string*> names[] = {{"simulator", &score.simulator},
                                                          {"split", &score.split},
                                                          {"template", &score.template_name},
                                                          {"layout", &score.layout}};
    for (const auto& [name, value] : names) {
      if (const auto f = fields.required(name)) *value = reader.plain_name(*f);
    }
    if (const auto f = fields.required("end")) {
      const auto end = outcome_named(reader.text(*f));
      if (end) score.end = *end;
      if (!end) reader.unknown_name(*f, "end", {"stop", "steps", "failures", "answers", "errored"});
    }
    const std::pair<const char*, bool*> flags[] = {{"held_out", &score.held_out},
                                                   {"success", &score.success},
                                                   {"premature_stop", &score.premature_stop},
                                                   {"missed_stop", &score.missed_stop}};
    for (const auto& [name, value] : flags) {
      if (const auto f = fields.required(name)) *value = reader.boolean(*f);
    }
    if (const auto f = fields.required("progress")) {
      score.progress = read_not_negative(reader, *f);
      if (score.progress > 1) reader.fail(*f, "expected a number from 0 to 1");
    }
    read_counts(reader, fields, score);
    if (const auto f = fields.required("overlap")) score.overlap = read_not_negative(reader, *f);
    if (const auto f = fields.optional("shortest")) score.shortest = read_whole(reader, *f);
    if (const auto f = fields.required("cost")) score.cost = read_not_negative(reader, *f);
    read_classes(reader, fields, score);
  });
  if (!read) return read.error();
  if (score.errored() && score.success)
    return Error{
        Error::Kind::Schema, std::string(where) + "#/success", {line, 0}, "expected false where it is errored"};
  return score;
}

}  // namespace unietp
