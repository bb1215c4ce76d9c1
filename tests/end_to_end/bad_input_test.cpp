// Bad input to the real program: each says where and what is accepted, ends with exit code 2, and leaves nothing
// behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "core/version.h"
#include "program.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

const fs::path kSource = UNIETP_SOURCE_DIR;

/// A template as the library has it, with one thing changed.
std::string template_with(const std::string& from, const std::string& to) {
  const std::string sound =
      "(template put-one\n"
      "  (name \"put <A> on <B>\")\n"
      "  (split atomic) (purpose tidying (because (not (on A B))))\n"
      "  (parameters (A - pickupable) (B - receptacle furniture))\n"
      "  (constraints (distinct A B) (fits-on A B))\n"
      "  (init (forall (?a - A) (not (exists (?b - B) (on ?a ?b)))))\n"
      "  (goal (at-end (exists (?a - A) (exists (?b - B) (on ?a ?b)))))\n"
      "  (instruction \"Put {A:indefinite} {B:on}.\"))\n";
  EXPECT_NE(sound.find(from), std::string::npos);
  return replace_all(sound, from, to);
}

/// The tables and the library, copied so that one thing in them can be damaged.
class OwnData : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.path() / "own");
    fs::copy(kSource / "data", folder_.path() / "own" / "data", fs::copy_options::recursive);
    fs::create_directories(folder_.path() / "own" / "templates");
    fs::copy(kSource / "templates" / "library", folder_.path() / "own" / "templates" / "library",
             fs::copy_options::recursive);
  }
  Ended generate() {
    return run_program({"generate", "--count", "4", "--data", folder_.at("own"), "--out", folder_.at("out")});
  }
  void expect_refused(const Ended& ended, const std::string& place, const std::string& message) {
    EXPECT_EQ(ended.code, 2) << ended.out << ended.err;
    EXPECT_THAT(ended.err, ContainsRegex(place));
    EXPECT_THAT(ended.err, HasSubstr(message));
    EXPECT_FALSE(fs::exists(folder_.at("out")));
    EXPECT_FALSE(fs::exists(folder_.at("out.partial")));
  }
  ScratchFolder folder_;
};

class BadTemplate : public OwnData {
 protected:
  Ended generate_with(const std::string& from, const std::string& to) {
    const auto file = folder_.path() / "own" / "templates" / "library" / "atomic" / "put-one.template";
    EXPECT_TRUE(write_file(file, template_with(from, to)));
    return generate();
  }
};

