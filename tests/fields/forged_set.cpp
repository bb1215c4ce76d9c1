#include "forged_set.h"

#include <memory>

#include <gtest/gtest.h>

#include "cli/full_validation.h"
#include "core/digest.h"
#include "core/files.h"
#include "core/sqlite_file.h"
#include "data_set.h"
#include "program.h"
#include "resources/resources.h"
#include "validator/lazy_values.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

DataFolders committed_folders() {
  DataFolders folders;
  folders.root = UNIETP_SOURCE_DIR;
  folders.cache = fs::temp_directory_path();
  return folders;
}

/// All that `validate` looks at. Homes are made once, as most forgeries are not of them.
ValidationOptions options_of_validation(ProofMemory& memory) {
  const auto folders = committed_folders();
  auto options = full_validation(library(), folders);
  EXPECT_TRUE(options) << format(options.error());
  options->memory = &memory;
  options->make_home = [make = options->make_home, homes = std::make_shared<LazyValues<Result<Scene>>>()](
                           const ManifestRecord& manifest, const std::string& name) {
    return *homes->get(manifest.run.text + name, [&] { return make(manifest, name); });
  };
  return std::move(*options);
}

void expect_success(const Ended& ended) { EXPECT_EQ(ended.code, 0) << ended.out << ended.err; }

/// Accepts, takes out and edits a task each; the new text is the one that the paired wordings have.
std::string review_of(const fs::path& folder) {
  const auto tasks = json_lines(folder / "tasks.jsonl"), wordings = json_lines(folder / "wordings.jsonl");
  Json reviews = Json::array();
  const auto add = [&](std::size_t i, const char* verdict, const char* comment) {
    reviews.push_back({{"task", tasks.at(i)["id"]},
                       {"verdict", verdict},
                       {"instruction", tasks.at(i)["instruction"]["text"]},
                       {"comment", comment}});
  };
  add(0, "accept", "good");
  add(1, "reject", "dull");
  for (std::size_t i = 2; i < tasks.size(); ++i) {
    const auto& text = wordings.at(i)["direct"]["text"];
    if (tasks[i]["instruction"]["style"] != "direct" || tasks[i]["instruction"]["text"] == text) continue;
    add(i, "edit", "clearer");
    reviews.back()["text"] = text;
    break;
  }
  const auto bytes = read_file(folder / "tasks.jsonl");
  return Json{{"format", "unietp-review/1"}, {"set", "set"}, {"tasks_sha256", sha256(*bytes)}, {"reviews", reviews}}
      .dump();
}

void make(const fs::path& folder, const ScratchFolder& scratch) {
  expect_success(run_program({"generate", "--count", "20", "--seed", "23", "--rooms", "5", "--objects", "25", "--modes",
                              "M2,M3", "--out", folder.string(), "--threads", "2"}));
  expect_success(run_program({"annotate", folder.string(), "--contrasts", "--wordings", "3", "--seed", "9"}));
  const std::string reviews = scratch.at("review.json");
  EXPECT_TRUE(write_file(reviews, review_of(folder)));
  expect_success(run_program({"review", folder.string(), "--apply", reviews}));
}

}  // namespace

const Resources& library() {
  static const ResourcesReading kReading = [] { return load_resources(committed_folders()); }();
  return kReading.resources;
}

ForgedSet::ForgedSet() : folder_(scratch_.at("set")), options_(options_of_validation(memory_)) {
  make(folder_, scratch_);
  bytes_ = bytes_below(folder_);
  for (const auto& [file, bytes] : bytes_) {
    const auto text = read_maybe_gzip(folder_ / file);
    texts_[file] = text ? *text : bytes;
  }
}

std::vector<std::string> ForgedSet::files() const {
  std::vector<std::string> all;
  for (const auto& [file, unused] : texts_) all.push_back(file);
  return all;
}

void ForgedSet::write(const std::string& file, const std::string& bytes) const {
  EXPECT_TRUE(write_file(folder_ / file, bytes));
}

std::string ForgedSet::vouching_for(const std::string& file, const std::string& bytes) const {
  auto manifest = Json::parse(bytes_.at("manifest.json"));
  for (auto& one : manifest["files"]) {
    if (one["path"] != file) continue;
    one["bytes"] = bytes.size();
    one["sha256"] = sha256(bytes);
  }
  return manifest.dump(2) + "\n";
}

ValidationReport ForgedSet::validated() {
  const Resources& resources = library();
  std::vector<ValidationBackend> backends;
  for (const auto& backend : resources.backends) backends.push_back({&backend.knowledge, &backend.profile});
  return validate_dataset(folder_, backends, resources.digest, options_);
}

ValidationReport ForgedSet::with(const std::string& file, const std::string& text) {
  return with_bytes(file, file.ends_with(".gz") ? gzip(text) : text);
}

ValidationReport ForgedSet::with_bytes(const std::string& file, const std::string& bytes) {
  write(file, bytes);
  if (file != "manifest.json") write("manifest.json", vouching_for(file, bytes));
  auto report = validated();
  write(file, bytes_.at(file));
  write("manifest.json", bytes_.at("manifest.json"));
  return report;
}

ValidationReport ForgedSet::with_database(const std::string& sql) {
  const std::string file = "dataset.sqlite";
  const fs::path forged = scratch_.at("forged.sqlite");
  EXPECT_TRUE(write_file(forged, bytes_.at(file)));
  {
    SqliteFile database(forged, SqliteFile::Mode::Create);
    database.run(sql.c_str());
  }
  const auto bytes = read_file(forged);
  return with_bytes(file, bytes ? *bytes : "");
}

ValidationReport ForgedSet::unchanged() { return validated(); }

ForgedSet& forged_set() {
  static ForgedSet set;
  return set;
}

}  // namespace unietp
