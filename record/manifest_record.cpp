#include "record/manifest_record.h"

#include <nlohmann/json.hpp>

#include "record/record_fields.h"
#include "scene/json_parse.h"
#include "scene/json_reader.h"

namespace unietp {
namespace {

/// `{"atomic": 42, …}`
std::map<std::string, int> read_shares(JsonReader& reader, const JsonAt& at) {
  std::map<std::string, int> shares;
  JsonFields fields(reader, at);
  if (reader.error()) return shares;
  for (const auto& [name, count] : at.json.items()) {
    if (const auto f = fields.required(name)) shares[name] = read_whole(reader, *f);
  }
  return shares;
}

std::vector<Mode> read_modes(JsonReader& reader, const JsonAt& at) {
  std::vector<Mode> modes;
  for (std::size_t i = 0; i < reader.items(at) && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    const auto name = reader.text(item);
    const auto mode = mode_named(name);
    if (mode) modes.push_back(*mode);
    if (!mode) reader.unknown_name(item, "mode", {"M1", "M2", "M3"});
  }
  return modes;
}

void read_run(JsonReader& reader, const JsonAt& at, RecordedRun& run) {
  JsonFields fields(reader, at);
  read_format(reader, fields, "unietp-run/1");
  if (const auto f = fields.required("seed")) run.seed = read_seed(reader, *f);
  if (const auto f = fields.required("count")) run.count = read_whole(reader, *f);
  if (const auto f = fields.required("simulators")) run.simulators = reader.texts(*f);
  if (const auto f = fields.required("splits")) run.splits = reader.texts(*f);
  if (const auto f = fields.required("templates")) run.templates = reader.texts(*f);
  if (const auto f = fields.optional("without")) run.without = reader.texts(*f);
  if (const auto f = fields.required("modes")) run.modes = read_modes(reader, *f);
  if (const auto f = fields.required("phrasings")) run.phrasings = reader.text(*f);
  if (const auto f = fields.required("homes")) run.homes = reader.text(*f);
  if (const auto f = fields.optional("quotas")) {
    JsonFields quotas(reader, *f);
    if (const auto own = quotas.required("splits")) run.by_split = read_shares(reader, *own);
    if (const auto own = quotas.required("simulators")) run.by_simulator = read_shares(reader, *own);
    quotas.finish();
  }
  for (const auto* name : {"extended", "own", "binding", "attempts", "block", "rooms", "objects", "scenes"})
    (void)fields.optional(name);  // how tasks were made, which leaves nothing to be counted
  fields.finish();
}

void read_by_template(JsonReader& reader, const JsonAt& at, std::map<std::string, int>& counts) {
  for (std::size_t i = 0; i < reader.items(at) && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields fields(reader, item);
    std::string name;
    if (const auto f = fields.required("template")) name = reader.text(*f);
    if (const auto f = fields.required("tasks")) counts[name] = read_whole(reader, *f);
    fields.finish();
  }
}

std::vector<RecordedSpread> read_balance(JsonReader& reader, const JsonAt& at) {
  std::vector<RecordedSpread> spreads;
  for (std::size_t i = 0; i < reader.items(at) && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields fields(reader, item);
    RecordedSpread spread;
    if (const auto f = fields.required("dimension")) spread.dimension = reader.text(*f);
    if (const auto f = fields.required("values")) spread.values = read_whole(reader, *f);
    if (const auto f = fields.required("effective")) spread.effective = reader.number(*f);
    if (const auto f = fields.required("variation")) spread.variation = reader.number(*f);
    fields.finish();
    spreads.push_back(std::move(spread));
  }
  return spreads;
}

void read_counts(JsonReader& reader, const JsonAt& at, ManifestRecord& manifest) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("tasks")) manifest.tasks = read_whole(reader, *f);
  if (const auto f = fields.required("candidates")) manifest.candidates = read_whole(reader, *f);
  if (const auto f = fields.required("by_split")) manifest.by_split = read_shares(reader, *f);
  if (const auto f = fields.required("by_simulator")) manifest.by_simulator = read_shares(reader, *f);
  if (const auto f = fields.required("by_template")) read_by_template(reader, *f, manifest.by_template);
  if (const auto f = fields.optional("balance")) manifest.balance = read_balance(reader, *f);
  if (const auto f = fields.required("rejections")) {
    JsonFields stages(reader, *f);
    if (!reader.error()) {
      for (const auto& [stage, reasons] : f->json.items()) {
        const auto own = stages.required(stage);
        if (!own) continue;
        for (const auto& [reason, count] : read_shares(reader, *own)) manifest.rejections[stage + " " + reason] = count;
      }
    }
  }
  fields.finish();
}

void read_files(JsonReader& reader, const JsonAt& at, ManifestRecord& manifest) {
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields fields(reader, item);
    std::string path;
    RecordedFile file;
    if (const auto f = fields.required("path")) path = reader.text(*f);
    if (const auto f = fields.required("bytes")) file.bytes = reader.number(*f);
    if (const auto f = fields.required("sha256")) file.sha256 = reader.text(*f);
    fields.finish();
    if (!manifest.files.emplace(path, std::move(file)).second) reader.fail(item, in_quotes(path) + " is listed twice");
  }
}

}  // namespace

Result<ManifestRecord> read_manifest(std::string_view where, std::string_view text) {
  const auto json = parse_json(where, text);
  if (!json) return json.error();
  JsonReader reader(where);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  ManifestRecord manifest;
  read_format(reader, fields, "unietp-manifest/1");
  if (const auto f = fields.required("knowledge_digest")) manifest.knowledge_digest = reader.text(*f);
  if (const auto f = fields.required("configuration")) read_run(reader, *f, manifest.run);
  manifest.phrasings = manifest.run.phrasings;
  if (const auto f = fields.required("seed"); f && !reader.error()) {
    if (read_seed(reader, *f) != manifest.run.seed && !reader.error())
      reader.fail(*f, "is not the seed of the configuration");
  }
  if (const auto f = fields.optional("instructions")) {
    manifest.phrasings = "all";
    JsonFields own(reader, *f);
    if (const auto set = own.optional("phrasings")) manifest.phrasings = reader.text(*set);
    for (const auto* name : {"writer", "counts"}) (void)own.required(name);
    (void)own.optional("seed");
    own.finish();
  }
  if (const auto f = fields.required("counts")) read_counts(reader, *f, manifest);
  if (const auto f = fields.required("files")) read_files(reader, *f, manifest);
  for (const auto* name : {"program", "sources"}) (void)fields.required(name);
  fields.finish();
  if (reader.error()) return *reader.error();
  return manifest;
}

}  // namespace unietp
