// The whole path: what the real program makes, and what it says of a data set that was tampered with.
#include <algorithm>
#include <set>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "schema_checker.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

TEST(DataSet, HoldsEverySimulatorAndSplitAndIsProven) {
  std::set<std::string> simulators, splits;
  for (const auto& task : json_lines(small_data_set() / "tasks.jsonl")) {
    simulators.insert(task["simulator"]);
    splits.insert(task["split"]);
  }
  EXPECT_EQ(simulators.size(), 4U);
  EXPECT_EQ(splits.size(), 5U);
  const auto verdict = validate(small_data_set());
  EXPECT_EQ(verdict.code, 0);
  EXPECT_EQ(verdict.tasks, kSmallCount);
  EXPECT_EQ(verdict.proven, kSmallCount);
  EXPECT_TRUE(verdict.problems.empty());
}

TEST(DataSet, HasTemptingPlansThatAreNoLongerThanTheDemonstrations) {
  int stored = 0;
  for (const auto& line : json_lines(small_data_set() / "demonstrations" / "M1.jsonl")) {
    if (!line.contains("tempting")) continue;
    ++stored;
    const auto& steps = line["steps"];
    const auto needed =
        std::count_if(steps.begin(), steps.end(), [](const Json& step) { return !step.contains("tidying"); });
    EXPECT_LE(static_cast<std::ptrdiff_t>(line["tempting"].size()), needed) << line["task"];
  }
  EXPECT_GT(stored, 0);
  const auto report = Json::parse(run_program({"validate", small_data_set().string(), "--json"}).out);
  EXPECT_EQ(report["constrained"], stored);
  const auto text = run_program({"validate", small_data_set().string()}).out;
  EXPECT_THAT(text,
              HasSubstr(" of " + std::to_string(stored) + " goals with constraints have a plan that forgets one"));
}

