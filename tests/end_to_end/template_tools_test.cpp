// The commands that try templates: what they show, and how they end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// A template of the user's: what it asks of A, and what init says.
std::string own_template(const std::string& name, const std::string& parameters, const std::string& init) {
  return "(template " + name +
         " (name \"have one <A> open\") (split atomic) (simulators ai2thor)\n  (parameters (A - " + parameters +
         "))\n  (init " + init +
         ")\n  (goal (exists (?a - A) (at-end (open ?a))))\n"
         "  (instruction \"Open {A:indefinite} now.\" \"Have {A:indefinite} open, please.\"))\n";
}
const std::string kClosed = "(forall (?a - A) (closed ?a))";

TEST(TemplateTry, ShowsProvenTasksOfATemplate) {
  const auto ended = run_program({"template", "try", "place-one-on", "--simulator", "ai2thor", "--count", "2"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, ContainsRegex("place-one-on on ai2thor: 2 of [0-9]+ candidates became tasks"));
  EXPECT_THAT(ended.out, ContainsRegex("with A=[A-Za-z]+, B=[A-Za-z]+ in ai2thor-home-"));
  EXPECT_THAT(ended.out, HasSubstr("pick_up("));
}

TEST(TemplateTry, TakesAFileThatIsInNoLibraryAndRepeatsItself) {
  ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("open-mine.template"), own_template("open-mine", "furniture openable", kClosed)));
  const std::vector<std::string> command{"template", "try", folder.at("open-mine.template"), "--json"};
  const auto first = run_program(command), second = run_program(command);
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(first.out, second.out);
  const auto json = Json::parse(first.out);
  EXPECT_TRUE(json["proven"]);
  const auto& task = json["simulators"][0]["tasks"][0];
  EXPECT_THAT(task["goal"].get<std::string>(), HasSubstr("(open ?a)"));
  EXPECT_FALSE(task["instruction"].get<std::string>().empty());
  EXPECT_EQ(task["steps"].back(), "stop");
}

TEST(TemplateTry, TellsWhatStopsATemplateAndTheMostLikelyFix) {
  ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("open-open.template"),
                         own_template("open-open", "furniture openable", "(forall (?a - A) (open ?a))")));
  const auto ended = run_program({"template", "try", folder.at("open-open.template"), "--tries", "3"});
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("0 of 3 candidates became tasks"));
  EXPECT_THAT(ended.out, HasSubstr("already holds in a start that meets init"));
  EXPECT_THAT(ended.out, HasSubstr("most likely: "));
}

TEST(TemplateTry, KeepsTheCategoriesThatAreBound) {
  const auto ended =
      run_program({"template", "try", "place-one-on", "--simulator", "ai2thor", "--bind", "A=Book", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json told = Json::parse(ended.out);
  ASSERT_FALSE(told["simulators"][0]["tasks"].empty());
  for (const auto& task : told["simulators"][0]["tasks"]) EXPECT_EQ(task["binding"]["A"], "Book");
}

TEST(TemplateTry, NamesAreToldWithTheNearestKnownOne) {
  const auto unknown = run_program({"template", "try", "place-one-onn"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean \"place-one-on\""));
  const auto placeholder = run_program({"template", "try", "place-one-on", "--bind", "X=Mug"});
  EXPECT_EQ(placeholder.code, 2);
  EXPECT_THAT(placeholder.err, HasSubstr("it has A, B"));
  const auto half = run_program({"template", "try", "place-one-on", "--bind", "Mug"});
  EXPECT_EQ(half.code, 2);
  EXPECT_THAT(half.err, HasSubstr("expected PLACEHOLDER=CATEGORY"));
}

TEST(TemplateWhyNot, NamesTheGateTheFactAndWhatElseCouldBeBound) {
  const auto ended = run_program({"template", "why-not", "place-one-inside", "--bind", "A=Pillow", "B=Microwave"});
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("place-one-inside on ai2thor with A=Pillow, B=Microwave"));
  EXPECT_THAT(ended.out, ContainsRegex("affordance +passed"));
  EXPECT_THAT(ended.out, ContainsRegex("constraint +refused"));
  EXPECT_THAT(ended.out, HasSubstr("relation has no row (inside, Pillow, Microwave)"));
  EXPECT_THAT(ended.out, ContainsRegex("A could be: .*Potato"));
  EXPECT_THAT(ended.out, ::testing::Not(HasSubstr("B could be")));  // nothing holds a pillow inside
}

TEST(TemplateWhyNot, AsksAboutAffordancesAndKnownNames) {
  const auto affordance = run_program({"template", "why-not", "place-one-inside", "--bind", "A=Fridge", "B=Mug"});
  EXPECT_EQ(affordance.code, 1);
  EXPECT_THAT(affordance.out, HasSubstr("cannot be A, which asks for: pickupable"));
  const auto name =
      run_program({"template", "why-not", "place-one-inside", "--bind", "A=Mugg", "--simulator", "ai2thor", "--json"});
  EXPECT_EQ(name.code, 1);
  const auto json = Json::parse(name.out)["simulators"][0];
  EXPECT_EQ(json["gate"], "placeholder");
  EXPECT_EQ(json["fact"], "did you mean \"Mug\"");
}

TEST(TemplateWhyNot, ABindingThatPassesIsTakenThroughHomes) {
  const auto ended =
      run_program({"template", "why-not", "place-one-inside", "--bind", "A=Bowl", "--simulator", "ai2thor", "--try"});
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("all gates pass"));
  EXPECT_THAT(ended.out, ContainsRegex("sense +(usual|tolerable|senseless): +bowl in "));
  EXPECT_THAT(ended.out, ContainsRegex("homes +passed"));
}

