#include "validator/manifest_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "core/digest.h"
#include "core/files.h"
#include "scene/json_parse.h"
#include "scene/json_reader.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kManifest = "manifest.json";

struct Manifest {
  std::string knowledge_digest;
  int tasks = -1;
  std::map<std::string, std::string> sha256_of;  // by path
};

Error wrong(std::string_view file, std::string message) {
  return {Error::Kind::Schema, std::string(file), {}, std::move(message)};
}

std::map<std::string, std::string> read_files(JsonReader& reader, const JsonAt& at) {
  std::map<std::string, std::string> files;
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    JsonFields fields(reader, item);
    std::string path, digest;
    if (const auto f = fields.required("path")) path = reader.text(*f);
    if (const auto f = fields.required("bytes")) (void)reader.number(*f);
    if (const auto f = fields.required("sha256")) digest = reader.text(*f);
    fields.finish();
    if (!files.emplace(path, digest).second) reader.fail(item, in_quotes(path) + " is listed twice");
  }
  return files;
}

Result<Manifest> read_manifest(std::string_view text) {
  const auto json = parse_json(kManifest, text);
  if (!json) return json.error();
  JsonReader reader(kManifest);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  Manifest manifest;
  if (const auto f = fields.required("format")) {
    if (const auto format = reader.text(*f); format != "unietp-manifest/1")
      reader.fail(*f, "expected the format \"unietp-manifest/1\", not " + in_quotes(format));
  }
  if (const auto f = fields.required("knowledge_digest")) manifest.knowledge_digest = reader.text(*f);
  if (const auto f = fields.required("counts")) {
    JsonFields counts(reader, *f);
    if (const auto tasks = counts.required("tasks")) {
      const double count = reader.number(*tasks);
      const bool whole = count >= 0 && count <= 1e9 && count == std::floor(count);
      if (!whole) reader.fail(*tasks, "expected a whole number from 0 to 1e9");
      if (whole) manifest.tasks = static_cast<int>(count);
    }
  }
  if (const auto f = fields.required("files")) manifest.sha256_of = read_files(reader, *f);
  for (const auto* name : {"program", "seed", "configuration", "sources"}) (void)fields.required(name);
  (void)fields.optional("instructions");
  fields.finish();
  if (reader.error()) return *reader.error();
  return manifest;
}

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code code;
  for (auto it = fs::recursive_directory_iterator(folder, code); !code && it != fs::recursive_directory_iterator();
       it.increment(code)) {
    if (it->is_regular_file(code)) names.push_back(fs::relative(it->path(), folder).generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

ManifestCheck check_manifest(const fs::path& folder, std::string_view knowledge_digest) {
  ManifestCheck check;
  const auto text = read_file(folder / kManifest);
  if (!text) return {-1, {text.error()}};
  const auto manifest = read_manifest(*text);
  if (!manifest) return {-1, {manifest.error()}};
  check.tasks = manifest->tasks;
  if (manifest->knowledge_digest != knowledge_digest)
    check.errors.push_back(
        wrong(kManifest, "was made with other tables, profiles, layouts or templates (digest " +
                             manifest->knowledge_digest.substr(0, 12) + ") than those in use (digest " +
                             std::string(knowledge_digest.substr(0, 12)) + "); give the right ones with --data"));
  const auto present = files_in(folder);
  for (const auto& [path, digest] : manifest->sha256_of) {
    if (!std::binary_search(present.begin(), present.end(), path)) {
      check.errors.push_back(wrong(path, "is listed in the manifest but missing"));
      continue;
    }
    const auto bytes = read_file(folder / path);
    if (!bytes) {
      check.errors.push_back(bytes.error());
    } else if (sha256(*bytes) != digest) {
      check.errors.push_back(wrong(path, "its bytes differ from those the manifest vouches for (SHA-256)"));
    }
  }
  for (const auto& path : present) {
    if (path != kManifest && manifest->sha256_of.count(path) == 0)
      check.errors.push_back(wrong(path, "is not listed in the manifest"));
  }
  return check;
}

}  // namespace unietp
