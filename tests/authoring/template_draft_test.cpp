#include "authoring/template_draft.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "authoring/ask_template.h"
#include "templates/template_text.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

TemplateDraft open_one() {
  TemplateDraft draft;
  draft.name = "unlock-one";
  draft.title = "unlock one <A>";
  draft.purpose = "preparing (because (closed A))";
  draft.parameters = {"A - furniture openable"};
  draft.init = {"(exists (?a - A) (and))", "(forall (?a - A) (closed ?a))"};
  draft.goal = "(exists (?a - A) (at-end (open ?a)))";
  draft.phrasings = {"Unlock {A:indefinite}."};
  return draft;
}

TEST(TemplateDraft, EveryTemplateOfTheLibraryCanBeTheBeginningOfAnother) {
  const auto library = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates" / "library");
  ASSERT_TRUE(library.errors.empty());
  for (const auto& source : library.templates) {
    const auto draft = draft_like(source, "another");
    EXPECT_TRUE(draft_problems(draft, "another.template").empty()) << source.name;
    const auto reading = parse_template("another.template", draft_text(draft));
    ASSERT_EQ(reading.templates.size(), 1U) << source.name;
    auto renamed = source;
    renamed.name = "another";
    EXPECT_TRUE(same_content(reading.templates[0], renamed)) << source.name << "\n" << draft_text(draft);
  }
}

TEST(TemplateDraft, EachSectionHasALineThatSaysWhatItIsFor) {
  const auto text = draft_text(open_one());
  EXPECT_THAT(text, HasSubstr("  ; what every start must satisfy; grounding makes it true\n  (init\n    (exists"));
  EXPECT_THAT(text, HasSubstr("  ; optional: (constraints (fits-on A B 2) ...)"));
  for (const auto& problem : draft_problems(open_one(), "unlock-one.template")) {
    ADD_FAILURE() << format(problem.problem.error);
  }
}

TEST(TemplateDraft, AProblemKnowsItsSection) {
  auto draft = open_one();
  draft.goal = "(exists (?a - A) (at-end (opn ?a)))";
  draft.phrasings = {"Unlock it."};
  const auto problems = draft_problems(draft, "unlock-one.template");
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].section, "goal");
  EXPECT_EQ(problems[1].section, "instruction");
}

TEST(AskTemplate, AsksForEverySectionAndAgainForAWrongAnswer) {
  std::istringstream answers(
      "unlock one <A>\n"
      "preparing (because (closed A))\n"
      "atomic\n"
      "\n"
      "\n"
      "A - furniture openable\n\n"
      "\n"
      "(exists (?a - A) (and))\n(forall (?a - A) (closed ?a))\n\n"
      "(exists (?a - A) (at-end (opn ?a)))\n"
      "Unlock {A:indefinite}.\n\n"
      "(exists (?a - A) (at-end (open ?a)))\n");
  std::ostringstream questions;
  TemplateDraft draft;
  draft.name = "unlock-one";
  const auto asked = ask_template(draft, {}, answers, questions);
  ASSERT_TRUE(asked) << format(asked.error());
  EXPECT_EQ(*asked, open_one());
  EXPECT_THAT(questions.str(), HasSubstr("did you mean 'open'?"));
  EXPECT_THAT(questions.str(), HasSubstr("Please correct:"));
}

TEST(AskTemplate, ABracketThatIsMissingIsAskedForWhereItIsMissing) {
  auto draft = open_one();
  draft.goal = "(exists (?a - A) (at-end (open ?a))";
  const auto problems = draft_problems(draft, "unlock-one.template");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].section, "goal");
  EXPECT_THAT(problems[0].problem.error.message, HasSubstr("missing ')'"));
}

TEST(AskTemplate, ANameThatCannotBeIsAnErrorAndNotAskedForAgain) {
  auto draft = open_one();
  draft.name = "Unlock";
  std::istringstream answers("\n\n\n\n\n\n\n\n\n\n");
  std::ostringstream questions;
  const auto asked = ask_template(draft,
                                  {"name", "purpose", "split", "refinement", "simulators", "parameters", "constraints",
                                   "init", "goal", "instruction"},
                                  answers, questions);
  ASSERT_FALSE(asked);
  EXPECT_THAT(asked.error().message, HasSubstr("is not a valid template name"));
}

TEST(AskTemplate, AsksOnlyForWhatIsNotGiven) {
  auto draft = open_one();
  draft.goal = "";
  std::istringstream answers("(exists (?a - A) (at-end (open ?a)))\n");
  std::ostringstream questions;
  const auto asked = ask_template(
      draft,
      {"name", "purpose", "split", "refinement", "simulators", "parameters", "constraints", "init", "instruction"},
      answers, questions);
  ASSERT_TRUE(asked) << format(asked.error());
  EXPECT_EQ(*asked, open_one());
}

TEST(AskTemplate, AnswersThatEndTooEarlyAreAnError) {
  std::istringstream answers("unlock one <A>\natomic\n");
  std::ostringstream questions;
  TemplateDraft draft;
  draft.name = "unlock-one";
  const auto asked = ask_template(draft, {}, answers, questions);
  ASSERT_FALSE(asked);
  EXPECT_THAT(asked.error().message, HasSubstr("ended before"));
}

}  // namespace
}  // namespace unietp
