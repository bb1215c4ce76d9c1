#include "evaluation/evaluation_manifest.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "environment/settings.h"
#include "evaluation/episode_fields.h"
#include "record/record_fields.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 2> kAgentKinds{"model", "policy"};  // by AgentKind

Json selection_json(const EpisodeSelection& selection) {
  Json modes = Json::array();
  for (const Mode mode : selection.modes) modes.push_back(name_of(mode));
  return {{"modes", std::move(modes)}, {"splits", selection.splits}, {"simulators", selection.simulators},
          {"tasks", selection.tasks},  {"limit", selection.limit},   {"repeats", selection.repeats},
          {"seed", selection.seed}};
}

Json talk_json(const TalkSettings& talk) {
  return {{"prompt", talk.prompt},     {"prompt_digest", talk.prompt_digest},
          {"history", talk.history},   {"images", talk.images},
          {"multi", talk.multi},       {"described", talk.described},
          {"thinking", talk.thinking}, {"structured", talk.structured}};
}

Json sampling_json(const SamplingSettings& sampling) {
  Json json = Json::object();
  const auto add = [&](const char* name, const auto& value) {
    if (value) json[name] = *value;
  };
  add("temperature", sampling.temperature);
  add("top_p", sampling.top_p);
  add("max_tokens", sampling.max_tokens);
  add("seed", sampling.seed);
  json["extra"] = Json::parse(sampling.extra);
  return json;
}

Json files_json(const std::map<std::string, std::string>& files) {
  Json json = Json::array();
  for (const auto& [path, digest] : files) json.push_back({{"path", path}, {"sha256", digest}});
  return json;
}

Json setup_json(const EvaluationSetup& setup) {
  Json settings = Json::object();
  for (const auto& [mode, one] : setup.settings) settings[std::string(name_of(mode))] = settings_to_json(one);
  Json program{{"version", setup.program_version}, {"build", setup.program_build}};
  if (!setup.program_digest.empty()) program["sha256"] = setup.program_digest;
  Json agent{{"kind", name_of(setup.agent.kind)}, {"name", setup.agent.name}};
  if (!setup.agent.files.empty()) agent["files"] = files_json(setup.agent.files);
  Json json{{"program", std::move(program)},
            {"knowledge", setup.knowledge_digest},
            {"backend", setup.backend},
            {"dataset",
             {{"name", setup.dataset.name},
              {"version", setup.dataset.version},
              {"digest", setup.dataset.digest},
              {"tasks", setup.dataset.tasks}}},
            {"agent", std::move(agent)},
            {"selection", selection_json(setup.selection)},
            {"settings", std::move(settings)}};
  if (setup.talk) json["talk"] = talk_json(*setup.talk);
  if (setup.sampling) json["sampling"] = sampling_json(*setup.sampling);
  json["price"] = {{"in", setup.price_in}, {"out", setup.price_out}};
  return json;
}

std::vector<std::string> read_texts(JsonReader& reader, const std::optional<JsonAt>& at) {
  return at ? reader.texts(*at) : std::vector<std::string>();
}

EvaluatedDataset read_dataset(JsonReader& reader, const JsonAt& at) {
  EvaluatedDataset dataset;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("name")) dataset.name = reader.line(*f);
  if (const auto f = fields.required("version")) dataset.version = text_or_empty(reader, *f);
  if (const auto f = fields.required("digest")) dataset.digest = reader.line(*f);
  if (const auto f = fields.required("tasks")) dataset.tasks = read_whole(reader, *f);
  fields.finish();
  return dataset;
}

EpisodeSelection read_selection(JsonReader& reader, const JsonAt& at) {
  EpisodeSelection selection;
  selection.modes.clear();
  JsonFields fields(reader, at);
  if (const auto f = fields.required("modes")) {
    const std::size_t count = reader.items(*f, kModes.size());
    for (std::size_t i = 0; i < count && !reader.error(); ++i)
      selection.modes.push_back(read_mode(reader, reader.item(*f, i)));
  }
  selection.splits = read_texts(reader, fields.required("splits"));
  selection.simulators = read_texts(reader, fields.required("simulators"));
  selection.tasks = read_texts(reader, fields.required("tasks"));
  if (const auto f = fields.required("limit")) selection.limit = read_whole(reader, *f);
  if (const auto f = fields.required("repeats")) selection.repeats = read_whole(reader, *f);
  if (const auto f = fields.required("seed")) selection.seed = read_seed(reader, *f);
  fields.finish();
  return selection;
}

