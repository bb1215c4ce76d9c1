#include "validator/review_check.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "tests/support/scratch_folder.h"
#include "validator/candidate_check.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string mark(int slot, const std::string& verdict, const std::string& before = "",
                 const std::string& comment = "") {
  return R"({"format":"unietp-review-mark/1","task":")" + task_id_of("habitat", slot) + R"(","verdict":")" + verdict +
         "\"," + (before.empty() ? "" : R"("before":")" + before + "\",") + R"("comment":")" + comment + "\"}\n";
}

/// A set of three tasks, of which the second one's text is by a person, and one that a review took out.
class Reviewed : public ::testing::Test {
 protected:
  /// With the counts of the verdicts in the manifest.
  std::vector<std::string> found(const std::string& reviews) {
    const auto count = [&](const std::string& verdict) {
      const auto lines = split(reviews, '\n');
      return static_cast<int>(std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
        return line.find('"' + verdict + '"') != std::string::npos;
      }));
    };
    manifest_.reviews = RecordedReviews{count("accept"), count("reject"), count("edit")};
    return found_uncounted(reviews);
  }
  std::vector<std::string> found_uncounted(const std::string& reviews) {
    EXPECT_TRUE(write_file(folder_.path() / "reviews.jsonl", reviews));
    return found();
  }
  std::vector<std::string> found() {
    ReviewCheck check(folder_.path(), manifest_);
    TaskNames names;
    for (int slot = 0; slot < 3; ++slot) {
      TaskRecord task;
      task.id = task_id_of("habitat", slot);
      task.instruction = "Open the fridge.";
      task.writer = slot == 1 ? "person" : "grammar";
      check.add(task);
      names.add(task.id);
    }
    check.add(RejectionRecord{3, 0, "open-one", "habitat", "atomic", "expert", "no-plan", ""});
    check.add(RejectionRecord{4, 0, "open-one", "habitat", "atomic", "review", "rejected", "dull"});
    EXPECT_EQ(check.edited(), 2);
    const ProblemList problems = check.finish(names);
    EXPECT_EQ(problems.count(ProblemKind::Reviews), static_cast<std::int64_t>(problems.kept().size()));
    std::vector<std::string> messages;
    for (const Problem& problem : problems.kept()) messages.push_back(problem.error.message);
    return messages;
  }

  const std::string edit_ = mark(1, "edit", "Open a fridge."), removal_ = mark(4, "reject", "", "dull");
  ManifestRecord manifest_;

  ScratchFolder folder_;
};

TEST_F(Reviewed, EachEditAndRejectionHasItsLine) {
  EXPECT_THAT(found(edit_ + removal_), IsEmpty());
  EXPECT_THAT(found(mark(0, "accept") + edit_ + removal_), IsEmpty()) << "what people say of other tasks is theirs";
  EXPECT_THAT(found(removal_), ElementsAre(HasSubstr("lacks the edit of habitat-00002")));
  EXPECT_THAT(found(edit_), ElementsAre(HasSubstr("lacks the decision to take out habitat-00005")));
}
TEST_F(Reviewed, TheVerdictsAreAsManyAsTheManifestSays) {
  const std::string all = mark(0, "accept") + edit_ + removal_;
  EXPECT_THAT(found_uncounted(all), ElementsAre(HasSubstr("but the manifest says of no reviews")));
  EXPECT_THAT(found(all), IsEmpty());
  const auto wrong = ElementsAre(HasSubstr("but the manifest says 1 accepted, 1 rejected and 1 edited"));
  EXPECT_THAT(found_uncounted(edit_ + removal_), wrong);
  EXPECT_THAT(found_uncounted(mark(0, "reject") + edit_ + removal_), wrong);
  EXPECT_THAT(found_uncounted(all), IsEmpty());
}
TEST_F(Reviewed, TheFormerTextsAreThoseOfTheEdits) {
  EXPECT_THAT(found(mark(0, "accept") + edit_ + removal_), IsEmpty());
  EXPECT_THAT(former_texts(folder_.path()), ElementsAre(::testing::Pair("habitat-00002", "Open a fridge.")));
}
TEST_F(Reviewed, TheFileMayBeMissingOnlyWhenNothingWasDecided) {
  EXPECT_THAT(found(), ElementsAre(HasSubstr("lacks the edit"), HasSubstr("lacks the decision")));
}
TEST_F(Reviewed, AnEditIsOfATextByAPerson) {
  const std::string other = mark(2, "edit", "Open a fridge.");
  EXPECT_THAT(found(edit_ + other + removal_),
              ElementsAre(HasSubstr("the instruction of habitat-00003 is not by a person")));
  manifest_.writing.emplace();  // texts were written again after the review
  EXPECT_THAT(found(edit_ + other + removal_), IsEmpty());
}
TEST_F(Reviewed, AnEditHasTheFormerTextAndNothingElseHas) {
  EXPECT_THAT(found(mark(1, "edit", "Open the fridge.") + removal_),
              ElementsAre(HasSubstr("has the present text of habitat-00002")));
  EXPECT_THAT(found(mark(0, "accept", "Open a fridge.") + edit_ + removal_),
              ElementsAre(HasSubstr("must have the former text for an edit")));
}
TEST_F(Reviewed, ATaskThatWasTakenOutWasRejectedWithTheSameComment) {
  EXPECT_THAT(found(edit_ + mark(4, "reject", "", "too dull")), ElementsAre(HasSubstr("has a different comment")));
  EXPECT_THAT(found(edit_ + mark(4, "accept", "", "dull")), ElementsAre(HasSubstr("is not a rejection")));
}
TEST_F(Reviewed, TasksAreOfTheSetAndInOrderEachOnce) {
  EXPECT_THAT(found(edit_ + mark(3, "reject") + removal_), ElementsAre(HasSubstr("neither a task nor a rejection")));
  EXPECT_THAT(found(removal_ + edit_), ElementsAre(HasSubstr("expected the tasks in order of id")));
  EXPECT_THAT(found(mark(0, "accept") + mark(0, "accept") + edit_ + removal_),
              ElementsAre(HasSubstr("expected the tasks in order of id")));
}

}  // namespace
}  // namespace unietp