TEST(TemplateCoverage, IsTheSameWithAnyNumberOfThreads) {
  const auto known = [](const std::string& threads) {
    return run_program({"template", "coverage", "--tries", "2", "--template", "open-one,place-one-on", "--homes", "2",
                        "--simulators", "ai2thor,habitat", "--threads", threads, "--json"});
  };
  const auto one = known("1"), two = known("2");
  EXPECT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.out, two.out);
  const auto json = Json::parse(one.out);
  EXPECT_EQ(json["claimed"], 4);
  for (const auto& row : json["templates"]) {
    for (const auto& [simulator, cell] : row["cells"].items()) EXPECT_EQ(cell["candidates"], 2) << simulator;
  }
}

TEST(TemplateCoverage, AnUnknownNameIsToldWithTheNearest) {
  const auto ended = run_program({"template", "coverage", "--template", "open-onee"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("did you mean \"open-one\""));
}

TEST(TemplateCoverage, EndsWithOneWhenAClaimedCellIsEmpty) {
  ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("open-open.template"),
                         own_template("open-open", "furniture openable", "(forall (?a - A) (open ?a))")));
  const auto ended = run_program({"template", "coverage", "--tries", "2", "--homes", "1", "--templates",
                                  folder.path().string(), "--template", "open-open"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("0/2"));
  EXPECT_THAT(ended.out, HasSubstr("open-open on ai2thor gave no task"));
  EXPECT_THAT(ended.out, HasSubstr("0 of 1 pairs of template and simulator have a verified task"));
}

TEST(OwnTemplates, MakeADataSetThatIsProvenWithoutTheirFolder) {
  ScratchFolder folder;
  ASSERT_TRUE(
      write_file(folder.at("own/open-mine.template"), own_template("open-mine", "furniture openable", kClosed)));
  const auto ended =
      run_program({"generate", "--count", "2", "--simulators", "ai2thor", "--splits", "atomic", "--templates",
                   folder.at("own"), "--template", "open-mine", "--rooms", "5", "--out", folder.at("out")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  fs::remove_all(folder.at("own"));
  const auto verdict = validate(folder.at("out"));
  EXPECT_EQ(verdict.code, 0);
  EXPECT_EQ(verdict.proven, 2);
  const auto manifest = read_file(folder.at("out/manifest.json"));
  ASSERT_TRUE(manifest);
  EXPECT_THAT(*manifest, HasSubstr("\"open-mine "));
}

TEST(GenerateBind, MakesExactlyTheBindingThatIsAskedFor) {
  ScratchFolder folder;
  const auto ended = run_program({"generate", "--template", "place-one-on", "--bind", "A=Book", "B=Sofa", "--rooms",
                                  "5", "--out", folder.at("out")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto tasks = json_lines(folder.path() / "out" / "tasks.jsonl");
  ASSERT_EQ(tasks.size(), 1U);
  EXPECT_EQ(tasks[0]["simulator"], "ai2thor");  // the one that has a Book and a Sofa
  EXPECT_EQ(tasks[0]["bindings"], (Json{{"A", "Book"}, {"B", "Sofa"}}));
  EXPECT_EQ(validate(folder.at("out")).proven, 1);
}

TEST(GenerateBind, SaysWhyNotAndMakesNothing) {
  ScratchFolder folder;
  const auto ended = run_program(
      {"generate", "--template", "place-one-inside", "--bind", "A=Pillow", "B=Microwave", "--out", folder.at("out")});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, ContainsRegex("constraint +refused"));
  EXPECT_THAT(ended.out, HasSubstr("A could be: "));
  EXPECT_TRUE(bytes_below(folder.path()).empty());
}

TEST(GenerateBind, TakesAHomeOfTheBenchmarkByItsName) {
  ScratchFolder folder;
  const auto ended = run_program({"generate", "--template", "place-one-on", "--bind", "A=Book", "--scene",
                                  "ai2thor-benchmark-01", "--out", folder.at("out")});
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const auto tasks = json_lines(folder.path() / "out" / "tasks.jsonl");
  ASSERT_EQ(tasks.size(), 1U);
  EXPECT_EQ(tasks[0]["layout"], "ai2thor-benchmark-01");
  EXPECT_EQ(tasks[0]["bindings"]["A"], "Book");
  const auto unknown =
      run_program({"generate", "--count", "1", "--scene", "ai2thor-benchmark-0l", "--out", folder.at("other")});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean \"ai2thor-benchmark-01\""));
}

TEST(GenerateBind, NeedsOneTemplate) {
  ScratchFolder folder;
  const auto ended = run_program({"generate", "--bind", "A=Book", "--out", folder.at("out")});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("--template NAME"));
}

}  // namespace
}  // namespace unietp
