// `unietp stats`, `report` and `review` as a user runs them; pages are looked at in headless Chromium.
#include <algorithm>
#include <optional>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "../report/browser.h"
#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "program.h"
#include "schema_checker.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using test::Browser;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::ordered_json;

constexpr int kCount = 10;
constexpr const char* kHostile = "</script><script>window.hurt = 1</script><img src=x onerror=hurt=2> \"a\" & 'b'";

/// A data set of every simulator and two modes, made once.
const fs::path& made() {
  static const ScratchFolder folder;
  static const fs::path path = [] {
    const auto ended =
        run_program({"generate", "--count", std::to_string(kCount), "--seed", "5", "--rooms", "5", "--objects", "25",
                     "--splits", "atomic,compositional,linguistic", "--modes", "M1,M2", "--out", folder.at("made")});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return fs::path(folder.at("made"));
  }();
  return path;
}

class Pages : public ::testing::Test {
 protected:
  Pages() { fs::copy(made(), data(), fs::copy_options::recursive); }
  fs::path data() const { return folder_.path() / "data"; }
  std::vector<Json> tasks(const fs::path& folder) const { return json_lines(folder / "tasks.jsonl"); }
  /// Puts a text into the data set that a page has to show as it is.
  void say(std::size_t task, const std::string& text) const {
    std::string lines;
    auto all = tasks(data());
    all.at(task)["instruction"]["text"] = text;
    for (const auto& one : all) lines += one.dump() + "\n";
    ASSERT_TRUE(write_file(data() / "tasks.jsonl", lines));
  }
  /// What the page would save.
  std::string review(const std::vector<Json>& reviews) const {
    const auto file = folder_.at("review.json");
    const Json json{{"format", "unietp-review/1"}, {"set", "data"}, {"tasks_sha256", "x"}, {"reviews", reviews}};
    SchemaChecker checker;
    EXPECT_EQ(checker.check(json, "review.schema.json"), "");
    EXPECT_TRUE(write_file(file, json.dump(1)));
    return file;
  }
  Json verdict(std::size_t task, const std::string& verdict, const std::string& text = "",
               const std::string& comment = "") const {
    const auto one = tasks(made()).at(task);
    Json json{{"task", one["id"]}, {"verdict", verdict}, {"instruction", one["instruction"]["text"]}};
    if (!text.empty()) json["text"] = text;
    json["comment"] = comment;
    return json;
  }
  Ended apply(const std::string& reviews, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"review", data().string(), "--apply", reviews};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  /// Another wording of the grammar, which is right.
  std::string another_wording(std::size_t task) const {
    const auto copy = folder_.at("reworded");
    const auto ended = run_program({"annotate", made().string(), "--seed", "99", "--phrasings", "all", "--out", copy});
    EXPECT_EQ(ended.code, 0) << ended.err;
    const std::string text = tasks(copy).at(task)["instruction"]["text"];
    EXPECT_NE(tasks(made()).at(task)["instruction"]["text"], text);
    return text;
  }
  ScratchFolder folder_;
};

