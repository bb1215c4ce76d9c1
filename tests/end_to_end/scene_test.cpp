// The `unietp scene` commands of the real program: homes are made, drawn and measured; bad input is told and leaves
// nothing behind.
#include <signal.h>

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "program.h"
#include "schema_checker.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using Json = nlohmann::ordered_json;

std::vector<std::string> make_two(const std::string& out, const std::string& threads) {
  return {"scene",   "make", "--simulator", "habitat", "--rooms", "4", "--objects", "60",
          "--count", "2",    "--seed",      "5",       "--out",   out, "--threads", threads};
}

Json unpacked(const fs::path& file) {
  const auto text = read_maybe_gzip(file);
  EXPECT_TRUE(text) << file;
  return text ? Json::parse(*text, nullptr, false) : Json();
}

TEST(SceneMake, GivesTheSameBytesWithAnyNumberOfThreads) {
  ScratchFolder folder;
  const auto one = run_program(make_two(folder.at("one"), "1"));
  const auto two = run_program(make_two(folder.at("two"), "2"));
  ASSERT_EQ(one.code, 0) << one.err;
  ASSERT_EQ(two.code, 0) << two.err;
  const auto files = bytes_below(folder.at("one"));
  EXPECT_EQ(files.size(), 2U);
  EXPECT_EQ(files, bytes_below(folder.at("two")));
  SchemaChecker schemas;
  for (const auto& [name, bytes] : files)
    EXPECT_EQ(schemas.check(unpacked(folder.path() / "one" / name), "scene.schema.json"), "");
}

TEST(SceneMake, AHomeDoesNotDependOnHowManyAreAskedFor) {
  ScratchFolder folder;
  auto more = make_two(folder.at("more"), "2");
  more[9] = "3";
  ASSERT_EQ(run_program(make_two(folder.at("two"), "2")).code, 0);
  ASSERT_EQ(run_program(more).code, 0);
  auto files = bytes_below(folder.at("more"));
  EXPECT_EQ(files.erase("habitat-sized-5-2.scene.json.gz"), 1U);
  EXPECT_EQ(files, bytes_below(folder.at("two")));
}

TEST(SceneMake, TellsWhatItMadeToScripts) {
  ScratchFolder folder;
  auto options = make_two(folder.at("out"), "2");
  options.emplace_back("--json");
  const auto ended = run_program(options);
  const auto json = Json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ended.out;
  ASSERT_EQ(json["scenes"].size(), 2U);
  for (const auto& scene : json["scenes"]) {
    EXPECT_EQ(unpacked(folder.path() / "out" / scene["file"])["nodes"].size(), scene["objects"].get<std::size_t>());
  }
}

TEST(SceneMake, AnInterruptionLeavesWholeFilesOnly) {
  ScratchFolder folder;
  RunningProgram program({"scene", "make", "--simulator", "ai2thor", "--count", "100000", "--out", folder.at("out")});
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!fs::exists(folder.at("out/ai2thor-training-1-1.scene.json.gz")) &&
         std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  program.send(SIGINT);
  const auto ended = program.wait();
  EXPECT_EQ(ended.code, 130) << ended.err;
  const auto files = bytes_below(folder.at("out"));
  EXPECT_GE(files.size(), 2U);
  for (const auto& [name, bytes] : files) {
    EXPECT_THAT(name, Not(HasSubstr(".tmp")));
    EXPECT_TRUE(unpacked(folder.path() / "out" / name).is_object()) << name;
  }
}

class MadeHomes : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(run_program(make_two(folder_.at("homes"), "2")).code, 0); }
  std::string home(int n) const { return folder_.at("homes/habitat-sized-5-" + std::to_string(n) + ".scene.json.gz"); }
  ScratchFolder folder_;
};

