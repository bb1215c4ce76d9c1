#include "record/manifest_record.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/limits.h"
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
    if (mode && !modes.empty() && *mode <= modes.back()) reader.fail(item, "expected the modes in order, each once");
    if (mode) modes.push_back(*mode);
    if (!mode) reader.unknown_name(item, "mode", {"M1", "M2", "M3"});
  }
  return modes;
}

/// A list of names, each once.
std::vector<std::string> read_names(JsonReader& reader, const JsonAt& at) {
  auto names = reader.texts(at);
  auto sorted = names;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) reader.fail(at, in_quotes(*twice) + " is listed twice");
  return names;
}

std::string read_english(JsonReader& reader, const JsonAt& at) {
  std::string english = reader.text(at);
  if (english != "us" && english != "gb") reader.unknown_name(at, "english", {"us", "gb"});
  return english;
}

void read_run(JsonReader& reader, const JsonAt& at, RecordedRun& run) {
  JsonFields fields(reader, at);
  run.text = at.json.dump();
  read_format(reader, fields, "unietp-run/1");
  if (const auto f = fields.required("seed")) run.seed = read_seed(reader, *f);
  if (const auto f = fields.required("count")) run.count = read_whole(reader, *f);
  if (const auto f = fields.required("simulators")) run.simulators = read_names(reader, *f);
  if (const auto f = fields.required("splits")) run.splits = read_names(reader, *f);
  if (const auto f = fields.required("templates")) run.templates = reader.texts(*f);
  if (const auto f = fields.optional("without")) run.without = reader.texts(*f);
  if (const auto f = fields.required("modes")) run.modes = read_modes(reader, *f);
  if (const auto f = fields.required("phrasings")) run.phrasings = reader.text(*f);
  if (const auto f = fields.required("english")) run.english = read_english(reader, *f);
  if (const auto f = fields.required("sense")) run.sense = reader.text(*f);
  if (const auto f = fields.required("homes")) run.homes = reader.text(*f);
  if (const auto f = fields.optional("quotas")) {
    JsonFields quotas(reader, *f);
    if (const auto own = quotas.required("splits")) run.by_split = read_shares(reader, *own);
    if (const auto own = quotas.required("simulators")) run.by_simulator = read_shares(reader, *own);
    quotas.finish();
  }
  if (const auto f = fields.optional("extended")) run.extended = reader.boolean(*f);
  if (const auto f = fields.optional("native")) run.native = reader.boolean(*f);
  if (const auto f = fields.optional("own")) run.own = read_names(reader, *f);
  if (const auto f = fields.optional("binding")) run.binding = read_names(reader, *f);
  if (const auto f = fields.optional("scenes")) run.scenes = read_names(reader, *f);
  if (const auto f = fields.required("attempts")) run.attempts = read_whole(reader, *f);
  if (const auto f = fields.required("block")) run.block = read_whole(reader, *f);
  if (const auto f = fields.required("rooms")) run.rooms = read_whole(reader, *f);
  if (const auto f = fields.required("objects")) run.objects = read_whole(reader, *f);
  fields.finish();
}

