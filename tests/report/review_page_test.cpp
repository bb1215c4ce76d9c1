// The page that people judge by, in a real browser.
#include "report/review_page.h"

#include <filesystem>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "browser.h"
#include "core/files.h"
#include "report/review_file.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using test::Browser;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kHostile =
    "</script><script>window.hurt = 1</script><img src=x onerror='hurt=2'> \"quoted\" & 'so'";

TaskRecord task(int i) {
  TaskRecord one;
  one.id = "ai2thor-" + std::to_string(i);
  one.template_name = i % 2 == 0 ? "open-one" : "close-one";
  one.split = i % 3 == 0 ? "atomic" : "logical";
  one.simulator = i % 5 == 0 ? "habitat" : "ai2thor";
  one.layout = "home-" + std::to_string(i / 25);
  one.goal_text = "(at-end (exists (?a - Fridge) (open ?a)))";
  one.goal_tree = *parse_formula("goal", one.goal_text, FormulaUse::Goal);
  one.instruction = i == 1 ? kHostile : "Open fridge number " + std::to_string(i) + ", please.";
  one.style = "direct";
  one.purpose = "comfort";
  one.because = {"fridge is closed"};
  one.grade = i == 1 ? "tolerable" : "usual";
  one.sense = {{"open fridge", one.grade, "written"}};
  return one;
}

FinishedSet set_of(int count) {
  FinishedSet set;
  set.name = "many";
  set.digest = "digest-" + std::to_string(count);
  return set;
}

std::vector<ReviewEntry> list_of(int count) {
  std::vector<ReviewEntry> list;
  for (int i = 0; i < count; ++i) {
    const TaskRecord one = task(i);
    list.push_back({one.id, one.simulator, one.split, one.template_name, one.instruction, one.layout});
  }
  return list;
}

/// The tasks from the first on.
ShownTaskSource tasks_of(int count) {
  return [count, i = 0]() mutable -> std::optional<Result<ShownTask>> {
    if (i == count) return std::nullopt;
    return ShownTask{task(i++),
                     {{Mode::M1, {{"go_to(fridge_1)", true, ""}, {"open(fridge_1)", false, "It is stuck."}}},
                      {Mode::M3, {{"stop", true, ""}}}}};
  };
}

Result<StartPictures> pictures(const TaskRecord& task) {
  const std::string number = task.id.substr(std::string("ai2thor-").size());
  return StartPictures{
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10\" height=\"10\" viewBox=\"0 0 10 10\"><title>t</title>"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\" onclick=\"window.hurt=3\"/><g><title>mug</title><circle "
      "cx=\"1\" cy=\"2\" r=\"1\"/></g><script>window.hurt = 4</script><text x=\"1\" y=\"1\">home " +
          number + "</text></svg>",
      std::string("\x89PNG\r\n\x1a\n", 8) + number};
}

Result<std::string> page_of(int count, int threads) {
  return review_page(set_of(count), list_of(count), tasks_of(count), threads, pictures);
}

class ReviewPage : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!Browser::installed()) GTEST_SKIP() << needs::kChromium;
    folder_ = fs::temp_directory_path() / ("review_page_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    browser_.emplace(folder_);
  }
  void TearDown() override {
    browser_.reset();
    std::error_code left;  // a process of Chromium's may still be writing to the profile
    if (!folder_.empty()) fs::remove_all(folder_, left);
  }
  /// Writes and opens the page of so many tasks; its size in bytes.
  std::size_t open(int count) {
    const auto page = page_of(count, 2);
    EXPECT_TRUE(page);
    const auto file = folder_ / "review.html";
    EXPECT_TRUE(write_file(file, *page));
    browser_->open(file);
    at("ai2thor-0");
    return page->size();
  }
  void at(const std::string& task) { browser_->until("document.documentElement.dataset.shown === '" + task + "'"); }
  std::string text(const std::string& selector) {
    return browser_->evaluate("document.querySelector('" + selector + "').textContent").get<std::string>();
  }
  std::vector<Review> saved() {
    browser_->press("s");
    const auto file = browser_->saved_file();
    const auto bytes = read_file(file);
    const auto reviews = read_reviews(file, bytes ? *bytes : "");
    EXPECT_TRUE(reviews) << (reviews ? "" : format(reviews.error()));
    fs::remove(file);
    return reviews ? *reviews : std::vector<Review>();
  }
  void expect_quiet() {
    EXPECT_THAT(browser_->fetched, IsEmpty());
    EXPECT_TRUE(browser_->evaluate("typeof window.hurt === 'undefined'").get<bool>());
    EXPECT_THAT(browser_->complaints, ::testing::Each(HasSubstr("inline event handler")));  // of the drawing; stopped
  }

  fs::path folder_;
  std::optional<Browser> browser_;
};

