// A text by a person that failed the checks and was accepted all the same says what it likes: it is never proven.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/sqlite_file.h"
#include "data_set.h"
#include "forged_set.h"
#include "program.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr int kTasks = 19;
constexpr const char* kWrong = "Set fire to the house.";

/// A copy of the forged set, of which the first task got a text of another meaning in a review.
class UncheckedText : public ::testing::Test {
 protected:
  UncheckedText() : copy_(forged_set().folder()) {
    const auto task = json_lines(copy_.folder() / "tasks.jsonl").front();
    task_ = task["id"];
    const Json reviews{{{"task", task_},
                        {"verdict", "edit"},
                        {"instruction", task["instruction"]["text"]},
                        {"text", kWrong},
                        {"comment", ""}}};
    const std::string file = scratch_.at("review.json");
    EXPECT_TRUE(write_file(
        file, Json{{"format", "unietp-review/1"}, {"set", "set"}, {"tasks_sha256", "x"}, {"reviews", reviews}}.dump()));
    const auto ended = run_program({"review", copy_.folder().string(), "--apply", file, "--accept-unchecked"});
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  }

  /// Replaces one part of the tasks' lines.
  void forge_lines(const std::string& from, const std::string& to) const {
    auto text = copy_.read("tasks.jsonl");
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    copy_.write("tasks.jsonl", text.replace(at, from.size(), to));
  }

  ScratchFolder scratch_;
  DamagedCopy copy_;
  std::string task_;
};

TEST_F(UncheckedText, IsReportedAndItsTaskNotProven) {
  const auto verdict = validate(copy_.folder());
  EXPECT_EQ(verdict.code, 1);
  EXPECT_EQ(verdict.proven, kTasks - 1);
  ASSERT_EQ(verdict.problems.size(), 1U);
  EXPECT_EQ(verdict.problems[0].kind, "text-unchecked");
  EXPECT_EQ(verdict.problems[0].task, task_);
  EXPECT_THAT(verdict.problems[0].message, HasSubstr(kWrong));
}

TEST_F(UncheckedText, IsCountedWhereItIsAcceptedAndItsTaskNotProvenEither) {
  const auto verdict = validate(copy_.folder(), {"--accept-unchecked"});
  EXPECT_EQ(verdict.code, 0);
  EXPECT_EQ(verdict.proven, kTasks - 1);
  const auto ended = run_program({"validate", copy_.folder().string(), "--accept-unchecked"});
  EXPECT_THAT(ended.out,
              EndsWith("18 of 19 proven; of 1 the text failed the checks (person:unchecked), so that nothing "
                       "proves its meaning\n"));
}

/// All that records that the checks failed says otherwise.
TEST_F(UncheckedText, IsReadWhereAForgerCallsItChecked) {
  forge_lines(R"("writer":"person:unchecked")", R"("writer":"person")");
  forge_lines(R"("checks":["form","style"])", R"("checks":["form","parses-back","style"])");
  SqliteFile(copy_.folder() / "dataset.sqlite", SqliteFile::Mode::Create)
      .run("UPDATE task SET writer = 'person' WHERE writer = 'person:unchecked'");
  copy_.vouch();
  const auto verdict = validate(copy_.folder(), {"--accept-unchecked"});
  EXPECT_EQ(verdict.code, 1);
  EXPECT_EQ(verdict.proven, kTasks - 1);
  ASSERT_EQ(verdict.problems.size(), 1U);
  EXPECT_EQ(verdict.problems[0].kind, "text-meaning");
}

}  // namespace
}  // namespace unietp