std::map<Mode, Settings> read_settings(JsonReader& reader, const JsonAt& at) {
  std::map<Mode, Settings> settings;
  JsonFields fields(reader, at);
  for (const Mode mode : kModes) {
    const auto f = fields.optional(name_of(mode));
    if (!f || reader.error()) continue;
    auto one = settings_from_json("settings", f->json);
    if (!one) reader.fail(*f, one.error().message);
    if (one) settings.emplace(mode, *one);
  }
  fields.finish();
  return settings;
}

TalkSettings read_talk(JsonReader& reader, const JsonAt& at) {
  TalkSettings talk;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("prompt")) talk.prompt = reader.line(*f);
  if (const auto f = fields.required("prompt_digest")) talk.prompt_digest = reader.line(*f);
  if (const auto f = fields.required("history")) {
    const double history = reader.number(*f);
    talk.history = history == -1 ? -1 : read_whole(reader, *f);
  }
  if (const auto f = fields.required("images")) talk.images = read_whole(reader, *f);
  if (const auto f = fields.required("multi")) talk.multi = reader.boolean(*f);
  if (const auto f = fields.required("described")) talk.described = reader.boolean(*f);
  if (const auto f = fields.required("thinking")) talk.thinking = reader.boolean(*f);
  if (const auto f = fields.required("structured")) talk.structured = reader.boolean(*f);
  fields.finish();
  return talk;
}

SamplingSettings read_sampling(JsonReader& reader, const JsonAt& at) {
  SamplingSettings sampling;
  JsonFields fields(reader, at);
  if (const auto f = fields.optional("temperature")) sampling.temperature = reader.number(*f);
  if (const auto f = fields.optional("top_p")) sampling.top_p = reader.number(*f);
  if (const auto f = fields.optional("max_tokens")) sampling.max_tokens = read_whole(reader, *f);
  if (const auto f = fields.optional("seed")) sampling.seed = read_seed(reader, *f);
  if (const auto f = fields.required("extra")) {
    if (!f->json.is_object()) reader.fail(*f, "expected an object");
    sampling.extra = f->json.dump();
  }
  fields.finish();
  return sampling;
}

std::map<std::string, std::string> read_files(JsonReader& reader, const JsonAt& at) {
  std::map<std::string, std::string> files;
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields own(reader, item);
    std::string path, digest;
    if (const auto f = own.required("path")) path = reader.line(*f);
    if (const auto f = own.required("sha256")) digest = reader.line(*f);
    own.finish();
    if (!files.emplace(path, digest).second) reader.fail(item, in_quotes(path) + " is listed twice");
  }
  return files;
}

EvaluationSetup read_setup(JsonReader& reader, const JsonAt& at) {
  EvaluationSetup setup;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("program")) {
    JsonFields own(reader, *f);
    if (const auto version = own.required("version")) setup.program_version = reader.line(*version);
    if (const auto build = own.required("build")) setup.program_build = reader.line(*build);
    if (const auto digest = own.optional("sha256")) setup.program_digest = reader.line(*digest);
    own.finish();
  }
  if (const auto f = fields.required("knowledge")) setup.knowledge_digest = reader.line(*f);
  if (const auto f = fields.required("backend")) setup.backend = reader.line(*f);
  if (const auto f = fields.required("dataset")) setup.dataset = read_dataset(reader, *f);
  if (const auto f = fields.required("agent")) {
    JsonFields own(reader, *f);
    if (const auto kind = own.required("kind")) {
      const std::string text = reader.text(*kind);
      const auto known = std::find(kAgentKinds.begin(), kAgentKinds.end(), text);
      if (known == kAgentKinds.end()) reader.fail(*kind, "expected model or policy");
      if (known != kAgentKinds.end()) setup.agent.kind = static_cast<AgentKind>(known - kAgentKinds.begin());
    }
    if (const auto name = own.required("name")) setup.agent.name = reader.line(*name);
    if (const auto files = own.optional("files")) setup.agent.files = read_files(reader, *files);
    own.finish();
  }
  if (const auto f = fields.required("selection")) setup.selection = read_selection(reader, *f);
  if (const auto f = fields.required("settings")) setup.settings = read_settings(reader, *f);
  if (const auto f = fields.optional("talk")) setup.talk = read_talk(reader, *f);
  if (const auto f = fields.optional("sampling")) setup.sampling = read_sampling(reader, *f);
  if (const auto f = fields.required("price")) {
    JsonFields own(reader, *f);
    if (const auto in = own.required("in")) setup.price_in = read_not_negative(reader, *in);
    if (const auto out = own.required("out")) setup.price_out = read_not_negative(reader, *out);
    own.finish();
  }
  fields.finish();
  return setup;
}