TEST_F(BadTemplate, AMissingBracketIsPlaced) {
  expect_refused(generate_with("(on ?a ?b)))))\n  (instruction", "(on ?a ?b))))\n  (instruction"),
                 "put-one.template:[0-9]+:[0-9]+: ", "missing ')'");
}
TEST_F(BadTemplate, AnUnknownPredicateIsPlacedWithTheNearestOne) {
  const auto ended = generate_with("(goal (at-end (exists (?a - A) (exists (?b - B) (on ?a ?b)))))",
                                   "(goal (at-end (exists (?a - A) (exists (?b - B) (insside ?a ?b)))))");
  expect_refused(ended, "put-one.template:7:[0-9]+: ", "inside");
}
TEST_F(BadTemplate, AnUnboundVariableIsPlaced) {
  expect_refused(generate_with("(goal (at-end (exists (?a - A) (exists (?b - B) (on ?a ?b)))))",
                               "(goal (at-end (exists (?a - A) (exists (?b - B) (on ?a ?c)))))"),
                 "put-one.template:7:[0-9]+: ", "?c");
}
TEST_F(BadTemplate, AStateFormulaOutsideATemporalOperatorIsPlaced) {
  expect_refused(generate_with("(goal (at-end (exists (?a - A) (exists (?b - B) (on ?a ?b)))))",
                               "(goal (exists (?a - A) (exists (?b - B) (on ?a ?b))))"),
                 "put-one.template:7:[0-9]+: ", "at-end");
}
TEST_F(BadTemplate, ACategoryThatNoKnowledgeBaseHasIsPlaced) {
  expect_refused(generate_with("(goal (at-end (exists (?a - A) (exists (?b - B) (on ?a ?b)))))",
                               "(goal (at-end (exists (?a - A) (exists (?b - Unicornstable) (on ?a ?b)))))"),
                 "put-one.template:7:[0-9]+: ", "Unicornstable");
}
TEST_F(BadTemplate, AStartWithTooManyObjectsIsPlaced) {
  const auto ended = generate_with("(forall (?a - A) (not (exists (?b - B) (on ?a ?b))))",
                                   "(count >= 40000 (?a - A) (not (exists (?b - B) (on ?a ?b))))");
  expect_refused(ended, "put-one.template:6:[0-9]+: ", "init asks for 40000 objects up to here; at most 1000");
  EXPECT_EQ(split(trim(ended.err), '\n').size(), 1U) << ended.err;
}
TEST_F(BadTemplate, AGoalThatCountsTooFarIsPlaced) {
  const auto ended = generate_with("(goal (at-end (exists (?a - A) (exists (?b - B) (on ?a ?b)))))",
                                   "(goal (at-end (count >= 40000 (?a - A) (exists (?b - B) (on ?a ?b)))))");
  expect_refused(ended, "put-one.template:7:[0-9]+: ", "this count compares with 40000; at most 1000 is allowed");
}
TEST_F(BadTemplate, ASoundOneIsTaken) {
  const auto file = folder_.at("put-one.template");
  ASSERT_TRUE(write_file(file, template_with("(split atomic)", "(split atomic)")));
  const auto ended = run_program({"template", "lint", file});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 sound, 0 errors, 0 warnings\n"));
}

TEST_F(OwnData, ATableWithAWrongColumnIsPlaced) {
  const auto file = folder_.path() / "own" / "data" / "akb" / "habitat" / "affordance.csv";
  const auto text = read_file(file);
  ASSERT_TRUE(text);
  ASSERT_TRUE(write_file(file, replace_all(*text, "category,affordance,", "category,afordance,")));
  expect_refused(generate(), "affordance.csv:1:[0-9]+: ", "affordance");
}
TEST_F(OwnData, TablesOfANewerVersionAreRefusedWithWhatToDo) {
  const auto data = folder_.path() / "own" / "data";
  const auto table = data / "akb" / "virtualhome" / "alias.csv";
  const auto text = read_file(table);
  ASSERT_TRUE(text);
  ASSERT_TRUE(write_file(table, replace_all(*text, "\n", ",0.5\n")));  // each row has a column more
  const auto profile = data / "simulators" / "habitat.json";
  for (int later = 0; later < 2; ++later) {
    const auto ended = generate();
    expect_refused(
        ended, later == 0 ? "alias.csv:1:[0-9]+: " : "habitat.json: ",
        "cannot read these tables; if they came with another version, use that version, or give this one its "
        "own data with --data or UNIETP_DATA");
    const auto lines = split(trim(ended.err), '\n');
    EXPECT_THAT(lines.back(), HasSubstr(data.string() + ": "));
    EXPECT_THAT(lines.back(), HasSubstr("unietp " + std::string(program_version()) + " ("));
    ASSERT_TRUE(write_file(table, *text));
    ASSERT_TRUE(write_file(profile, replace_all(*read_file(profile), "\"hands\"", "\"arms\"")));
  }
}
TEST_F(OwnData, ARowWithAColumnTooManyIsPlaced) {
  const auto file = folder_.path() / "own" / "data" / "akb" / "ai2thor" / "affordance.csv";
  const auto text = read_file(file);
  ASSERT_TRUE(text);
  const auto lines = static_cast<int>(split(*text, '\n').size());
  ASSERT_TRUE(write_file(file, *text + "Mug,pickupable,curated,1,surplus\n"));
  expect_refused(generate(), "affordance.csv:" + std::to_string(lines) + ":[0-9]+: ", "expected");
}
TEST_F(OwnData, AnUnknownCategoryInATableIsPlaced) {
  const auto file = folder_.path() / "own" / "data" / "akb" / "behavior" / "affordance.csv";
  const auto text = read_file(file);
  ASSERT_TRUE(text);
  const auto header = split(*text, '\n').front();
  ASSERT_EQ(header, "category,affordance,source,confidence");
  const auto lines = static_cast<int>(split(*text, '\n').size());
  ASSERT_TRUE(write_file(file, *text + "zzz_unicorn,pickupable,curated,1\n"));
  expect_refused(generate(), "affordance.csv:" + std::to_string(lines) + ":1: ", "zzz_unicorn");
}

