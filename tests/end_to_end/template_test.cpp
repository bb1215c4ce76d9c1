// The workshop for templates, put to the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "program.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

Ended ask(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "template");
  return run_program(arguments);
}

Json json_of(const Ended& ended) {
  auto json = Json::parse(ended.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << ended.out << ended.err;
  return json;
}

std::string bytes_of(const fs::path& path) {
  const auto text = read_file(path);
  return text ? *text : "";
}

TEST(TemplateList, ChoosesByClassAndSimulator) {
  const auto all = json_of(ask({"list", "--json"}));
  const auto some = json_of(ask({"list", "--json", "--class", "atomic", "--simulators", "habitat"}));
  EXPECT_GE(all.size(), 50U);
  EXPECT_LT(some.size(), all.size());
  ASSERT_FALSE(some.empty());
  for (const auto& one : some) {
    EXPECT_EQ(one["split"], "atomic");
    EXPECT_THAT(one["simulators"].dump(), HasSubstr("\"habitat\""));
  }
  EXPECT_THAT(ask({"list"}).out, HasSubstr("\n" + std::to_string(all.size()) + " templates\n"));
  EXPECT_GE(json_of(ask({"list", "--json", "--all"})).size(), all.size());
  const auto wrong = ask({"list", "--class", "atomical"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("atomic"));
}

TEST(TemplateShow, TellsTheGoalInWordsAndWhatMayFillIt) {
  const auto ended = ask({"show", "place-two-one-inside"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* part : {"two <A>", "<C> furniture container: a category that cannot be moved; objects go into it",
                           "every <A> is inside no <C>", "behavior: more than 5000 bindings",
                           "such as A=", "Put a couple of {A:plural} and {B:indefinite} {C:into}."}) {
    EXPECT_THAT(ended.out, HasSubstr(part));
  }
}

TEST(TemplateShow, CountsBindingsExactlyAndAsJson) {
  const auto json = json_of(ask({"show", "open-one", "--json"}));
  EXPECT_EQ(json["format"], "unietp-template/1");
  ASSERT_EQ(json["simulators"].size(), 4U);
  for (const auto& one : json["simulators"]) {
    EXPECT_EQ(one["more"], false);
    EXPECT_EQ(one["bindings"], one["fills"]["A"].size()) << "one placeholder: a binding a category";
    EXPECT_GT(one["bindings"], 0);
  }
  EXPECT_EQ(json["filled"].size(), json["phrasings"].size());
}

TEST(TemplateShow, AnUnknownNameIsAnsweredWithTheNearest) {
  const auto ended = ask({"show", "opn-one"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("did you mean \"open-one\""));
}

constexpr const char* kManyProblems =
    "(template many\n"
    "  (name \"open one <A>\")\n"
    "  (split atomc)\n"
    "  (simulators ai2thor habitat habitat)\n"
    "  (parameters (A - openabel))\n"
    "  (init (exists (?a - A) (clsed ?a)))\n"
    "  (goal (exists (?a - A) (at-end (and (opn ?a) (hot ?b)))))\n"
    "  (instruction \"Open it.\"))\n";

TEST(TemplateLint, AllProblemsAtOnceEachWithItsPlaceInTheSource) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("many.template"), kManyProblems));
  const auto ended = ask({"lint", folder.at("many.template")});
  EXPECT_EQ(ended.code, 2);
  for (const char* part : {"many.template:3:10: parse error: unknown split 'atomc'", "did you mean 'atomic'?",
                           "    3 |   (split atomc)\n      |          ^\n",
                           "4:31: parse error: simulator 'habitat' is listed twice", "did you mean 'openable'?",
                           "did you mean 'closed'?", "did you mean 'open'?", "the variable ?b is not bound here"}) {
    EXPECT_THAT(ended.err, HasSubstr(part));
  }
  EXPECT_THAT(ended.err, Not(HasSubstr("\033["))) << "colour is for terminals";
  EXPECT_EQ(ended.out, "0 sound, 7 errors, 0 warnings\n");
  const auto json = json_of(ask({"lint", "--json", folder.at("many.template")}));
  ASSERT_EQ(json["problems"].size(), 7U);
  EXPECT_EQ(json["problems"][0]["line"], 3);
  EXPECT_EQ(json["problems"][0]["column"], 10);
  EXPECT_EQ(json["problems"][0]["severity"], "error");
  EXPECT_EQ(json["problems"][0]["source"], "  (split atomc)");
}

TEST(TemplateLint, WarnsOfPhrasingsWithoutTheNumberAndOfSimulatorsThatHaveNothing) {
  const ScratchFolder folder;
  ASSERT_TRUE(
      write_file(folder.at("doubtful.template"),
                 "(template doubtful\n"
                 "  (name \"heat two <A>\")\n"
                 "  (split logical)\n"
                 "  (simulators ai2thor habitat)\n"
                 "  (parameters (A - pickupable countable) (T - any))\n"
                 "  (constraints (heats T A))\n"
                 "  (init (count >= 2 (?a - A) (and)) (exists (?t - T) (and)) (forall (?a - A) (not (hot ?a))))\n"
                 "  (goal (at-end (count >= 2 (?a - A) (hot ?a))))\n"
                 "  (instruction \"Heat two {A:plural}.\" \"Heat {A:plural}.\"))\n"));
  const auto ended = ask({"lint", folder.at("doubtful.template")});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("doubtful.template:9:39: warning: the goal counts 2"));
  EXPECT_THAT(ended.err, HasSubstr("doubtful.template:4:23: warning: habitat has no categories that can be bound"));
  EXPECT_THAT(ended.err, HasSubstr("without (heats T A) it would have"));
  EXPECT_THAT(ended.err, HasSubstr("doubtful.template:1:11: warning: no section (purpose ...)"));
  EXPECT_THAT(ended.out, ::testing::EndsWith("1 sound, 0 errors, 3 warnings\n"));
}

