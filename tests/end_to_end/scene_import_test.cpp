// The simulators' own scene files through the real program: imported with a report, tasks made in them and proven, and
// written back. Bad files are told and lose no other home.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "program.h"
#include "schema_checker.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

const fs::path kHomes = fs::path(UNIETP_SOURCE_DIR) / "tests" / "end_to_end" / "homes";
const fs::path kUpstream = UNIETP_UPSTREAM_DIR;

struct Sample {
  std::string name, format, file;
  int homes = 1;
  std::vector<std::string> more = {};  // options
};
std::string name_of_sample(const ::testing::TestParamInfo<Sample>& info) { return info.param.name; }

/// What no import takes more memory than, however large the home (docs/limits.md).
constexpr std::size_t kMostMemory_bytes = std::size_t{2} << 30;

Json import_into(const std::string& out, const fs::path& file, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"scene", "import", "auto", file.string(), "--out", out, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto ended = run_program(arguments);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_LT(ended.peak_bytes, kMostMemory_bytes) << file;
  const auto json = Json::parse(ended.out, nullptr, false);
  EXPECT_EQ(SchemaChecker().check(json, "scene-importing.schema.json"), "");
  return json;
}

/// What stands in the folder is as its schema says.
void expect_sound(const Json& home, const std::string& folder) {
  SchemaChecker schemas;
  const auto id = home["id"].get<std::string>();
  const auto scene = read_maybe_gzip(folder + "/" + id + ".scene.json.gz");
  ASSERT_TRUE(scene);
  EXPECT_EQ(schemas.check(Json::parse(*scene), "scene.schema.json"), "");
  const auto report = read_file(folder + "/" + id + ".import.json");
  ASSERT_TRUE(report);
  EXPECT_EQ(schemas.check(Json::parse(*report), "import.schema.json"), "");
}

/// Makes tasks in the homes of a folder and proves them.
void expect_tasks_in(const std::string& homes, const std::string& out, int count) {
  const auto made = run_program({"generate", "--scenes", homes, "--count", std::to_string(count), "--splits", "atomic",
                                 "--seed", "3", "--out", out});
  EXPECT_EQ(made.code, 0) << made.out << made.err;
  const auto verdict = validate(out);
  EXPECT_EQ(verdict.code, 0);
  EXPECT_EQ(verdict.proven, count);
}

class SmallHomes : public ::testing::TestWithParam<Sample> {};

TEST_P(SmallHomes, ArriveWithAReportAndTasksAreMadeInThem) {
  const auto& sample = GetParam();
  ScratchFolder folder;
  const auto json = import_into(folder.at("homes"), kHomes / sample.file, sample.more);
  ASSERT_TRUE(json.is_object());
  ASSERT_EQ(json["homes"].size(), static_cast<std::size_t>(sample.homes)) << json;
  for (const auto& home : json["homes"]) {
    EXPECT_EQ(home["file_format"], sample.format);
    EXPECT_GT(home["counts"]["objects"], 4);
    EXPECT_EQ(home["counts"]["placed"], home["counts"]["known"]) << home;
    EXPECT_GE(home["counts"]["stayed"].get<int>() + 1, home["counts"]["known"].get<int>()) << home;
    EXPECT_EQ(home["counts"]["relations_held"], home["counts"]["relations"]) << home;
    expect_sound(home, folder.at("homes"));
  }
  expect_tasks_in(folder.at("homes"), folder.at("tasks"), 2);
}

INSTANTIATE_TEST_SUITE_P(
    EachFormat, SmallHomes,
    ::testing::Values(
        Sample{"ithor", "ithor", "kitchen.ithor.json"}, Sample{"procthor", "procthor", "houses.procthor.jsonl", 2},
        Sample{"virtualhome", "virtualhome", "flat.virtualhome.json"},
        Sample{"replicacad", "replicacad", "apartment.replicacad.scene_instance.json"},
        Sample{
            "hssd", "hssd", "flat.hssd.scene_instance.json", 1, {"--assets", (kHomes / "hssd_models.json").string()}},
        Sample{"behavior", "behavior", "small.behavior.json"}),
    name_of_sample);

