#include "evaluation/evaluation_manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sample_records.h"
#include "schema_checker.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(EvaluationManifest, ReadsBackWhatWasWritten) {
  EvaluationManifest without_model = sample_manifest();
  without_model.setup.talk.reset();
  without_model.setup.sampling.reset();
  EvaluationManifest left_to_server = sample_manifest();
  left_to_server.setup.sampling = SamplingSettings{};
  for (const auto& manifest :
       {sample_manifest(), without_model, left_to_server, EvaluationManifest(sample_manifest())}) {
    const auto read = read_evaluation_manifest("manifest.json", to_text(manifest));
    ASSERT_TRUE(read) << format(read.error());
    EXPECT_EQ(*read, manifest);
    EXPECT_EQ(to_text(*read), to_text(manifest));
  }
}

TEST(EvaluationManifest, IsAsItsSchemaSays) {
  SchemaChecker checker;
  EXPECT_EQ(checker.check(nlohmann::ordered_json::parse(to_text(sample_manifest())), "evaluation.schema.json"), "");
}

TEST(EvaluationManifest, DifferencesNameEachSettingWithItsValues) {
  const EvaluationSetup then = sample_manifest().setup;
  EXPECT_THAT(differences(then, then), IsEmpty());
  EvaluationSetup now = then;
  now.settings[Mode::M1].rules.limits.steps = 60;
  now.dataset.digest = "other";
  now.sampling->temperature = std::nullopt;
  now.talk->history = -1;
  EXPECT_THAT(differences(then, now), ElementsAre("dataset.digest: \"" + then.dataset.digest + "\" then, \"other\" now",
                                                  "settings.M1.steps: 50 then, 60 now", "talk.history: 5 then, -1 now",
                                                  "sampling.temperature: 0.2 then, null now"));
}

TEST(EvaluationManifest, DifferencesNameTheFilesOfAnAgentThatChanged) {
  EvaluationSetup then = sample_manifest().setup;
  then.agent.files = {{"agent.py", "a"}, {"gone.py", "b"}, {"same.py", "c"}};
  EvaluationSetup now = then;
  now.agent.files = {{"agent.py", "x"}, {"new.py", "b"}, {"same.py", "c"}};
  EXPECT_THAT(differences(then, now),
              ElementsAre("agent.files: agent.py has changed", "agent.files: gone.py is not there now",
                          "agent.files: new.py was not there then"));
}

}  // namespace
}  // namespace unietp