TEST_F(ReviewPage, KeysJudgeAndTheSavedFileIsReadBack) {
  open(30);
  browser_->press("a");
  at("ai2thor-1");
  EXPECT_EQ(text("[data-part=instruction]"), kHostile);
  browser_->press("r");
  at("ai2thor-2");
  browser_->press("e");
  browser_->type("Shut the fridge at once.");
  browser_->press("Enter", true);
  at("ai2thor-3");
  browser_->press("c");
  browser_->type("hard to see");
  browser_->press("Enter");
  browser_->press("a");
  at("ai2thor-4");
  browser_->press("a");
  at("ai2thor-5");
  browser_->press("k");
  at("ai2thor-4");
  browser_->press("u");
  EXPECT_THAT(text("#counts"), HasSubstr("4 of 30 reviewed: 2 accepted, 1 rejected, 1 edited"));
  const std::vector<Review> expected{
      {"ai2thor-0", Judgment::Accept, "Open fridge number 0, please.", "", ""},
      {"ai2thor-1", Judgment::Reject, kHostile, "", ""},
      {"ai2thor-2", Judgment::Edit, "Open fridge number 2, please.", "Shut the fridge at once.", ""},
      {"ai2thor-3", Judgment::Accept, "Open fridge number 3, please.", "", "hard to see"}};
  EXPECT_EQ(saved(), expected);
  expect_quiet();
  // Nothing is lost when the page is closed.
  browser_->open(folder_ / "review.html");
  at("ai2thor-0");
  EXPECT_THAT(text("#counts"), HasSubstr("4 of 30 reviewed"));
  EXPECT_EQ(saved(), expected);
}

TEST_F(ReviewPage, ShowsGoalPlanAndPicturesAndOnlyThose) {
  open(30);
  EXPECT_THAT(text("[data-part=goal]"), HasSubstr("for some fridge a:"));
  EXPECT_THAT(text("[data-part=plan]"), HasSubstr("open(fridge_1) ✗ It is stuck."));
  browser_->press("m");
  EXPECT_EQ(text("[data-part=plan]"), "stop");
  browser_->press("j");
  at("ai2thor-1");
  EXPECT_EQ(text("[data-part=plan]"), "stop");  // the mode that was chosen
  EXPECT_THAT(text("[data-part=drawing] svg"), HasSubstr("home 1"));
  EXPECT_TRUE(browser_
                  ->evaluate("!document.querySelector('[data-part=drawing] script') && "
                             "!document.querySelector('[data-part=drawing] [onclick]')")
                  .get<bool>());
  expect_quiet();
}

TEST_F(ReviewPage, AFilterAndASearchLeaveTheirTasks) {
  open(30);
  browser_->evaluate(
      "const s = document.querySelector('#simulator'); s.value = 'habitat'; s.dispatchEvent(new "
      "Event('change'))");
  EXPECT_EQ(text("#shown"), "6");
  browser_->press("a");
  at("ai2thor-5");
  browser_->evaluate(
      "const t = document.querySelector('#state'); t.value = 'open'; t.dispatchEvent(new Event('change'))");
  EXPECT_EQ(text("#shown"), "5");
  browser_->press("/");
  browser_->type("number 25");
  at("ai2thor-25");
  EXPECT_EQ(text("#shown"), "1");
  browser_->press("Escape");
  browser_->press("r");
  browser_->evaluate(
      "document.querySelector('#search').value = 'nothing'; document.querySelector('#search').dispatchEvent(new "
      "Event('input'))");
  EXPECT_EQ(text("#shown"), "0");
  EXPECT_TRUE(browser_->evaluate("document.querySelector('#card').hidden").get<bool>());
  expect_quiet();
}

TEST_F(ReviewPage, SaysWhatTheTaskIsForAndHowMuchSenseItMakes) {
  open(3);
  EXPECT_EQ(text("[data-part=purpose]"), "For comfort, because fridge is closed.");
  EXPECT_EQ(text("[data-part=sense]"), "Sense: usual (open fridge: usual, written).");
  browser_->press("j");
  at("ai2thor-1");
  EXPECT_EQ(text("[data-part=sense]"), "Sense: tolerable (open fridge: tolerable, written).");
}

TEST_F(ReviewPage, TenThousandTasksPageThrough) {
  EXPECT_LT(open(10'000), 20'000'000U);  // without real pictures
  EXPECT_THAT(text("#counts"), HasSubstr("of 10,000 reviewed"));
  browser_->evaluate(
      "document.querySelector('#jump').value = 10000; document.querySelector('#jump').dispatchEvent(new "
      "Event('change'))");
  at("ai2thor-9999");
  browser_->press("k");
  at("ai2thor-9998");
  browser_->press("a");
  at("ai2thor-9999");
  // One task is in the page, not ten thousand.
  EXPECT_LT(browser_->evaluate("document.querySelectorAll('body *:not(script)').length").get<int>(), 300);
  expect_quiet();
}

TEST(ReviewPageBytes, AreTheSameForAnyNumberOfThreads) {
  const auto one = page_of(120, 1), four = page_of(120, 4);
  ASSERT_TRUE(one && four);
  EXPECT_EQ(*one, *four);
}

TEST(ReviewPageBytes, AreOfTheTasksOfTheList) {
  for (const int read : {29, 31}) {
    const auto page = review_page(set_of(30), list_of(30), tasks_of(read), 2, pictures);
    ASSERT_FALSE(page) << read;
    EXPECT_THAT(page.error().message, HasSubstr("was changed while it was read"));
  }
  const auto fails = [](const TaskRecord& task) -> Result<StartPictures> {
    return Error{Error::Kind::Io, task.id, {}, "has no picture"};
  };
  const auto page = review_page(set_of(30), list_of(30), tasks_of(30), 2, fails);
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().where, "ai2thor-0");
}

}  // namespace
}  // namespace unietp
