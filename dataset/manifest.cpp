#include "dataset/manifest.h"

#include <set>

#include <nlohmann/json.hpp>

#include "akb/csv.h"
#include "core/file_digest.h"
#include "core/files.h"
#include "core/version.h"
#include "dataset/configuration_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

void collect_sources(const Knowledge& knowledge, std::set<std::string>& sources) {
  for (const auto& category : knowledge.categories()) {
    for (const auto* source : {&category.source, &category.size_source, &category.mass_source})
      sources.insert(source->source);
  }
  for (const auto& fact : knowledge.affordances()) sources.insert(fact.source.source);
  for (const auto& placement : knowledge.placements()) sources.insert(placement.source.source);
  for (const auto& effect : knowledge.effects()) sources.insert(effect.source.source);
  for (const auto& alias : knowledge.aliases()) sources.insert(alias.source.source);
}

Json counts_json(const std::map<std::string, int>& counts) {
  Json json = Json::object();
  for (const auto& [name, count] : counts) json[name] = count;
  return json;
}

/// A list, since a strict reader takes no object with as many fields as there are templates.
Json list_json(const char* name, const std::map<std::string, int>& counts) {
  Json json = Json::array();
  for (const auto& [value, count] : counts) json.push_back({{name, value}, {"tasks", count}});
  return json;
}

Json writing_json(const WritingEntry& writing) {
  Json json{{"writer", writing.writer}};
  if (writing.seed) json["seed"] = *writing.seed;
  json["phrasings"] = writing.phrasings;
  json["english"] = writing.english;
  json["counts"] = Json::array();
  for (const auto& [writer, tasks] : writing.counts) json["counts"].push_back({{"writer", writer}, {"tasks", tasks}});
  if (writing.pairs) json["pairs"] = {{"wordings", writing.pairs->wordings}, {"contrasts", writing.pairs->contrasts}};
  return json;
}

}  // namespace

Result<std::vector<SourceLicense>> sources_of(const RunConfiguration& configuration, const Resources& resources,
                                              const fs::path& table) {
  const auto text = read_file(table);
  if (!text) return text.error();
  const auto csv = read_csv(table.string(), *text);
  if (!csv.errors.empty()) return csv.errors.front();
  constexpr std::size_t kColumns = 3;  // source (a prefix), origin, license
  if (csv.header.size() != kColumns)
    return Error{Error::Kind::Schema, table.string(), {1, 1}, "expected the columns source,origin,licence"};

  std::set<std::string> sources;
  for (const auto simulator : configuration.simulators)
    collect_sources(resources.backend(simulator).knowledge, sources);
  std::vector<SourceLicense> found;
  for (const auto& source : sources) {
    const CsvRow* best = nullptr;
    for (const auto& row : csv.rows) {
      const bool matches = source.compare(0, row[0].text.size(), row[0].text) == 0;
      if (matches && (best == nullptr || row[0].text.size() > (*best)[0].text.size())) best = &row;
    }
    if (best == nullptr)
      return Error{Error::Kind::Schema,
                   table.string(),
                   {},
                   "has no row for the source \"" + source + "\"; add one with its origin and licence"};
    found.push_back({source, (*best)[1].text, (*best)[2].text});
  }
  return found;
}

Result<std::map<std::string, FileEntry>> files_below(const fs::path& folder) {
  std::map<std::string, FileEntry> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    auto digest = digest_of_file(entry.path());
    if (!digest) return digest.error();
    files[fs::relative(entry.path(), folder).generic_string()] = {digest->bytes, std::move(digest->sha256)};
  }
  return files;
}

std::string benchmark_of(const std::map<std::string, FileEntry>& files, const FrozenBenchmarks& frozen) {
  std::map<std::string, std::string> digests;
  for (const auto& [path, file] : files) digests[path] = file.sha256;
  return frozen.name_of(dataset_digest(digests));
}

std::string to_text(const Manifest& manifest) {
  const DatasetCounts& counts = manifest.counts;
  int candidates = counts.tasks;
  Json rejections = Json::object();
  for (const auto& [stage, reasons] : counts.rejections) {
    rejections[stage] = counts_json(reasons);
    for (const auto& [reason, count] : reasons) candidates += count;
  }
  Json balance = Json::array();
  for (const auto& spread : counts.balance)
    balance.push_back({{"dimension", name_of(spread.dimension)},
                       {"values", spread.values},
                       {"effective", spread.effective},
                       {"variation", spread.variation}});
  Json files = Json::array();
  for (const auto& [path, file] : manifest.files)
    files.push_back({{"path", path}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  Json licenses = Json::array();
  for (const auto& source : manifest.sources)
    licenses.push_back({{"source", source.source}, {"origin", source.origin}, {"licence", source.license}});
  Json json{{"format", "unietp-manifest/1"},
            {"program", {{"name", "unietp"}, {"version", manifest.version}}},
            {"knowledge_digest", manifest.knowledge_digest},
            {"seed", manifest.configuration.seed},
            {"configuration", to_json(manifest.configuration)},
            {"counts",
             {{"tasks", counts.tasks},
              {"candidates", candidates},
              {"by_split", counts_json(counts.by_split)},
              {"by_simulator", counts_json(counts.by_simulator)},
              {"by_template", list_json("template", counts.by_template)},
              {"by_sense", counts_json(counts.by_sense)},
              {"by_form", counts_json(counts.by_form)},
              {"not_usual", list_json("template", counts.not_usual)},
              {"balance", std::move(balance)},
              {"rejections", std::move(rejections)}}},
            {"files", std::move(files)},
            {"sources", std::move(licenses)}};
  if (!manifest.benchmark.empty()) json["benchmark"] = manifest.benchmark;
  if (manifest.writing) json["instructions"] = writing_json(*manifest.writing);
  if (const auto& reviews = manifest.reviews)
    json["reviews"] = {{"accepted", reviews->accepted}, {"rejected", reviews->rejected}, {"edited", reviews->edited}};
  return json.dump(2) + "\n";
}

}  // namespace unietp