TEST_P(SmallHomes, AreExaminedByTheDoctor) {
  const auto& sample = GetParam();
  std::vector<std::string> arguments{"scene", "doctor", (kHomes / sample.file).string(), "--json"};
  arguments.insert(arguments.end(), sample.more.begin(), sample.more.end());
  const auto ended = run_program(arguments);
  const auto json = Json::parse(ended.out, nullptr, false);
  EXPECT_EQ(SchemaChecker().check(json, "scene-doctor.schema.json"), "");
  ASSERT_EQ(json["homes"].size(), static_cast<std::size_t>(sample.homes)) << ended.out << ended.err;
  bool sound = true;
  for (const auto& home : json["homes"]) {
    EXPECT_EQ(home["file_format"], sample.format);
    sound = sound && home["faults"].empty();
  }
  EXPECT_EQ(ended.code, sound ? 0 : 1);
  arguments.erase(arguments.begin() + 3);  // --json
  const auto text = run_program(arguments);
  EXPECT_EQ(text.code, ended.code);
  EXPECT_THAT(text.out, HasSubstr(json["homes"][0]["id"].get<std::string>() + " (" + sample.format + ", "));
  EXPECT_EQ(text.out.find("faults of the home now\n  ") == std::string::npos, sound) << text.out;
}

TEST(Doctor, SaysWhatIsWrongWithAFileWhatWasDoneAndWhatIsLeft) {
  ScratchFolder folder;
  auto kitchen = Json::parse(*read_file(kHomes / "kitchen.ithor.json"));
  auto unknown = kitchen["objects"][1];
  unknown["objectId"] = "Flumbus|1";
  unknown["objectType"] = "Flumbus";
  kitchen["objects"].push_back(unknown);
  ASSERT_TRUE(write_file(folder.at("kitchen.json"), kitchen.dump()));
  const auto ended = run_program({"scene", "doctor", folder.at("kitchen.json")});
  EXPECT_THAT(ended.out, HasSubstr("1 unknown-category: left out\n           Flumbus|1 (Flumbus): "));
  EXPECT_EQ(ended.err, "");
}

TEST(Doctor, ExaminesAScenesOwnFileAsItIsAndWritesNothing) {
  ScratchFolder folder;
  ASSERT_EQ(run_program({"scene", "make", "--simulator", "ai2thor", "--rooms", "4", "--objects", "100", "--out",
                         folder.at("homes")})
                .code,
            0);
  const auto before = bytes_below(folder.path());
  const auto sound = run_program({"scene", "doctor", folder.at("homes")});
  EXPECT_EQ(sound.code, 0) << sound.out << sound.err;
  EXPECT_THAT(sound.out, HasSubstr("the home has no faults now"));
  EXPECT_EQ(bytes_below(folder.path()), before);
  const auto file = folder.at("homes/ai2thor-sized-1-0.scene.json.gz");
  auto scene = Json::parse(*read_maybe_gzip(file));
  std::string spoiled;
  std::set<std::string> standing;  // not in a drawer, where nothing can fall
  for (const auto& edge : scene["edges"])
    if (edge["relation"] == "on") standing.insert(edge["from"]);
  for (auto& node : scene["nodes"]) {
    if (!node["movable"].get<bool>() || !standing.contains(node["id"])) continue;
    node["position"][2] = node["position"][2].get<double>() + 0.3;
    spoiled = node["id"];
    break;
  }
  ASSERT_NE(spoiled, "");
  ASSERT_TRUE(write_file(folder.at("spoiled.scene.json"), scene.dump()));
  const auto ended = run_program({"scene", "doctor", folder.at("spoiled.scene.json"), "--json"});
  EXPECT_EQ(ended.code, 1);
  const auto json = Json::parse(ended.out, nullptr, false);
  EXPECT_EQ(SchemaChecker().check(json, "scene-doctor.schema.json"), "");
  ASSERT_FALSE(json["homes"][0]["faults"].empty());
  bool named = false;
  for (const auto& fault : json["homes"][0]["faults"])
    named = named || (fault["fault"] == "restless" && fault["object"] == spoiled);
  EXPECT_TRUE(named) << json;
}

TEST(ForeignScenes, AreDrawnAndMeasuredAsTheyAre) {
  ScratchFolder folder;
  const auto houses = (kHomes / "houses.procthor.jsonl").string();
  std::vector<std::string> show{"scene", "show", houses, "--out", folder.at("home.svg")};
  const auto which = run_program(show);
  EXPECT_EQ(which.code, 2);
  EXPECT_THAT(which.err, HasSubstr("choose a home with --home; it has 2: "));
  EXPECT_FALSE(fs::exists(folder.at("home.svg")));
  const auto id = import_into(folder.at("homes"), houses, {})["homes"][1]["id"].get<std::string>();
  show.insert(show.end(), {"--home", id});
  const auto drawn = run_program(show);
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(fs::exists(folder.at("home.svg")));
  const auto measured = run_program({"scene", "stats", houses, "--json"});
  ASSERT_EQ(measured.code, 0) << measured.err;
  EXPECT_EQ(Json::parse(measured.out)["homes"], 2);
}

