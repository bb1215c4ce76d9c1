#include "authoring/purpose_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Template with(const std::string& purpose, const std::string& init, const std::string& goal) {
  const auto reading = parse_template("t.template", "(template t (name \"t <A>\")" + purpose +
                                                        "(split atomic)(parameters (A - openable))" + init + "(goal " +
                                                        goal + ")(instruction \"Do {A}.\"))");
  EXPECT_TRUE(reading.errors.empty()) << format(reading.errors.front());
  return reading.templates.empty() ? Template() : reading.templates.front();
}

const std::string kOpen = "(init (exists (?a - A) (and)) (forall (?a - A) (open ?a)))";
const std::string kClosed = "(init (exists (?a - A) (and)) (forall (?a - A) (closed ?a)))";
const std::string kClose = "(exists (?a - A) (at-end (closed ?a)))";

TEST(PurposeFit, ATemplateWithAPurposeAndAReasonIsNotDoubtful) {
  EXPECT_THAT(doubtful_purpose(with("(purpose saving (because (open A)))", kOpen, kClose)), IsEmpty());
}

TEST(PurposeFit, NoPurposeAndNoReasonAreDoubtful) {
  EXPECT_THAT(doubtful_purpose(with("", kOpen, kClose)), ElementsAre(HasSubstr("no section (purpose ...)")));
  EXPECT_THAT(doubtful_purpose(with("(purpose saving)", kOpen, kClose)), ElementsAre(HasSubstr("gives no reason")));
}

TEST(PurposeFit, APurposeThatTheGoalDoesNotServeIsDoubtful) {
  const std::string hot = "(exists (?a - A) (at-end (hot ?a)))";
  EXPECT_THAT(doubtful_purpose(with("(purpose laundry (because (open A)))", kOpen, hot)),
              ElementsAre(HasSubstr("the purpose 'laundry' does not fit the goal")));
}

TEST(PurposeFit, AGoalThatEndsAsItStartedIsPointless) {
  const std::string back = "(exists (?a - A) (and (sometime (open ?a)) (at-end (closed ?a))))";
  EXPECT_THAT(doubtful_purpose(with("(purpose saving (because (closed A)))", kClosed, back)),
              ElementsAre(HasSubstr("nothing will have changed")));
  EXPECT_THAT(doubtful_purpose(with("(purpose comfort (because (closed A)))", kClosed, back)), IsEmpty())
      << "a room is aired";
}

TEST(PurposeFit, ReasonsReadAsSentences) {
  EXPECT_EQ(need_in_words({true, Predicate::Dirty, "A", "", {}}), "<A> is dirty");
  EXPECT_EQ(need_in_words({false, Predicate::Inside, "A", "B", {}}), "<A> is not inside <B>");
  EXPECT_EQ(need_in_words({true, Predicate::Filled, "A", "water", {}}), "<A> is filled with water");
  EXPECT_EQ(need_in_words({false, Predicate::InRoom, "agent", "R", {}}), "the agent is not in <R>");
}

TEST(PurposeFit, NoTemplateOfTheLibraryIsDoubtful) {
  for (const auto* folder : {"library", "extended"}) {
    const auto reading = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates" / folder);
    ASSERT_THAT(reading.errors, IsEmpty());
    for (const auto& source : reading.templates) EXPECT_THAT(doubtful_purpose(source), IsEmpty()) << source.name;
  }
}

}  // namespace
}  // namespace unietp
