#include "data_set.h"

#include <gtest/gtest.h>

#include "core/digest.h"
#include "core/files.h"
#include "core/text.h"
#include "record/home_cache.h"
#include "scene/scene_json.h"
#include "schema_checker.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string bytes_of(const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  EXPECT_TRUE(bytes) << file;
  return bytes ? *bytes : std::string();
}

}  // namespace

std::vector<std::string> small_options(const std::string& out) {
  return {"generate", "--count", std::to_string(kSmallCount), "--seed", "7", "--rooms", "5", "--objects", "25",
          "--out",    out};
}

const std::filesystem::path& small_data_set() {
  static const ScratchFolder kScratch;
  static const std::filesystem::path kFolder = [] {
    auto options = small_options(kScratch.at("small"));
    options.insert(options.end(), {"--threads", "2"});
    const auto ended = run_program(options);
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
    return std::filesystem::path(kScratch.at("small"));
  }();
  return kFolder;
}

const std::filesystem::path& data_set_in_all_modes() {
  static const ScratchFolder kScratch;
  static const std::filesystem::path kFolder = [] {
    const auto ended = run_program({"generate", "--count", std::to_string(kCountInAllModes), "--seed", "17", "--rooms",
                                    "5", "--objects", "25", "--modes", "M2,M3", "--splits", "atomic,compositional",
                                    "--out", kScratch.at("modes"), "--threads", "2"});
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
    return std::filesystem::path(kScratch.at("modes"));
  }();
  return kFolder;
}

Verdict validate(const std::filesystem::path& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"validate", folder.string(), "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto ended = run_program(arguments);
  Verdict verdict;
  verdict.code = ended.code;
  const auto json = Json::parse(ended.out, nullptr, false);
  EXPECT_TRUE(json.is_object()) << ended.out << ended.err;
  if (!json.is_object()) return verdict;
  EXPECT_EQ(SchemaChecker().check(json, "validation.schema.json"), "");
  verdict.tasks = json["tasks"];
  verdict.proven = json["proven"];
  for (const auto& problem : json["problems"])
    verdict.problems.push_back({problem["kind"], problem["task"], problem["where"], problem["message"]});
  return verdict;
}

std::vector<Json> json_lines(const std::filesystem::path& file) {
  std::vector<Json> lines;
  for (const auto& line : split(bytes_of(file), '\n')) {
    if (!line.empty()) lines.push_back(Json::parse(line));
  }
  return lines;
}

Scene start_of(const std::filesystem::path& folder, const Json& task) {
  const auto changes = delta_from_json("changes", task["start"]["changes"]);
  EXPECT_TRUE(changes) << format(changes.error());
  const auto start = HomeCache(folder).start("changes", task["layout"], *changes, task["scene"]);
  EXPECT_TRUE(start) << format(start.error());
  return start ? *start : Scene();
}

Json start_json(const std::filesystem::path& folder, const Json& task) {
  return Json::parse(scene_to_json(start_of(folder, task)));
}

DamagedCopy::DamagedCopy() : DamagedCopy(small_data_set()) {}

DamagedCopy::DamagedCopy(const std::filesystem::path& original) : folder_(scratch_.at("copy")) {
  std::filesystem::copy(original, folder_, std::filesystem::copy_options::recursive);
}

std::string DamagedCopy::read(const std::string& file) const { return bytes_of(folder_ / file); }

void DamagedCopy::write(const std::string& file, const std::string& bytes) const {
  EXPECT_TRUE(write_file(folder_ / file, bytes));
}

void DamagedCopy::vouch() const {
  auto manifest = Json::parse(read("manifest.json"));
  for (auto& file : manifest["files"]) {
    const auto bytes = read(file["path"].get<std::string>());
    file["bytes"] = bytes.size();
    file["sha256"] = sha256(bytes);
  }
  write("manifest.json", manifest.dump(2) + "\n");
}

}  // namespace unietp