void read_by_template(JsonReader& reader, const JsonAt& at, std::map<std::string, int>& counts) {
  for (std::size_t i = 0; i < reader.items(at) && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields fields(reader, item);
    std::string name;
    if (const auto f = fields.required("template")) name = reader.text(*f);
    if (!counts.empty() && name <= counts.rbegin()->first) reader.fail(item, "expected the templates in order of name");
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
  if (const auto f = fields.required("by_sense")) manifest.by_sense = read_shares(reader, *f);
  if (const auto f = fields.required("by_form")) manifest.by_form = read_shares(reader, *f);
  if (const auto f = fields.required("not_usual")) read_by_template(reader, *f, manifest.not_usual);
  if (const auto f = fields.optional("balance")) manifest.balance = read_balance(reader, *f);
  if (const auto f = fields.required("rejections")) {
    JsonFields stages(reader, *f);
    if (!reader.error()) {
      for (const auto& [stage, reasons] : f->json.items()) {
        const auto own = stages.required(stage);
        if (!own) continue;
        manifest.rejections[stage] = read_shares(reader, *own);
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
    if (const auto f = fields.required("path")) path = reader.line(*f);
    if (const auto f = fields.required("bytes")) file.bytes = read_seed(reader, *f);
    if (const auto f = fields.required("sha256")) file.sha256 = reader.text(*f);
    fields.finish();
    if (!manifest.files.empty() && path < manifest.files.rbegin()->first)
      reader.fail(item, "expected the files in order of path");
    if (!manifest.files.emplace(path, std::move(file)).second) reader.fail(item, in_quotes(path) + " is listed twice");
  }
}

RecordedWriting read_writing(JsonReader& reader, const JsonAt& at) {
  RecordedWriting writing;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("writer")) writing.writer = reader.text(*f);
  if (const auto f = fields.optional("seed")) writing.seed = read_seed(reader, *f);
  if (const auto f = fields.required("phrasings")) writing.phrasings = reader.text(*f);
  if (const auto f = fields.required("english")) writing.english = read_english(reader, *f);
  if (const auto f = fields.required("counts")) {
    for (std::size_t i = 0; i < reader.items(*f) && !reader.error(); ++i) {
      const JsonAt item = reader.item(*f, i);
      JsonFields own(reader, item);
      auto& [writer, tasks] = writing.counts.emplace_back();
      if (const auto name = own.required("writer")) writer = reader.text(*name);
      if (const auto count = own.required("tasks")) tasks = read_whole(reader, *count);
      own.finish();
    }
  }
  if (const auto f = fields.optional("pairs")) {
    JsonFields own(reader, *f);
    auto& pairs = writing.pairs.emplace();
    if (const auto wordings = own.required("wordings")) {
      pairs.wordings = read_whole(reader, *wordings);
      if (!reader.error() && (pairs.wordings < 2 || pairs.wordings > limits::kWordings))
        reader.fail(*wordings, "expected a number from 2 to " + std::to_string(limits::kWordings));
    }
    if (const auto contrasts = own.required("contrasts")) pairs.contrasts = reader.boolean(*contrasts);
    own.finish();
  }
  fields.finish();
  return writing;
}

RecordedReviews read_reviews(JsonReader& reader, const JsonAt& at) {
  RecordedReviews reviews;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("accepted")) reviews.accepted = read_whole(reader, *f);
  if (const auto f = fields.required("rejected")) reviews.rejected = read_whole(reader, *f);
  if (const auto f = fields.required("edited")) reviews.edited = read_whole(reader, *f);
  fields.finish();
  return reviews;
}

std::vector<RecordedSource> read_sources(JsonReader& reader, const JsonAt& at) {
  std::vector<RecordedSource> sources;
  for (std::size_t i = 0; i < reader.items(at) && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields fields(reader, item);
    RecordedSource source;
    if (const auto f = fields.required("source")) source.source = reader.text(*f);
    if (const auto f = fields.required("origin")) source.origin = reader.text(*f);
    if (const auto f = fields.required("licence")) source.license = reader.text(*f);
    fields.finish();
    sources.push_back(std::move(source));
  }
  return sources;
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
  if (const auto f = fields.optional("benchmark")) manifest.benchmark = reader.text(*f);
  if (const auto f = fields.required("configuration")) read_run(reader, *f, manifest.run);
  manifest.phrasings = manifest.run.phrasings;
  manifest.english = manifest.run.english;
  if (const auto f = fields.required("seed"); f && !reader.error()) {
    if (read_seed(reader, *f) != manifest.run.seed && !reader.error())
      reader.fail(*f, "is not the seed of the configuration");
  }
  if (const auto f = fields.optional("instructions")) {
    manifest.writing = read_writing(reader, *f);
    manifest.phrasings = manifest.writing->phrasings;
    manifest.english = manifest.writing->english;
  }
  if (const auto f = fields.optional("reviews")) manifest.reviews = read_reviews(reader, *f);
  if (const auto f = fields.required("counts")) read_counts(reader, *f, manifest);
  if (const auto f = fields.required("files")) read_files(reader, *f, manifest);
  if (const auto f = fields.required("program")) {
    JsonFields program(reader, *f);
    if (const auto name = program.required("name")) manifest.program_name = reader.text(*name);
    if (!reader.error() && manifest.program_name != "unietp") reader.fail(*f, "expected the program unietp");
    if (const auto version = program.required("version")) manifest.program_version = reader.text(*version);
    program.finish();
  }
  if (const auto f = fields.required("sources")) manifest.sources = read_sources(reader, *f);
  fields.finish();
  if (reader.error()) return *reader.error();
  return manifest;
}

Result<ManifestRecord> read_manifest_file(const std::filesystem::path& folder) {
  const auto text = read_file(folder, kManifest);
  if (!text) return text.error();
  return read_manifest((folder / kManifest).string(), *text);
}

bool records_extended_library(const std::filesystem::path& folder) {
  const auto manifest = read_manifest_file(folder);
  return manifest && manifest->run.extended;
}

}  // namespace unietp