TEST_F(Pages, StatsCountWhatTheFilesHold) {
  const auto ended = run_program({"stats", data().string(), "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = Json::parse(ended.out);
  SchemaChecker checker;
  EXPECT_EQ(checker.check(json, "statistics.schema.json"), "");
  const auto& set = json["sets"][0];
  const auto manifest = Json::parse(*read_file(data() / "manifest.json"));
  EXPECT_EQ(set["tasks"], kCount);
  EXPECT_EQ(set["candidates"], manifest["counts"]["candidates"]);
  EXPECT_EQ(set["templates"].size(), manifest["counts"]["by_template"].size());
  ASSERT_EQ(set["plans"].size(), 2U);
  EXPECT_EQ(set["plans"][1]["mode"], "M2");
  for (const auto& spread : manifest["counts"]["balance"]) {
    const auto own = std::find_if(set["balance"].begin(), set["balance"].end(),
                                  [&](const Json& one) { return one["dimension"] == spread["dimension"]; });
    ASSERT_NE(own, set["balance"].end()) << spread;
    EXPECT_DOUBLE_EQ((*own)["effective"].get<double>(), spread["effective"].get<double>());
  }
  EXPECT_EQ(run_program({"stats", data().string(), "--json", "--threads", "1"}).out, ended.out);
}

TEST_F(Pages, StatsOfTwoSetsStandSideBySide) {
  const auto ended = run_program({"stats", data().string(), made().string(), "--rows", "5"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("data    made"));
  EXPECT_THAT(ended.out, HasSubstr("more; --json prints all"));
  const auto none = run_program({"stats", folder_.at("none")});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("expected a finished data set"));
}

TEST_F(Pages, AReportDrawsItsChartsAndShowsTextsAsTheyAre) {
  if (!Browser::installed()) GTEST_SKIP() << needs::kChromium;
  for (std::size_t i = 0; i < kCount; ++i) say(i, kHostile);
  const auto page = folder_.at("report.html");
  const auto ended = run_program({"report", data().string(), "--out", page, "--examples", "4"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(*read_file(page), HasSubstr("(c) 2022 Chart.js Contributors"));
  Browser browser(folder_.path());
  browser.open(page);
  // A canvas on which something was drawn in the color of the first series.
  const auto drawn = browser.evaluate(
      "[...document.querySelectorAll('canvas')].map(c => { const p = c.getContext('2d').getImageData(0, 0, c.width, "
      "c.height).data; let n = 0; for (let i = 0; i < p.length; i += 4) n += p[i] === 0x1f && p[i + 1] === 0x5f && p[i "
      "+ 2] === 0xa8; return [c.id, n, c.getAttribute('aria-label').length]; })");
  EXPECT_GE(drawn.size(), 14U);
  for (const auto& chart : drawn) {
    const bool none_lost = chart[0] == "chart-funnel" || chart[0] == "chart-causes";  // nothing may have been given up
    EXPECT_TRUE(chart[1].get<int>() > 100 || none_lost) << chart;
    EXPECT_GT(chart[2].get<int>(), 20) << chart;
  }
  EXPECT_EQ(browser.evaluate("document.querySelectorAll('figure details table').length"), drawn.size());
  EXPECT_EQ(browser.evaluate("document.querySelector('[data-part=instruction]').textContent"), kHostile);
  EXPECT_EQ(browser.evaluate("document.querySelector('#example-count').textContent"), "1 of 4");
  browser.evaluate("document.querySelector('#examples').focus()");
  browser.press("ArrowRight");
  browser.until("document.querySelector('#example-count').textContent === '2 of 4'");
  browser.press("ArrowLeft");
  browser.press("ArrowLeft");
  browser.until("document.querySelector('#example-count').textContent === '4 of 4'");
  EXPECT_GT(browser.evaluate("document.querySelectorAll('[data-part=drawing] svg polygon').length").get<int>(), 20);
  browser.until("document.querySelector('[data-part=view]').naturalWidth >= 300");
  browser.evaluate("document.querySelector('#theme').click()");
  browser.until("getComputedStyle(document.body).backgroundColor === 'rgb(25, 26, 28)'");
  EXPECT_TRUE(browser.evaluate("typeof window.hurt === 'undefined'").get<bool>());
  EXPECT_THAT(browser.fetched, IsEmpty());
  EXPECT_THAT(browser.complaints, IsEmpty());
}

TEST_F(Pages, WhatIsJudgedInTheBrowserIsApplied) {
  if (!Browser::installed()) GTEST_SKIP() << needs::kChromium;
  const auto page = folder_.at("review.html");
  ASSERT_EQ(run_program({"review", data().string(), "--out", page}).code, 0);
  const auto all = tasks(made());
  const auto shown = [&](std::size_t i) {
    return "document.documentElement.dataset.shown === '" + all[i]["id"].get<std::string>() + "'";
  };
  std::string file;
  {
    Browser browser(folder_.path());
    browser.open(page);
    browser.until(shown(0));
    EXPECT_GT(browser.evaluate("document.querySelectorAll('[data-part=drawing] svg polygon').length").get<int>(), 20);
    browser.until("document.querySelector('[data-part=view]').naturalWidth === 256");
    browser.press("a");
    browser.until(shown(1));
    browser.press("r");
    browser.until(shown(2));
    browser.press("e");
    browser.type(another_wording(2));
    browser.press("Enter", true);
    browser.until(shown(3));
    browser.press("s");
    file = browser.saved_file();
    EXPECT_THAT(browser.complaints, IsEmpty());
  }
  const auto ended = apply(file);
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 accepted, 1 rejected, 1 edited, 0 not applied"));
  const auto left = tasks(data());
  ASSERT_EQ(left.size(), kCount - 1U);
  EXPECT_EQ(left[1]["id"], all[2]["id"]);
  EXPECT_EQ(left[1]["instruction"]["writer"], "person");
  EXPECT_EQ(left[1]["instruction"]["checks"], Json({"form", "parses-back", "style"}));
  const auto verdict = validate(data());
  EXPECT_EQ(verdict.code, 0) << (verdict.problems.empty() ? "" : verdict.problems[0].message);
  EXPECT_EQ(verdict.proven, kCount - 1);
  const auto once = bytes_below(data());
  EXPECT_EQ(apply(file).code, 0);  // what is in force already changes nothing
  EXPECT_EQ(bytes_below(data()), once);
}

TEST_F(Pages, VerdictsAreKeptAndTheNumbersAddUp) {
  const auto before = Json::parse(*read_file(data() / "manifest.json"));
  const auto file = review({verdict(0, "accept"), verdict(1, "reject", "", "two sofas look alike")});
  EXPECT_EQ(apply(file, {"--out", folder_.at("reviewed")}).code, 0);
  EXPECT_EQ(bytes_below(data()), bytes_below(made()));
  const fs::path out = folder_.at("reviewed");
  SchemaChecker checker;
  const auto marks = json_lines(out / "reviews.jsonl");
  ASSERT_EQ(marks.size(), 2U);
  for (const auto& mark : marks) EXPECT_EQ(checker.check(mark, "review-mark.schema.json"), "");
  const auto rejections = json_lines(out / "rejections.jsonl");
  EXPECT_EQ(rejections.back()["stage"], "review");
  EXPECT_EQ(rejections.back()["detail"], "two sofas look alike");
  EXPECT_EQ(checker.check(rejections.back(), "rejection.schema.json"), "");
  const auto manifest = Json::parse(*read_file(out / "manifest.json"));
  EXPECT_EQ(checker.check(manifest, "manifest.schema.json"), "");
  EXPECT_EQ(manifest["counts"]["tasks"], kCount - 1);
  EXPECT_EQ(manifest["counts"]["candidates"], before["counts"]["candidates"]);
  EXPECT_EQ(manifest["counts"]["rejections"]["review"]["rejected"], 1);
  EXPECT_EQ(manifest["reviews"], Json({{"accepted", 1}, {"rejected", 1}, {"edited", 0}}));
  std::set<std::string> homes, files;
  for (const auto& task : tasks(out)) homes.insert(task["layout"].get<std::string>() + ".scene.json.gz");
  for (const auto& entry : fs::directory_iterator(out / "homes")) files.insert(entry.path().filename().string());
  EXPECT_EQ(files, homes);  // none of a task that is gone
  EXPECT_EQ(json_lines(out / "demonstrations" / "M2.jsonl").size(), kCount - 1U);
  EXPECT_EQ(validate(out).code, 0);
  EXPECT_EQ(apply(file, {"--out", folder_.at("kept"), "--keep-rejected"}).code, 0);
  EXPECT_EQ(tasks(folder_.at("kept")).size(), static_cast<std::size_t>(kCount));
  EXPECT_EQ(validate(folder_.at("kept")).code, 0);
}

TEST_F(Pages, AnEditThatSaysSomethingElseIsRefusedByName) {
  const std::string wrong = "Please set fire to the house.";
  const auto file = review({verdict(0, "edit", wrong), verdict(1, "accept")});
  const auto ended = apply(file);
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr(tasks(made())[0]["id"].get<std::string>() + ": not applied: \"" + wrong));
  EXPECT_THAT(ended.out, HasSubstr("1 accepted, 0 rejected, 0 edited, 1 not applied"));
  EXPECT_EQ(tasks(data())[0], tasks(made())[0]);
  EXPECT_EQ(apply(file, {"--accept-unchecked"}).code, 0);
  const auto instruction = tasks(data())[0]["instruction"];
  EXPECT_EQ(instruction["text"], wrong);
  EXPECT_EQ(instruction["writer"], "person:unchecked");
  EXPECT_EQ(instruction["checks"], Json({"form", "style"}));
  const auto found = validate(data());
  EXPECT_EQ(found.code, 1);
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_EQ(found.problems[0].kind, "text-unchecked");
  EXPECT_EQ(found.problems[0].task, tasks(data())[0]["id"]);
  EXPECT_EQ(found.proven, kCount - 1);
}

TEST_F(Pages, OfATextThatIsEditedTwiceTheFirstIsKept) {
  const std::string wrong = "Please set fire to the house.";
  ASSERT_EQ(apply(review({verdict(0, "edit", wrong)}), {"--accept-unchecked"}).code, 0);
  auto again = verdict(0, "edit", another_wording(0));
  again["instruction"] = wrong;
  ASSERT_EQ(apply(review({again})).code, 0);
  EXPECT_EQ(json_lines(data() / "reviews.jsonl").at(0)["before"], tasks(made())[0]["instruction"]["text"]);
  EXPECT_EQ(validate(data()).code, 0);
}

TEST_F(Pages, AVerdictOnAnotherTextIsRefused) {
  auto stale = verdict(0, "reject");
  stale["instruction"] = "An older text.";
  auto nobody = verdict(1, "accept");
  nobody["task"] = "ai2thor-99999";
  const auto ended = apply(review({stale, nobody}));
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("its text has changed"));
  EXPECT_THAT(ended.out, HasSubstr("ai2thor-99999: not applied: no such task"));
  EXPECT_EQ(tasks(data()).size(), static_cast<std::size_t>(kCount));
  const auto bad = folder_.at("bad.json");
  ASSERT_TRUE(write_file(bad, "{\"format\": \"unietp-review/1\"}"));
  EXPECT_EQ(apply(bad).code, 2);
}

TEST_F(Pages, ADamagedDemonstrationIsNamedAndNothingChanges) {
  const auto file = data() / "demonstrations/M1.jsonl";
  auto text = *read_file(file);
  const auto steps = text.find("\"steps\":");
  ASSERT_NE(steps, std::string::npos);
  ASSERT_TRUE(write_file(file, text.replace(steps, 8, "\"stops\":")));
  const auto before = bytes_below(data());
  const auto ended = apply(review({verdict(1, "accept")}));
  EXPECT_EQ(ended.code, 2) << ended.out << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("M1.jsonl:1"));
  EXPECT_EQ(bytes_below(data()), before);
}

}  // namespace
}  // namespace unietp