TEST(BadInput, AFolderThatCannotBeWrittenIsNamedAndNothingIsLeft) {
  ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("file"), "not a folder"));
  for (const auto& out : {std::string("/proc/unietp-out"), folder.at("file/out")}) {
    const auto ended = run_program({"generate", "--count", "4", "--out", out});
    EXPECT_EQ(ended.code, 2) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(out));
    EXPECT_THAT(ended.err, HasSubstr("choose a folder that you can write to"));
  }
  EXPECT_EQ(bytes_below(folder.path()).size(), 1U);
}
TEST(BadInput, AFolderThatExistsIsKept) {
  ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("out/mine.txt"), "mine"));
  const auto ended = run_program({"generate", "--count", "4", "--out", folder.at("out")});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("already exists"));
  EXPECT_EQ(bytes_below(folder.path()).size(), 1U);
}
TEST(BadInput, UnknownNamesAreToldWithTheNearestKnownOne) {
  ScratchFolder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--simulators", "ai2thor,habitatt"}, "did you mean \"habitat\""},
      {{"--splits", "atomik"}, "did you mean \"atomic\""},
      {{"--template", "open-onee"}, "did you mean \"open-one\""},
      {{"--templates", "open-one"}, "`--template open-one` selects one by name"},
      {{"--templates", folder.at("none")}, "is not a file or folder"},
      {{"--count", "none"}, "--count"},
      {{"--seed", "9007199254740992"}, "from 0 to 9007199254740991"},
      {{"--rooms", "1"}, "--rooms"},
      {{"--frobnicate"}, "--frobnicate"},
      {{"--data", folder.at("nowhere")}, "--data"},
  };
  for (const auto& [options, message] : cases) {
    std::vector<std::string> arguments{"generate", "--out", folder.at("out")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto ended = run_program(arguments);
    EXPECT_EQ(ended.code, 2) << message;
    EXPECT_THAT(ended.err, HasSubstr(message));
  }
  EXPECT_TRUE(bytes_below(folder.path()).empty());
}
TEST(BadInput, AGoalIsReadWithTheColumnOfWhatIsWrong) {
  const auto unknown = run_program({"goal", "(at-end (exists (?m - Mug) (opened ?m)))"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("goal:1:"));
  const auto category = run_program({"goal", "(at-end (exists (?m - Mugg) (open ?m)))", "--simulators", "ai2thor"});
  EXPECT_EQ(category.code, 2);
  EXPECT_THAT(category.err, HasSubstr("did you mean \"Mug\""));
  const auto sound = run_program({"goal", "(at-end  (exists (?m - Mug) (dirty ?m)))", "--simulators", "ai2thor"});
  EXPECT_EQ(sound.code, 0) << sound.err;
  EXPECT_EQ(sound.out, "(at-end (exists (?m - Mug) (dirty ?m)))\n");
}
TEST(BadInput, ValidateAsksForAFolder) {
  const auto ended = run_program({"validate", "/nowhere/at/all"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("/nowhere/at/all"));
}

}  // namespace
}  // namespace unietp