TEST_F(MadeHomes, AreDrawn) {
  const auto ended = run_program({"scene", "show", home(0), "--out", folder_.at("home.svg")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto svg = read_file(folder_.at("home.svg"));
  ASSERT_TRUE(svg);
  EXPECT_THAT(*svg, HasSubstr("<svg"));
  for (const auto& room : unpacked(home(0))["rooms"])
    EXPECT_THAT(*svg, HasSubstr(replace_all(room["type"], "_", " "))) << room["id"];
}

TEST_F(MadeHomes, AreDrawnOneAtATime) {
  const auto which = run_program({"scene", "show", folder_.at("homes"), "--out", folder_.at("home.svg")});
  EXPECT_EQ(which.code, 2);
  EXPECT_THAT(which.err, HasSubstr("habitat-sized-5-0, habitat-sized-5-1"));
  EXPECT_FALSE(fs::exists(folder_.at("home.svg")));
  const auto named = run_program(
      {"scene", "show", folder_.at("homes"), "--home", "habitat-sized-5-1", "--out", folder_.at("home.svg")});
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_TRUE(fs::exists(folder_.at("home.svg")));
}

TEST_F(MadeHomes, AreNoDistanceFromThemselves) {
  const auto json = run_program({"scene", "stats", folder_.at("homes"), "--json"});
  ASSERT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(Json::parse(json.out)["homes"], 2);
  ASSERT_TRUE(write_file(folder_.at("statistics.json"), json.out));
  const auto same = run_program({"scene", "stats", folder_.at("homes"), folder_.at("statistics.json"), "--json"});
  ASSERT_EQ(same.code, 0) << same.err;
  const Json told = Json::parse(same.out);
  for (const auto& [part, value] : told["distance"].items()) EXPECT_NEAR(value, 0, 1e-3) << part;
  const auto other = run_program({"scene", "stats", home(0), home(1), "--json"});
  ASSERT_EQ(other.code, 0) << other.err;
  EXPECT_GT(Json::parse(other.out)["distance"]["small things"], 0.05);
}

TEST(SceneLibrary, IsListedAndMadeByName) {
  ScratchFolder folder;
  const auto listed = run_program({"scene", "list", "--json"});
  ASSERT_EQ(listed.code, 0) << listed.err;
  const auto layouts = Json::parse(listed.out);
  ASSERT_FALSE(layouts.empty());
  const auto id = layouts[0]["id"].get<std::string>();
  const auto made = run_program({"scene", "make", "--layout", id, "--out", folder.at("homes"), "--json"});
  ASSERT_EQ(made.code, 0) << made.err;
  const auto scene = unpacked(folder.at("homes/" + id + ".scene.json.gz"));
  EXPECT_EQ(scene["id"], id);
  EXPECT_EQ(scene["rooms"].size(), layouts[0]["rooms"].get<std::size_t>());
  const auto near = run_program({"scene", "make", "--layout", id + "x", "--out", folder.at("none")});
  EXPECT_EQ(near.code, 2);
  EXPECT_THAT(near.err, HasSubstr("did you mean \"" + id + "\""));
  EXPECT_FALSE(fs::exists(folder.at("none")));
}

TEST(SceneLibrary, IsComparedWithRealHomes) {
  ScratchFolder folder;
  const auto homes = folder.at("homes");
  ASSERT_EQ(run_program({"scene", "make", "--simulator", "ai2thor,habitat", "--out", homes}).code, 0);
  const auto compared =
      run_program({"scene", "stats", homes, "--simulator", "ai2thor", "--against", "reference", "--json"});
  ASSERT_EQ(compared.code, 0) << compared.err;
  const auto distance = Json::parse(compared.out)["distance"]["furniture"];
  EXPECT_GT(distance, 0);
  EXPECT_LT(distance, 0.5);
  const auto none = run_program({"scene", "stats", homes, "--simulator", "habitat", "--against", "reference"});
  EXPECT_EQ(none.code, 2);  // no real homes of Habitat may be shipped
  EXPECT_THAT(none.err, HasSubstr("reference_habitat.json"));
}

/// Everything that is refused: exit code 2, what is wrong in the message, and nothing left behind.
void expect_refused(const std::vector<std::string>& arguments, const std::string& message) {
  SCOPED_TRACE(join(arguments, " "));
  const auto ended = run_program(arguments);
  EXPECT_EQ(ended.code, 2) << ended.out << ended.err;
  EXPECT_THAT(ended.err, HasSubstr(message));
}

TEST(BadScenes, AreToldAndLeaveNothing) {
  ScratchFolder folder;
  const std::string out = folder.at("out"), whole(1000, 'x');
  ASSERT_TRUE(write_file(folder.at("cut.scene.json.gz"), gzip(whole).substr(0, 15)));
  ASSERT_TRUE(write_file(folder.at("not.scene.json"), "{\n  \"format\": \"unietp-scene/1\",\n  nodes"));
  ASSERT_TRUE(write_file(folder.at("file"), "not a folder"));
  fs::create_directories(folder.path() / "empty");
  const auto before = bytes_below(folder.path());

  expect_refused({"scene", "make", "--simulator", "ai2thorr", "--out", out}, "did you mean \"ai2thor\"");
  expect_refused({"scene", "make", "--out", out}, "--benchmark");
  expect_refused({"scene", "make", "--simulator", "ai2thor", "--benchmark", "--out", out}, "expected one of");
  expect_refused({"scene", "make", "--simulator", "ai2thor", "--rooms", "1", "--out", out}, "--rooms");
  expect_refused({"scene", "make", "--simulator", "ai2thor", "--out", "/proc/homes"}, "/proc/homes");
  expect_refused({"scene", "make", "--simulator", "ai2thor", "--out", folder.at("file/homes")},
                 "choose a folder that you can write to");
  for (const auto* command : {"show", "stats"}) {
    std::vector<std::string> options{"scene", command, ""};
    if (command == std::string("show")) options.insert(options.end(), {"--out", out});
    const auto with = [&](const std::string& input) {
      options[2] = folder.at(input);
      return options;
    };
    expect_refused(with("nowhere.scene.json"), "nowhere.scene.json: file error: cannot open for reading");
    expect_refused(with("cut.scene.json.gz"), "not a whole gzip file");
    expect_refused(with("not.scene.json"), "not.scene.json:3:4: ");
    expect_refused(with("empty"), "contains no scene");
  }
  expect_refused({"render", folder.at("not.scene.json"), "task", "--out", out}, "unietp scene show");
  EXPECT_EQ(bytes_below(folder.path()), before);
}

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

TEST(HomePage, ShowsSixHomesOfEachSimulatorFromAboveAndFromInside) {
  ScratchFolder folder;
  const auto ended = run_program({"scene", "report", "--out", folder.at("homes.html")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto page = read_file(folder.at("homes.html"));
  ASSERT_TRUE(page);
  EXPECT_EQ(times(*page, "<article"), 24U);
  EXPECT_EQ(times(*page, "<svg"), 24U);
  EXPECT_EQ(times(*page, "<img alt="), 96U);
  for (const std::string simulator : {"AI2-THOR", "VirtualHome", "Habitat", "BEHAVIOR"})
    EXPECT_EQ(times(*page, "<h2>" + simulator + "</h2>"), 1U);
  const auto again = run_program({"scene", "report", "--threads", "1", "--out", folder.at("again.html")});
  ASSERT_EQ(again.code, 0);
  const auto same = read_file(folder.at("again.html"));
  ASSERT_TRUE(same);
  EXPECT_TRUE(*same == *page);
}

TEST(HomePage, ShowsGivenHomesAndRefusesWhatIsNone) {
  ScratchFolder folder;
  ASSERT_EQ(run_program({"scene", "make", "--simulator", "ai2thor", "--rooms", "4", "--objects", "60", "--out",
                         folder.at("homes")})
                .code,
            0);
  const auto ended = run_program({"scene", "report", folder.at("homes"), "--views", "2", "--out", folder.at("a.html")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto page = read_file(folder.at("a.html"));
  EXPECT_EQ(times(*page, "<h3>ai2thor-sized-1-0 "), 1U);
  EXPECT_EQ(times(*page, "<img alt="), 2U);
  const auto refused = run_program({"scene", "report", folder.at("nowhere.json"), "--out", folder.at("b.html")});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, ::testing::HasSubstr("nowhere.json: file error"));
}

}  // namespace
}  // namespace unietp
