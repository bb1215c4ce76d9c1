#include "dataset/configuration_json.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "templates/template.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

fs::path runs() { return fs::path(UNIETP_SOURCE_DIR) / "data" / "runs"; }

std::string refusal(const std::string& fields) {
  const auto read = configuration_from_json("my.json", R"({"format": "unietp-run/1", )" + fields + "}");
  return read ? "accepted" : format(read.error());
}

TEST(ConfigurationJson, ReadsBackWhatItWrites) {
  RunConfiguration configuration;
  configuration.seed = 77;
  configuration.count = 30;
  configuration.simulators = {Simulator::Habitat, Simulator::Behavior};
  configuration.splits = {Split::Atomic, Split::Linguistic};
  configuration.quotas = {{{Split::Atomic, 10}, {Split::Linguistic, 20}},
                          {{Simulator::Habitat, 25}, {Simulator::Behavior, 5}}};
  configuration.templates = {"a", "b"};
  configuration.without = {"c"};
  configuration.extended = true;
  configuration.binding = {{"A", "Mug"}};
  configuration.modes = {Mode::M1, Mode::M3};
  configuration.phrasings = Phrasings::Benchmark;
  configuration.attempts = 3;
  configuration.block = 9;
  configuration.homes = HomeSource::Training;
  configuration.rooms = 8;
  configuration.objects = 0;
  configuration.scenes = {"x 12"};
  configuration.own = {"y 34"};
  for (const auto& one : {configuration, RunConfiguration{}}) {
    const auto read = configuration_from_json("written", to_json(one).dump());
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(*read, one);
  }
}

TEST(ConfigurationJson, M1ComesWithTheOtherModes) {
  const auto read = configuration_from_json("my.json", R"({"format": "unietp-run/1", "modes": ["M3", "M2"]})");
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_THAT(read->modes, ElementsAre(Mode::M1, Mode::M2, Mode::M3));
}

TEST(ConfigurationJson, TheBenchmarkHasThePublishedQuotas) {
  const auto read = read_configuration(runs() / "benchmark.json");
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_EQ(read->count, 536);
  EXPECT_EQ(read->homes, HomeSource::Benchmark);
  EXPECT_THAT(read->quotas.splits, ElementsAre(std::pair{Split::Atomic, 42}, std::pair{Split::Compositional, 123},
                                               std::pair{Split::Logical, 130}, std::pair{Split::InstanceGrounding, 115},
                                               std::pair{Split::Linguistic, 126}));
  EXPECT_THAT(read->quotas.simulators,
              ElementsAre(std::pair{Simulator::Ai2thor, 182}, std::pair{Simulator::Virtualhome, 82},
                          std::pair{Simulator::Habitat, 82}, std::pair{Simulator::Behavior, 190}));
  const auto training = read_configuration(runs() / "training.json");
  ASSERT_TRUE(training) << format(training.error());
  EXPECT_EQ(training->count, 9000);
  EXPECT_EQ(training->homes, HomeSource::Training);
}

TEST(HeldOutTemplates, AreAThirdOfEachClassAndAllThere) {
  std::ifstream file(runs() / "held_out_templates.txt");
  std::map<std::string, int> held_out, all;
  for (std::string line; std::getline(file, line);) {
    const std::string name(trim(std::string_view(line).substr(0, line.find('#'))));
    if (name.empty()) continue;
    int found = 0;
    for (const std::string folder : {"atomic", "compositional", "logical"}) {
      if (!fs::exists(fs::path(UNIETP_SOURCE_DIR) / "templates" / "library" / folder / (name + ".template"))) continue;
      ++found;
      ++held_out[folder];
    }
    EXPECT_EQ(found, 1) << name;
  }
  for (const auto& [folder, count] : held_out) {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(UNIETP_SOURCE_DIR) / "templates" / "library" / folder))
      files += entry.path().extension() == ".template" ? 1 : 0;
    EXPECT_EQ(count, files / 3) << folder;
  }
  EXPECT_EQ(held_out.size(), 3U);
}

TEST(ConfigurationJson, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(refusal(R"("seeds": 3)"), HasSubstr("seeds"));
  EXPECT_THAT(refusal(R"("count": 0)"),
              HasSubstr("#/count: schema error: expected a whole number from 1 to 1000000000"));
  EXPECT_THAT(refusal(R"("count": 2.5)"), HasSubstr("expected a whole number"));
  EXPECT_THAT(refusal(R"("simulators": ["ai2thor", "behaviour"])"), HasSubstr("did you mean \"behavior\""));
  EXPECT_THAT(refusal(R"("homes": "bench")"), HasSubstr("accepted: drawn, benchmark, training"));
  EXPECT_THAT(refusal(R"("quotas": {"splits": {"atomic": 3}, "simulators": {"habitat": 4}})"),
              HasSubstr("splits ask for 3 tasks and simulators for 4"));
  EXPECT_THAT(refusal(R"("count": 9, "quotas": {"splits": {"atomic": 3}, "simulators": {"habitat": 3}})"),
              HasSubstr("ask for 3 tasks, but \"count\" says 9"));
  EXPECT_THAT(refusal(R"("quotas": {"splits": {"atomik": 3}, "simulators": {"habitat": 3}})"),
              HasSubstr("did you mean \"atomic\""));
  EXPECT_THAT(refusal(R"("binding": ["Mug"])"), HasSubstr("PLACEHOLDER=CATEGORY"));
  EXPECT_THAT(refusal(R"("simulators": [])"), HasSubstr("#/simulators: schema error: expected at least one name"));
  EXPECT_THAT(refusal(R"("modes": [])"), HasSubstr("#/modes: schema error: expected at least one name"));
  constexpr const char* kHuge = R"("splits": {"atomic": 1e9, "logical": 1e9, "linguistic": 1e9})";
  EXPECT_THAT(refusal(R"("quotas": {)" + std::string(kHuge) + R"(, "simulators": {"habitat": 1}})"),
              HasSubstr("ask for more than 1000000000 tasks"));
  const auto cut = configuration_from_json("my.json", "{\"format\": ");
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().pos.line, 1);
}

}  // namespace
}  // namespace unietp
