#include "evaluation/episode_record.h"

#include <algorithm>
#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "evaluation/episode_fields.h"
#include "record/record_fields.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kOutcomes{std::pair{EpisodeOutcome::Stop, "stop"}, std::pair{EpisodeOutcome::Steps, "steps"},
                               std::pair{EpisodeOutcome::Failures, "failures"},
                               std::pair{EpisodeOutcome::Answers, "answers"},
                               std::pair{EpisodeOutcome::Errored, "errored"}};
constexpr std::array kErrorKinds{
    std::pair{EpisodeErrorKind::RateLimit, "rate_limit"},  std::pair{EpisodeErrorKind::Server, "server"},
    std::pair{EpisodeErrorKind::Connection, "connection"}, std::pair{EpisodeErrorKind::Timeout, "timeout"},
    std::pair{EpisodeErrorKind::Rejected, "rejected"},     std::pair{EpisodeErrorKind::Policy, "policy"},
    std::pair{EpisodeErrorKind::Simulator, "simulator"}};

template <class Table>
auto value_named(const Table& table, std::string_view name) -> std::optional<decltype(table[0].first)> {
  for (const auto& [value, known] : table) {
    if (name == known) return value;
  }
  return std::nullopt;
}
template <class Table>
std::vector<std::string> names_in(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.second);
  return names;
}

Json action_json(const EpisodeAction& action) {
  Json json = command_to_json(action.command);
  json["success"] = action.success;
  json["failure"] = action.failure;
  json["feedback"] = action.feedback;
  json["counted"] = action.counted;
  if (action.simulator) {
    Json& simulator = json["simulator"] = {{"success", action.simulator->success},
                                           {"message", action.simulator->message},
                                           {"changes", Json::parse(delta_to_json(action.simulator->changes))}};
    for (const Delta& moment : action.simulator->moments)
      simulator["moments"].push_back(Json::parse(delta_to_json(moment)));
  }
  return json;
}

Json step_json(const EpisodeStep& step) {
  Json actions = Json::array();
  for (const EpisodeAction& action : step.actions) actions.push_back(action_json(action));
  return {{"prompt", step.prompt},
          {"reply", step.reply},
          {"thinking", step.thinking},
          {"finish", step.finish},
          {"unreadable", step.unreadable},
          {"actions", std::move(actions)},
          {"progress", step.progress},
          {"prompt_tokens", step.prompt_tokens},
          {"completion_tokens", step.completion_tokens},
          {"cost", step.cost}};
}

/// Without a name: a reply that could not be read.
Command read_command(JsonReader& reader, const JsonAt& at, const JsonAt& action, const JsonAt& args) {
  if (action.json.is_string() && action.json.get_ref<const std::string&>().empty()) {
    if (reader.items(args) != 0) reader.fail(args, "expected no argument without an action");
    return {};
  }
  return read_part(reader, at, command_from_json, Json{{"action", action.json}, {"args", args.json}});
}

SimulatorAnswer read_simulator(JsonReader& reader, const JsonAt& at) {
  SimulatorAnswer answer;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("success")) answer.success = reader.boolean(*f);
  if (const auto f = fields.required("message")) answer.message = text_or_empty(reader, *f);
  if (const auto f = fields.required("changes")) answer.changes = read_part(reader, *f, delta_from_json, f->json);
  if (const auto f = fields.optional("moments")) answer.moments = read_moments(reader, *f);
  fields.finish();
  return answer;
}

EpisodeAction read_action(JsonReader& reader, const JsonAt& at) {
  EpisodeAction action;
  JsonFields fields(reader, at);
  const auto name = fields.required("action");
  const auto args = fields.required("args");
  if (name && args) action.command = read_command(reader, at, *name, *args);
  if (const auto f = fields.required("success")) action.success = reader.boolean(*f);
  if (const auto f = fields.required("failure")) {
    action.failure = reader.text(*f);
    const auto failure = failure_named(action.failure);
    if (!failure) reader.fail(*f, "expected the name of a failure, or \"none\"");
    if (failure && (*failure == Failure::None) != action.success)
      reader.fail(*f, "expected \"none\" exactly for an action that succeeded");
  }
  if (const auto f = fields.required("feedback")) action.feedback = text_or_empty(reader, *f);
  if (const auto f = fields.required("counted")) action.counted = reader.boolean(*f);
  if (const auto f = fields.optional("simulator")) action.simulator = read_simulator(reader, *f);
  fields.finish();
  return action;
}

double read_share(JsonReader& reader, const JsonAt& at) {
  const double value = reader.number(at);
  if (value < 0 || value > 1) reader.fail(at, "expected a number from 0 to 1");
  return value;
}