TEST(DataSet, HasFewWordsForEachPartOfAGoal) {
  const auto ended = run_program({"stats", small_data_set().string(), "--words"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto figure = [&](const std::string& label) {
    const auto at = ended.out.find(label);
    EXPECT_NE(at, std::string::npos) << ended.out;
    return at == std::string::npos ? 100.0 : std::stod(ended.out.substr(at + label.size()));
  };
  EXPECT_LE(figure("words for each part of the goal"), 9);
  EXPECT_LE(figure("more than 9 words for each part"), 5) << "percent";
}

TEST(DataSet, HasCarefulDemonstrations) {
  const auto ended = run_program({"stats", data_set_in_all_modes().string(), "--careful"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto of_m1 = ended.out.find("  M1: of "), of_m2 = ended.out.find("  M2: of "),
             of_m3 = ended.out.find("  M3: of ");
  ASSERT_LT(of_m1, of_m2) << ended.out;
  ASSERT_LT(of_m2, of_m3) << ended.out;
  const std::string in_m1 = ended.out.substr(of_m1, of_m2 - of_m1);
  for (const char* none :
       {"bystanders left elsewhere without need: 0", "devices in another room though a nearer one would do: 0",
        "things left open or on that could be set back: 0"})
    EXPECT_THAT(in_m1, ::testing::HasSubstr(none)) << ended.out;
  EXPECT_EQ(run_program({"stats", data_set_in_all_modes().string(), "--careful", "--json"}).code, 2);
}

TEST(DataSet, EveryFileFollowsItsSchema) {
  SchemaChecker checker;
  const std::vector<std::pair<std::string, std::string>> lines{{"tasks.jsonl", "task.schema.json"},
                                                               {"demonstrations/M1.jsonl", "demonstration.schema.json"},
                                                               {"rejections.jsonl", "rejection.schema.json"}};
  for (const auto& [file, schema] : lines) {
    for (const auto& json : json_lines(small_data_set() / file)) EXPECT_EQ(checker.check(json, schema), "") << file;
  }
  const auto manifest = read_file(small_data_set() / "manifest.json");
  ASSERT_TRUE(manifest);
  EXPECT_EQ(checker.check(Json::parse(*manifest), "manifest.schema.json"), "");
  for (const auto& entry : fs::directory_iterator(small_data_set() / "homes")) {
    const auto scene = read_maybe_gzip(entry.path());
    ASSERT_TRUE(scene);
    EXPECT_EQ(checker.check(Json::parse(*scene), "scene.schema.json"), "");
  }
}

TEST(DataSet, TheFunnelCountsEveryCandidate) {
  const auto text = read_file(small_data_set() / "manifest.json");
  ASSERT_TRUE(text);
  const auto counts = Json::parse(*text)["counts"];
  const auto rejections = json_lines(small_data_set() / "rejections.jsonl");
  EXPECT_EQ(counts["candidates"].get<std::size_t>(), counts["tasks"].get<std::size_t>() + rejections.size());
  EXPECT_EQ(counts["tasks"], kSmallCount);
}

TEST(Generate, ReportsTheSpreadOfItsTasksAsTheDataSetDoes) {
  const ScratchFolder scratch;
  const auto out = scratch.path() / "set";
  const auto ended = run_program({"generate", "--count", "12", "--seed", "5", "--simulators", "ai2thor", "--rooms", "5",
                                  "--objects", "40", "--json", "--out", out});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto report = Json::parse(ended.out);
  EXPECT_EQ(report["balance"], Json::parse(*read_file(out / "manifest.json"))["counts"]["balance"]);
  EXPECT_EQ(report["candidates"].get<std::size_t>(), 12 + json_lines(out / "rejections.jsonl").size());
}

/// A task that nobody can do in M3 is not made, and the last candidate's reason is told.
TEST(Generate, TellsWhyASlotStaysEmpty) {
  const ScratchFolder scratch;
  const auto ended =
      run_program({"generate", "--count", "1", "--simulators", "virtualhome", "--template", "read-one", "--extended",
                   "--modes", "M1,M3", "--rooms", "5", "--objects", "40", "--json", "--out", scratch.at("set")});
  EXPECT_EQ(ended.code, 1);
  const auto report = Json::parse(ended.out);
  ASSERT_EQ(report["unfilled"].size(), 1U);
  EXPECT_EQ(report["unfilled"][0]["what"], "atomic task on virtualhome");
  EXPECT_THAT(report["unfilled"][0]["last"].get<std::string>(), HasSubstr("not-in-m3"));
}

TEST(DataSet, OneThreadGivesTheSameBytes) {
  ScratchFolder folder;
  auto options = small_options(folder.at("one"));
  options.insert(options.end(), {"--threads", "1"});
  const auto ended = run_program(options);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(bytes_below(folder.at("one")), bytes_below(small_data_set()));
  EXPECT_FALSE(fs::exists(folder.at("one.partial")));
}

TEST(DataSet, AnotherSeedGivesOtherTasks) {
  ScratchFolder folder;
  const auto ended = run_program({"generate", "--count", "2", "--seed", "8", "--rooms", "5", "--objects", "25",
                                  "--simulators", "ai2thor", "--out", folder.at("other")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  for (const auto& task : json_lines(folder.path() / "other" / "tasks.jsonl"))
    EXPECT_THAT(bytes_below(small_data_set())["tasks.jsonl"],
                ::testing::Not(HasSubstr(task["instruction"]["text"].get<std::string>() + "\",\"writer")));
}

/// Width and height of a PNG file.
std::pair<int, int> size_of_png(const std::string& bytes) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = 256 * value + static_cast<unsigned char>(bytes.at(i));
    return value;
  };
  return {number(16), number(20)};
}

TEST(DataSet, ATaskIsPicturedInAnySizeByEveryCameraAndChannel) {
  const ScratchFolder folder;
  const auto task = json_lines(small_data_set() / "tasks.jsonl").front()["id"].get<std::string>();
  const auto render = [&](const std::string& out, std::vector<std::string> more) {
    more.insert(more.begin(), {"render", small_data_set().string(), task, "--out", folder.at(out)});
    return run_program(more);
  };
  std::set<std::string> pictures;
  for (const std::string camera : {"agent", "behind", "above"}) {
    for (const std::string channel : {"color", "depth", "normals", "instances"}) {
      SCOPED_TRACE(camera + " " + channel);
      const auto ended = render("one.png", {"--camera", camera, "--channel", channel, "--size", "96x64"});
      ASSERT_EQ(ended.code, 0) << ended.err;
      const auto bytes = *read_file(folder.at("one.png"));
      EXPECT_EQ(size_of_png(bytes), std::pair(96, 64));
      pictures.insert(bytes);
      EXPECT_EQ(ended.out.empty(), channel != "instances");
      EXPECT_EQ(ended.out.find(",agent\n") != std::string::npos, channel == "instances" && camera != "agent");
    }
  }
  EXPECT_EQ(pictures.size(), 12U);
  for (const std::string size : {"63x64", "64x1025", "64", "64x", "x64", "64x64x64", "-64x64", "64.5x64", "0x10"}) {
    const auto refused = render("no.png", {"--size", size});
    EXPECT_EQ(refused.code, 2) << size;
    EXPECT_THAT(refused.err, HasSubstr("--size"));
  }
  EXPECT_EQ(render("no.svg", {"--size", "64x64"}).code, 2);
  EXPECT_EQ(render("no.svg", {"--camera", "above"}).code, 2);
  EXPECT_EQ(render("no.png", {"--camera", "above", "--boxes"}).code, 2);
  EXPECT_EQ(render("no.png", {"--channel", "depth", "--boxes"}).code, 2);
  EXPECT_EQ(render("no.png", {"--camera", "below"}).code, 2);
  EXPECT_FALSE(fs::exists(folder.at("no.png")) || fs::exists(folder.at("no.svg")));
}

TEST(DataSet, ATaskIsDrawnFromAbove) {
  ScratchFolder folder;
  const auto task = json_lines(small_data_set() / "tasks.jsonl").front()["id"].get<std::string>();
  const auto ended = run_program({"render", small_data_set().string(), task, "--out", folder.at("task.svg")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto svg = read_file(folder.at("task.svg"));
  ASSERT_TRUE(svg);
  EXPECT_THAT(*svg, HasSubstr("<svg"));
  const auto seen = run_program(
      {"render", small_data_set().string(), task, "--out", folder.at("seen.png"), "--step", "2", "--boxes"});
  ASSERT_EQ(seen.code, 0) << seen.err;
  const auto picture = read_file(folder.at("seen.png"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->substr(1, 3), "PNG");
  const auto late =
      run_program({"render", small_data_set().string(), task, "--out", folder.at("no.png"), "--step", "99"});
  EXPECT_EQ(late.code, 2);
  EXPECT_THAT(late.err, HasSubstr("--step"));
  const auto last = std::string(trim(late.err.substr(late.err.rfind(' '))));  // "expected 1 to 7"
  const auto at_end =
      run_program({"render", small_data_set().string(), task, "--out", folder.at("end.png"), "--step", last});
  EXPECT_EQ(at_end.code, 0) << at_end.err;
  const auto unknown = run_program({"render", small_data_set().string(), "nobody", "--out", folder.at("no.svg")});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_FALSE(fs::exists(folder.at("no.svg")));

  // A demonstration that is not as it should be is refused at its line.
  const fs::path damaged = folder.path() / "damaged";
  fs::create_directories(damaged / "demonstrations");
  fs::copy(small_data_set() / "homes", damaged / "homes");
  fs::copy(small_data_set() / "tasks.jsonl", damaged / "tasks.jsonl");
  const std::string line = R"({"task":")" + task + R"(","steps":[7]})";
  ASSERT_TRUE(write_file(damaged / "demonstrations" / "M1.jsonl", line + "\n"));
  const auto refused = run_program({"render", damaged.string(), task, "--out", folder.at("no.svg")});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("M1.jsonl:1"));
  EXPECT_FALSE(fs::exists(folder.at("no.svg")));
}

}  // namespace
}  // namespace unietp