EvaluationTotals read_totals(JsonReader& reader, const JsonAt& at) {
  EvaluationTotals totals;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("episodes")) totals.episodes = read_whole(reader, *f);
  if (const auto f = fields.required("finished")) totals.finished = read_whole(reader, *f);
  if (const auto f = fields.required("errored")) totals.errored = read_whole(reader, *f);
  totals.models = read_texts(reader, fields.required("models"));
  if (const auto f = fields.required("prompt_tokens"))
    totals.prompt_tokens = static_cast<std::int64_t>(read_seed(reader, *f));
  if (const auto f = fields.required("completion_tokens"))
    totals.completion_tokens = static_cast<std::int64_t>(read_seed(reader, *f));
  if (const auto f = fields.required("cost")) totals.cost = read_not_negative(reader, *f);
  fields.finish();
  return totals;
}

/// Compares two values below a path.
void add_differences(const std::string& path, const Json& then, const Json& now, std::vector<std::string>& lines) {
  if (then == now) return;
  if (then.is_object() != now.is_object()) {
    lines.push_back(path + (now.is_object() ? ": not there then" : ": not there now"));
    return;
  }
  if (!then.is_object() || !now.is_object()) {
    lines.push_back(path + ": " + then.dump() + " then, " + now.dump() + " now");
    return;
  }
  const std::string prefix = path.empty() ? "" : path + ".";
  for (const auto& [key, value] : then.items()) add_differences(prefix + key, value, now.value(key, Json()), lines);
  for (const auto& [key, value] : now.items()) {
    if (!then.contains(key)) add_differences(prefix + key, Json(), value, lines);
  }
}

}  // namespace

std::string_view name_of(AgentKind kind) { return kAgentKinds[static_cast<std::size_t>(kind)]; }

std::string to_text(const EvaluationManifest& manifest) {
  const EvaluationTotals& totals = manifest.totals;
  Json json{{"format", "unietp-evaluation/1"},
            {"setup", setup_json(manifest.setup)},
            {"totals",
             {{"episodes", totals.episodes},
              {"finished", totals.finished},
              {"errored", totals.errored},
              {"models", totals.models},
              {"prompt_tokens", totals.prompt_tokens},
              {"completion_tokens", totals.completion_tokens},
              {"cost", totals.cost}}},
            {"report_pictures", manifest.report_pictures},
            {"files", files_json(manifest.files)}};
  return json.dump(2) + "\n";
}

Result<EvaluationManifest> read_evaluation_manifest(std::string_view where, std::string_view text) {
  const auto json = parse_json(where, text);
  if (!json) return json.error();
  EvaluationManifest manifest;
  JsonReader reader(where);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  read_format(reader, fields, "unietp-evaluation/1");
  if (const auto f = fields.required("setup")) manifest.setup = read_setup(reader, *f);
  if (const auto f = fields.required("totals")) manifest.totals = read_totals(reader, *f);
  if (const auto f = fields.optional("report_pictures")) manifest.report_pictures = read_whole(reader, *f);
  if (const auto f = fields.required("files")) manifest.files = read_files(reader, *f);
  fields.finish();
  if (reader.error()) return *reader.error();
  return manifest;
}

std::vector<std::string> differences(const EvaluationSetup& then, const EvaluationSetup& now) {
  std::vector<std::string> lines;
  Json was = setup_json(then), is = setup_json(now);
  was["agent"].erase("files");
  is["agent"].erase("files");
  add_differences("", was, is, lines);
  std::set<std::string> paths;
  for (const auto* files : {&then.agent.files, &now.agent.files}) {
    for (const auto& [path, digest] : *files) paths.insert(path);
  }
  for (const std::string& path : paths) {
    const auto old = then.agent.files.find(path), present = now.agent.files.find(path);
    if (old == then.agent.files.end()) {
      lines.push_back("agent.files: " + path + " was not there then");
    } else if (present == now.agent.files.end()) {
      lines.push_back("agent.files: " + path + " is not there now");
    } else if (old->second != present->second) {
      lines.push_back("agent.files: " + path + " has changed");
    }
  }
  return lines;
}

}  // namespace unietp