EpisodeStep read_step(JsonReader& reader, const JsonAt& at) {
  EpisodeStep step;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("prompt")) {
    step.prompt = text_or_empty(reader, *f);
    const bool is_digest =
        step.prompt.size() == 64 && step.prompt.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!step.prompt.empty() && !is_digest) reader.fail(*f, "expected a SHA-256 as 64 hexadecimal digits, or nothing");
  }
  if (const auto f = fields.required("reply")) step.reply = text_or_empty(reader, *f);
  if (const auto f = fields.required("thinking")) step.thinking = text_or_empty(reader, *f);
  if (const auto f = fields.required("finish")) step.finish = text_or_empty(reader, *f);
  if (const auto f = fields.required("unreadable")) step.unreadable = text_or_empty(reader, *f);
  if (const auto f = fields.required("actions")) {
    const std::size_t count = reader.items(*f);
    for (std::size_t i = 0; i < count && !reader.error(); ++i)
      step.actions.push_back(read_action(reader, reader.item(*f, i)));
    if (step.actions.empty()) reader.fail(*f, "expected at least one action");
  }
  if (const auto f = fields.required("progress")) step.progress = read_share(reader, *f);
  if (const auto f = fields.required("prompt_tokens"))
    step.prompt_tokens = static_cast<std::int64_t>(read_seed(reader, *f));
  if (const auto f = fields.required("completion_tokens"))
    step.completion_tokens = static_cast<std::int64_t>(read_seed(reader, *f));
  if (const auto f = fields.required("cost")) step.cost = read_not_negative(reader, *f);
  fields.finish();
  return step;
}

EpisodeError read_error(JsonReader& reader, const JsonAt& at) {
  EpisodeError error;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("kind")) {
    const auto kind = error_kind_named(reader.text(*f));
    if (kind) error.kind = *kind;
    if (!kind) reader.unknown_name(*f, "kind of error", names_in(kErrorKinds));
  }
  if (const auto f = fields.required("message")) error.message = reader.text(*f);
  fields.finish();
  return error;
}

void read_end(JsonReader& reader, JsonFields& fields, EpisodeRecord& episode) {
  const auto end = fields.required("end");
  if (end) {
    const auto outcome = outcome_named(reader.text(*end));
    if (outcome) episode.end = *outcome;
    if (!outcome) reader.unknown_name(*end, "end", names_in(kOutcomes));
  }
  const auto success = fields.required("success");
  if (success) episode.success = reader.boolean(*success);
  if (const auto f = fields.required("progress")) episode.progress = read_share(reader, *f);
  if (const auto f = fields.required("counted")) episode.counted = read_whole(reader, *f);
  if (const auto f = fields.required("failures")) episode.failures = read_whole(reader, *f);
  if (const auto f = fields.required("models")) {
    episode.models = reader.texts(*f);
    if (std::adjacent_find(episode.models.begin(), episode.models.end(), std::greater_equal<>()) !=
        episode.models.end())
      reader.fail(*f, "expected names in order, each once");
  }
  if (const auto f = fields.optional("error")) episode.error = read_error(reader, *f);
  if (reader.error()) return;
  const bool errored = episode.end == EpisodeOutcome::Errored;
  if (errored != episode.error.has_value())
    reader.fail(*end, "expected \"error\" exactly where the end is \"errored\"");
  if (errored && episode.success) reader.fail(*success, "expected false for an errored episode");
}

}  // namespace

std::string_view name_of(EpisodeOutcome end) { return kOutcomes[static_cast<std::size_t>(end)].second; }
std::optional<EpisodeOutcome> outcome_named(std::string_view name) { return value_named(kOutcomes, name); }
std::string_view name_of(EpisodeErrorKind kind) { return kErrorKinds[static_cast<std::size_t>(kind)].second; }
std::optional<EpisodeErrorKind> error_kind_named(std::string_view name) { return value_named(kErrorKinds, name); }

std::string episode_line(const EpisodeRecord& episode) {
  Json json{{"format", "unietp-episode/1"}};
  write_key(json, episode.key);
  json["simulator"] = episode.simulator;
  json["split"] = episode.split;
  json["template"] = episode.template_name;
  json["layout"] = episode.layout;
  Json& steps = json["steps"] = Json::array();
  for (const EpisodeStep& step : episode.steps) steps.push_back(step_json(step));
  json["end"] = name_of(episode.end);
  json["success"] = episode.success;
  json["progress"] = episode.progress;
  json["counted"] = episode.counted;
  json["failures"] = episode.failures;
  json["models"] = episode.models;
  if (episode.error) json["error"] = {{"kind", name_of(episode.error->kind)}, {"message", episode.error->message}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<EpisodeRecord> read_episode(std::string_view where, int line, std::string_view text) {
  EpisodeRecord episode;
  const auto read = read_line(where, line, text, "unietp-episode/1", [&](JsonReader& reader, JsonFields& fields) {
    episode.key = read_key(reader, fields);
    if (const auto f = fields.required("simulator")) episode.simulator = reader.plain_name(*f);
    if (const auto f = fields.required("split")) episode.split = reader.plain_name(*f);
    if (const auto f = fields.required("template")) episode.template_name = reader.plain_name(*f);
    if (const auto f = fields.required("layout")) episode.layout = reader.plain_name(*f);
    if (const auto f = fields.required("steps")) {
      const std::size_t count = reader.items(*f);
      for (std::size_t i = 0; i < count && !reader.error(); ++i)
        episode.steps.push_back(read_step(reader, reader.item(*f, i)));
    }
    read_end(reader, fields, episode);
  });
  if (!read) return read.error();
  return episode;
}

}  // namespace unietp