TEST(ForeignScenes, GiveTheSameBytesWithAnyNumberOfThreads) {
  ScratchFolder folder;
  const auto houses = kHomes / "houses.procthor.jsonl";
  (void)import_into(folder.at("one"), houses, {"--threads", "1"});
  (void)import_into(folder.at("two"), houses, {"--threads", "2"});
  EXPECT_EQ(bytes_below(folder.at("one")).size(), 4U);
  EXPECT_EQ(bytes_below(folder.at("one")), bytes_below(folder.at("two")));
}

TEST(ForeignScenes, AreChosenById) {
  ScratchFolder folder;
  const auto houses = kHomes / "houses.procthor.jsonl";
  const auto all = import_into(folder.at("all"), houses, {"--no-settle"});
  const auto second = all["homes"][1]["id"].get<std::string>();
  const auto one = import_into(folder.at("one"), houses, {"--no-settle", "--homes", second});
  ASSERT_EQ(one["homes"].size(), 1U);
  EXPECT_EQ(one["homes"][0]["id"], second);
}

TEST(ForeignScenes, AreWrittenAndReadAgain) {
  ScratchFolder folder;
  for (const auto& [simulator, format] : {std::pair<std::string, std::string>{"ai2thor", "procthor"},
                                          {"virtualhome", "virtualhome"},
                                          {"habitat", "habitat"}}) {
    SCOPED_TRACE(format);
    ASSERT_EQ(run_program({"scene", "make", "--simulator", simulator, "--rooms", "4", "--objects", "60", "--out",
                           folder.at("homes")})
                  .code,
              0);
    const auto scene = folder.at("homes/" + simulator + "-sized-1-0.scene.json.gz");
    const auto file = folder.at(format + ".json.gz");
    const auto ended = run_program({"scene", "export", format, scene, "--out", file});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.out, "");
    const auto home = import_into(folder.at(format), file, {})["homes"][0];
    EXPECT_GE(home["counts"]["objects"], 30);
    EXPECT_EQ(home["counts"]["arrived"], home["counts"]["known"]) << home;
  }
}

TEST(ForeignScenes, AreNotWrittenOfAnotherSimulator) {
  ScratchFolder folder;
  ASSERT_EQ(run_program({"scene", "make", "--simulator", "habitat", "--rooms", "4", "--objects", "60", "--out",
                         folder.at("homes")})
                .code,
            0);
  const auto scene = folder.at("homes/habitat-sized-1-0.scene.json.gz");
  const auto other = run_program({"scene", "export", "procthor", scene, "--out", folder.at("house.json")});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("habitat"));
  const auto unknown = run_program({"scene", "export", "procthr", scene, "--out", folder.at("house.json")});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean \"procthor\""));
  EXPECT_FALSE(fs::exists(folder.at("house.json")));
}

class RealHomes : public ::testing::TestWithParam<Sample> {};

TEST_P(RealHomes, ArriveAndTasksAreMadeInThem) {
  const auto& sample = GetParam();
  if (!fs::exists(kUpstream / sample.file)) GTEST_SKIP() << needs::kSimulatorFiles;
  ScratchFolder folder;
  const auto json = import_into(folder.at("homes"), kUpstream / sample.file, sample.more);
  ASSERT_TRUE(json.is_object());
  ASSERT_EQ(json["homes"].size(), static_cast<std::size_t>(sample.homes)) << json;
  for (const auto& home : json["homes"]) {
    EXPECT_EQ(home["file_format"], sample.format);
    expect_sound(home, folder.at("homes"));
  }
  expect_tasks_in(folder.at("homes"), folder.at("tasks"), 2);
}

INSTANTIATE_TEST_SUITE_P(
    EachFormat, RealHomes,
    ::testing::Values(
        Sample{"ithor", "ithor", "ai2thor/ithor_scenes.json.gz", 2, {"--homes", "FloorPlan1,FloorPlan201"}},
        Sample{"virtualhome", "virtualhome", "virtualhome/scenes/TestScene3.json.gz"},
        Sample{"replicacad", "replicacad", "habitat/replicacad_scenes.json.gz", 1, {"--homes", "apt_0"}},
        Sample{"hssd", "hssd", "habitat/hssd_scene_102344193_boxes.json"},
        Sample{"behavior",
               "behavior",
               "behavior/scene_restaurant_brunch.json.gz",
               1,
               {"--assets", (kUpstream / "behavior/object_inventory.json.gz").string()}}),
    name_of_sample);