TEST(TemplateLint, SaysWhichPhrasingsAreReadBackAndWhyOthersAreNot) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("phrased.template"),
                         "(template phrased\n"
                         "  (name \"open one <A>\")\n"
                         "  (purpose preparing (because (closed A)))\n"
                         "  (split atomic)\n"
                         "  (parameters (A - openable))\n"
                         "  (init (exists (?a - A) (and)) (forall (?a - A) (closed ?a)))\n"
                         "  (goal (exists (?a - A) (at-end (open ?a))))\n"
                         "  (instruction\n"
                         "    \"Open {A:indefinite}.\"\n"
                         "    \"Close {A:indefinite}.\"\n"
                         "    \"Fling {A:indefinite} wide.\"))\n"));
  const auto ended = ask({"lint", folder.at("phrased.template")});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("phrased.template:10: no instruction has this phrasing: the text asks for"));
  EXPECT_THAT(ended.out, HasSubstr("phrased.template:11: no instruction has this phrasing: instruction:1:1:"));
  EXPECT_THAT(ended.out, HasSubstr("1 of 3 phrasings are read back and come first in instructions\n"));
  const auto json = json_of(ask({"lint", "--json", folder.at("phrased.template")}));
  ASSERT_EQ(json["phrasings"].size(), 3U);
  EXPECT_EQ(json["phrasings"][0]["readable"], true);
  EXPECT_EQ(json["phrasings"][1]["readable"], false);
  EXPECT_EQ(json["phrasings"][1]["line"], 10);
}

TEST(TemplateTry, ShowsThreeTextsForAStyle) {
  const auto json = json_of(ask(
      {"try", "place-one-on", "--simulators", "ai2thor", "--count", "1", "--bind", "A=Mug", "B=CounterTop", "--json"}));
  std::map<std::string, std::size_t> texts;
  for (const auto& style : json["simulators"][0]["texts"]) texts[style["style"]] = style["texts"].size();
  EXPECT_EQ(texts["direct"], 3U);
  EXPECT_GE(texts.size(), 3U);
}

TEST(TemplateLint, TheLibraryIsSoundAndItsPhrasingsSayWhatTheirGoalsCount) {
  const auto ended = ask({"lint", (fs::path(UNIETP_SOURCE_DIR) / "templates" / "library").string()});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr(" sound, 0 errors, "));
  EXPECT_THAT(ended.err, Not(HasSubstr("this phrasing")));
}

TEST(TemplateNew, WritesACommentedFileThatLintsCleanAndNeverOverwritesOne) {
  const ScratchFolder folder;
  const std::vector<std::string> command = {"new",           "unlock-one",
                                            "--out",         folder.at("mine"),
                                            "--parameter",   "A - furniture openable",
                                            "--init",        "(exists (?a - A) (and))",
                                            "--init",        "(forall (?a - A) (closed ?a))",
                                            "--goal",        "(exists (?a - A) (at-end (open ?a)))",
                                            "--purpose",     "preparing (because (closed A))",
                                            "--instruction", "Unlock {A:indefinite}."};
  const auto made = ask(command);
  EXPECT_EQ(made.code, 0) << made.err;
  const auto file = folder.at("mine/unlock-one.template");
  EXPECT_EQ(made.out, file + "\n");
  const auto text = bytes_of(file);
  EXPECT_THAT(text, HasSubstr("; the placeholders, and the requirements on their categories\n"));
  const auto linted = ask({"lint", file});
  EXPECT_THAT(linted.out, ::testing::EndsWith("1 sound, 0 errors, 0 warnings\n")) << linted.err;
  const auto again = ask(command);
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.err, HasSubstr("already exists"));
  EXPECT_EQ(bytes_of(file), text);
}

TEST(TemplateNew, WritesNothingThatWouldBeRefused) {
  const ScratchFolder folder;
  const auto ended = ask(
      {"new", "wrong", "--out", folder.at("."), "--like", "open-one", "--goal", "(exists (?a - A) (at-end (opn ?a)))"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("did you mean 'open'?"));
  EXPECT_THAT(ended.err, HasSubstr("not written"));
  EXPECT_TRUE(bytes_below(folder.path()).empty());
}

TEST(TemplateNew, AsksForWhatIsMissing) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("answers"),
                         "unlock one <A>\npreparing (because (closed A))\natomic\n\n\nA - furniture openable\n\n\n"
                         "(exists (?a - A) (and))\n(forall (?a - A) (closed ?a))\n\n"
                         "(exists (?a - A) (at-end (open ?a)))\nUnlock {A:indefinite}.\n\n"));
  const auto ended = run_script("unietp template new unlock-one --ask < answers", folder.path());
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("goal: what must hold"));
  const auto text = bytes_of(folder.at("unlock-one.template"));
  EXPECT_THAT(text, HasSubstr("(name \"unlock one <A>\")"));
  EXPECT_THAT(text, HasSubstr("(purpose preparing (because (closed A)))"));
}

TEST(TemplateVocabulary, IsATreeForEditorsAndThePageInTheDocs) {
  const auto json = json_of(ask({"vocabulary", "--json"}));
  EXPECT_EQ(json["format"], "unietp-vocabulary/1");
  EXPECT_THAT(json.dump(), HasSubstr("\"usage\":\"(fits-on A B [n])\""));
  const auto page = ask({"vocabulary", "--markdown"});
  EXPECT_EQ(page.out, bytes_of(fs::path(UNIETP_SOURCE_DIR) / "docs" / "vocabulary.md"));
  EXPECT_THAT(ask({"vocabulary"}).out, HasSubstr("(before f g)"));
}

}  // namespace
}  // namespace unietp