/// Damaged files: each is refused with what is wrong, and nothing is written, also of the sound file beside it.
class DamagedFiles : public ::testing::Test {
 protected:
  static std::string sound() { return (kHomes / "kitchen.ithor.json").string(); }
  static std::string text_of(const std::string& home) {
    const auto text = read_file(kHomes / home);
    EXPECT_TRUE(text);
    return text ? *text : std::string();
  }
  void expect_refused(const std::string& format, const std::string& file, const std::string& message) const {
    SCOPED_TRACE(format + " " + file);
    const auto ended = run_program({"scene", "import", format, sound(), file, "--out", folder_.at("out")});
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, HasSubstr(message));
    EXPECT_FALSE(fs::exists(folder_.at("out")));
    if (format != "auto") return;
    const auto doctor = run_program({"scene", "doctor", sound(), file});
    EXPECT_EQ(doctor.code, 2) << doctor.out;
    EXPECT_THAT(doctor.err, HasSubstr(message));
    EXPECT_EQ(doctor.out, "");
  }
  /// A home with one thing changed, as a file.
  std::string with(const std::string& home, const std::string& from, const std::string& to) const {
    const auto text = text_of(home);
    EXPECT_NE(text.find(from), std::string::npos) << home << " " << from;
    const auto file = folder_.at(home);
    EXPECT_TRUE(write_file(file, replace_all(text, from, to)));
    return file;
  }
  ScratchFolder folder_;
};

TEST_F(DamagedFiles, CutGzipMissingFileAndForeignTextAreNamed) {
  const auto packed = gzip(text_of("kitchen.ithor.json"));
  ASSERT_TRUE(write_file(folder_.at("cut.json.gz"), packed.substr(0, packed.size() / 2)));
  expect_refused("auto", folder_.at("cut.json.gz"), "cut.json.gz: parse error: not a whole gzip file");
  expect_refused("auto", folder_.at("nowhere.json"), "nowhere.json: file error");
  ASSERT_TRUE(write_file(folder_.at("notes.txt"), "milk, bread, two lemons"));
  expect_refused("auto", folder_.at("notes.txt"), "accepted are ithor, procthor");
  ASSERT_TRUE(write_file(folder_.at("none.json"), "[]"));
  expect_refused("procthor", folder_.at("none.json"), "none.json");
  expect_refused("ithr", sound(), "did you mean \"ithor\"");
  expect_refused("virtualhome", sound(), "kitchen.ithor.json");
}
TEST_F(DamagedFiles, PosesThatAreNoNumbersArePlaced) {
  expect_refused("auto", with("kitchen.ithor.json", "0.94", "NaN"), "kitchen.ithor.json:");
  expect_refused("auto", with("flat.virtualhome.json", "0.81", "1e999"), "flat.virtualhome.json");
  expect_refused("auto", with("apartment.replicacad.scene_instance.json", "0.757", "null"),
                 "apartment.replicacad.scene_instance.json");
  expect_refused("auto", with("houses.procthor.jsonl", "0.804", "\"high\""), "houses.procthor.jsonl");
  expect_refused("auto", with("small.behavior.json", "0.507", "-1e400"), "small.behavior.json");
}
TEST_F(DamagedFiles, AFolderThatCannotBeWrittenIsNamed) {
  const auto ended = run_program({"scene", "import", "auto", sound(), "--out", "/proc/homes"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("/proc/homes"));
  EXPECT_THAT(ended.err, HasSubstr("choose a folder that you can write to"));
}
TEST_F(DamagedFiles, AHomeThatCannotBeBuiltLosesNoOther) {
  ASSERT_TRUE(write_file(folder_.at("void.json"), R"({"sceneName":"FloorPlan2","objects":[]})"));
  const auto ended =
      run_program({"scene", "import", "ithor", folder_.at("void.json"), sound(), "--out", folder_.at("out"), "--json"});
  EXPECT_EQ(ended.code, 1) << ended.out << ended.err;
  const auto json = Json::parse(ended.out, nullptr, false);
  EXPECT_EQ(json["failed"].size(), 1U) << json;
  EXPECT_EQ(SchemaChecker().check(json, "scene-importing.schema.json"), "");
  EXPECT_THAT(ended.err, HasSubstr("FloorPlan2: "));
  EXPECT_TRUE(fs::exists(folder_.at("out/FloorPlan9.scene.json.gz")));
  EXPECT_FALSE(fs::exists(folder_.at("out/FloorPlan2.scene.json.gz")));
}

}  // namespace
}  // namespace unietp
