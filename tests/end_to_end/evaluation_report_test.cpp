// The report of an evaluation in a browser, opened from the disk as people do.
#include <map>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../report/browser.h"
#include "core/files.h"
#include "data_set.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using test::Browser;
using ::testing::Each;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A run with more episodes than a page has, made once for all tests of this process.
const fs::path& evaluated() {
  static const ScratchFolder kScratch;
  static const fs::path kRun = [] {
    const Ended made = run_program({"evaluate", data_set_in_all_modes().string(), "--policy", "noisy:0.3", "--modes",
                                    "M1,M3", "--repeats", "5", "--out", kScratch.at("run")});
    EXPECT_EQ(made.code, 0) << made.err;
    return fs::path(kScratch.at("run"));
  }();
  return kRun;
}

class EvaluationReport : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!Browser::installed()) GTEST_SKIP() << needs::kChromium;
    fs::copy(evaluated(), run(), fs::copy_options::recursive);
  }
  fs::path run() const { return folder_.path() / "run"; }
  static int episodes() { return 2 * 5 * kCountInAllModes; }

  ScratchFolder folder_;
};

std::string text(Browser& browser, const std::string& selector) {
  return browser.evaluate("document.querySelector('" + selector + "').textContent").get<std::string>();
}
/// A click as a person makes it, on what the selector finds first.
void click(Browser& browser, const std::string& selector) {
  browser.evaluate("document.querySelector('" + selector + "').click()");
}

TEST_F(EvaluationReport, PlaysTheEpisodesThatANumberOfATableLeadsTo) {
  Browser browser(folder_.path());
  browser.open(run() / "report.html");
  browser.until("!document.querySelector('#viewer').hidden");
  EXPECT_THAT(text(browser, "#shown"), HasSubstr(std::to_string(episodes()) + " of " + std::to_string(episodes())));

  // From a cell of the table of failures to its episodes.
  const auto filter = browser.evaluate("document.querySelector('#table-failures tbody td a').dataset.filter");
  EXPECT_THAT(filter.get<std::string>(), HasSubstr("class="));
  const auto count = browser.evaluate("Number(document.querySelector('#table-failures tbody td a').textContent)");
  click(browser, "#table-failures tbody td a");
  EXPECT_EQ(browser.evaluate("document.querySelectorAll('#list tr').length"), count);
  const auto kinds =
      browser.evaluate("[...document.querySelectorAll('#list tr')].map(row => row.cells[2].textContent)");
  const auto kind = browser.evaluate(
      "new URLSearchParams(document.querySelector('#table-failures tbody td a').dataset.filter).get('class')");
  for (const auto& one : kinds) EXPECT_THAT(one.get<std::string>(), HasSubstr(kind.get<std::string>()));

  // The last episode lies on another page than the first; it is played to its end.
  click(browser, "#clear");
  click(browser, "#list tr:last-child a");
  const std::string last = text(browser, "#list tr:last-child a");
  const std::string id = last.substr(0, last.find(' '));
  browser.until("document.querySelector('[data-part=tags]').textContent.includes('" + id + "')");
  const auto first_said = text(browser, "[data-part=said]");
  EXPECT_THAT(first_said, HasSubstr("\"action\""));
  EXPECT_EQ(text(browser, "[data-part=place]").substr(0, 10), "reply 1 of");
  while (!browser.evaluate("document.querySelector('[data-part=next]').disabled").get<bool>())
    click(browser, "[data-part=next]");
  EXPECT_EQ(text(browser, "[data-part=place]"), "the end");
  EXPECT_GT(browser.evaluate("document.querySelectorAll('[data-part=expert] li').length").get<int>(), 1);

  // A bar of the chart of failures.
  browser.evaluate("charts[0].options.onClick({}, [{index: 0, datasetIndex: 0}])");
  EXPECT_GT(browser.evaluate("document.querySelectorAll('#list tr').length").get<int>(), 0);
  EXPECT_LT(browser.evaluate("document.querySelectorAll('#list tr').length").get<int>(), episodes());

  EXPECT_THAT(browser.complaints, IsEmpty());
  EXPECT_THAT(browser.fetched, Each(HasSubstr("/run/report/")));
}

TEST_F(EvaluationReport, ShowsWhatWasSeenWhereItHasPictures) {
  Browser browser(folder_.path());
  browser.open(run() / "report.html");
  browser.until("!document.querySelector('#viewer').hidden");
  EXPECT_GT(browser.evaluate("document.querySelector('[data-part=picture] img').naturalWidth").get<int>(), 100);
}

TEST_F(EvaluationReport, ShowsWhatWasThoughtDoneAndTold) {
  ASSERT_TRUE(write_file(folder_.path() / "agent.py", R"(import json, sys
for line in sys.stdin:
    call = json.loads(line)
    begins = call['method'] == 'begin'
    reach = {'action': 'pick_up', 'args': [{'bbox': [0, 0, 1, 1]}]}
    result = {'action': reach if begins else 'stop', 'thinking': 'It may be in the corner.' if begins else ''}
    print(json.dumps({'jsonrpc': '2.0', 'id': call['id'], 'result': result}), flush=True)
)"));
  const Ended made =
      run_program({"evaluate", data_set_in_all_modes().string(), "--policy", "python3 " + folder_.at("agent.py"),
                   "--modes", "M3", "--limit", "1", "--out", folder_.at("thinker")});
  ASSERT_EQ(made.code, 0) << made.err;
  Browser browser(folder_.path());
  browser.open(folder_.path() / "thinker" / "report.html");
  browser.until("!document.querySelector('#viewer').hidden && document.querySelector('[data-part=picture] img')");
  EXPECT_EQ(text(browser, "[data-part=thinking]"), "It may be in the corner.");
  EXPECT_THAT(text(browser, "[data-part=done] li"), HasSubstr("pick_up"));
  EXPECT_EQ(browser.evaluate("document.querySelectorAll('[data-part=picture] rect.named').length"), 1);
  EXPECT_GT(browser.evaluate("document.querySelectorAll('[data-part=picture] rect').length"), 1) << "what is in view";
  const std::string why = text(browser, "[data-part=done] .feedback");
  EXPECT_GT(why.size(), 10U);
  click(browser, "[data-part=next]");
  EXPECT_THAT(text(browser, "[data-part=told]"), HasSubstr(why.substr(why.find(' ') + 1))) << "before the next reply";
  EXPECT_EQ(text(browser, "[data-part=thinking]"), "–");
  EXPECT_THAT(browser.complaints, IsEmpty());
}

TEST_F(EvaluationReport, ShowsThePartsOfTheGoalTurningTrue) {
  ASSERT_EQ(run_program({"evaluate", data_set_in_all_modes().string(), "--policy", "replay", "--modes", "M1", "--out",
                         folder_.at("replay")})
                .code,
            0);
  Browser browser(folder_.path());
  browser.open(folder_.path() / "replay" / "report.html");
  browser.until("!document.querySelector('#viewer').hidden");
  const auto count = [&](const std::string& selector) {
    return browser.evaluate("document.querySelectorAll('[data-part=parts] " + selector + "').length").get<int>();
  };
  const int parts = count("li"), at_first = count("li.met");
  EXPECT_GT(parts, 0);
  int at_last = at_first;
  while (!browser.evaluate("document.querySelector('[data-part=next]').disabled").get<bool>()) {
    click(browser, "[data-part=next]");
    at_last = count("li.met");
  }
  EXPECT_LT(at_first, parts);
  EXPECT_EQ(at_last, parts);
  EXPECT_THAT(browser.complaints, IsEmpty());
}

TEST_F(EvaluationReport, SaysSoWhenItsEpisodesAreMissing) {
  fs::remove_all(run() / "report");
  Browser browser(folder_.path());
  browser.open(run() / "report.html");
  browser.until("document.querySelector('#shown').textContent.includes('cannot be read')");
  EXPECT_GT(browser.evaluate("document.querySelectorAll('#table-main td').length").get<int>(), 0);
}

TEST_F(EvaluationReport, AndALeaderboardOfSeveralRunsRanksThem) {
  ASSERT_EQ(run_program({"evaluate", data_set_in_all_modes().string(), "--policy", "replay", "--modes", "M1,M3",
                         "--out", folder_.at("replay")})
                .code,
            0);
  ASSERT_EQ(run_program({"compare", folder_.at("run"), folder_.at("replay"), "--out", folder_.at("board")}).code, 0);
  Browser browser(folder_.path());
  browser.open(folder_.path() / "board" / "leaderboard.html");
  const auto agents = browser.evaluate(
      "[...document.querySelectorAll('#table-ranks-M1 tbody tr')].map(row => row.cells[1].textContent)");
  EXPECT_EQ(agents, nlohmann::json({"replay", "noisy:0.3"}));
  EXPECT_GT(browser.evaluate("document.querySelectorAll('#table-main tbody tr').length"), 1);
  EXPECT_THAT(browser.complaints, IsEmpty());
  EXPECT_THAT(browser.fetched, IsEmpty());

  // A name leads to the run's report, a rate of the second run to its episodes there.
  const auto href = [&](const std::string& selector) {
    return browser.evaluate("document.querySelector('" + selector + "').href").get<std::string>();
  };
  EXPECT_THAT(href("#table-ranks-M1 tbody tr:first-child td:nth-child(2) a"), HasSubstr("/replay/report.html#run=1"));
  const std::string rate = href("#table-m3 tbody tr:last-child td:nth-child(2) a");
  EXPECT_THAT(rate, EndsWith("/replay/report.html#run=1&mode=M3&split=atomic"));
  browser.visit(rate);
  browser.until("!document.querySelector('#viewer').hidden");
  const int atomic =
      browser.evaluate("episodes.filter(e => e.mode === 'M3' && e.split === 'atomic').length").get<int>();
  EXPECT_GT(atomic, 0);
  EXPECT_LT(atomic, 2 * kCountInAllModes);
  EXPECT_EQ(browser.evaluate("document.querySelectorAll('#list tr').length"), atomic);
}

TEST_F(EvaluationReport, LeadsFromEachCountToAsManyEpisodes) {
  Browser browser(folder_.path());
  browser.open(run() / "report.html");
  browser.until("!document.querySelector('#viewer').hidden");
  // Of each link in a table: the number that it shows, of what, and how many episodes it leads to.
  const auto links =
      browser.evaluate(R"js([...document.querySelectorAll('table[id^=table-] a[data-filter]')].map(link => {
    link.click();
    const table = link.closest('table'), column = link.parentElement.cellIndex;
    return [table.id, table.tHead.rows[table.tHead.rows.length - 1].cells[column].textContent, link.textContent,
            listed.length, listed.filter(e => e.success).length];
  }))js");
  std::map<std::string, int> seen;
  for (const auto& [table, column, shown, episodes, successes] :
       links.get<std::vector<std::tuple<std::string, std::string, std::string, int, int>>>()) {
    SCOPED_TRACE(table + ", " + column + ": " + shown);
    ++seen[table + " " + column];
    EXPECT_GT(episodes, 0);
    const bool counts = column == "Episodes" || column == "Successes" || table == "table-failures";
    if (counts) {
      EXPECT_EQ(std::stoi(shown), episodes);
    }
    if (column == "Successes") {
      EXPECT_EQ(successes, episodes);
    }
    if (table == "table-behaviour" && column == "Success rate") {
      EXPECT_NEAR(std::stod(shown), 100.0 * episodes / (5 * kCountInAllModes), 0.06);
    }
    if (table == "table-behaviour" && column == "Wrong") {
      EXPECT_EQ(successes, 0);
    }
  }
  for (const char* one : {"table-behaviour Episodes", "table-behaviour Success rate", "table-behaviour with stop",
                          "table-behaviour Wrong", "table-boxes Boxes", "table-boxes Hit rate", "table-repeats Tasks",
                          "table-steps-M1 Successes", "table-steps-M3 Episodes"})
    EXPECT_GT(seen[one], 0) << one;
  EXPECT_THAT(browser.complaints, IsEmpty());
}

TEST_F(EvaluationReport, HasPicturesOfAsManyEpisodesAsAreAskedFor) {
  const auto pictured = [&] {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(run() / "report")) {
      const std::string page = *read_file(entry.path());
      for (auto at = page.find("\"images\":[\""); at != std::string::npos; at = page.find("\"images\":[\"", at + 1))
        ++count;
    }
    return count;
  };
  EXPECT_EQ(pictured(), 40);
  for (const int wanted : {2, 44}) {
    const Ended again = run_program({"evaluate", data_set_in_all_modes().string(), "--policy", "noisy:0.3", "--modes",
                                     "M1,M3", "--repeats", "5", "--resume", "--report-pictures", std::to_string(wanted),
                                     "--out", run().string()});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(pictured(), wanted);
    const Ended checked = run_program({"validate", run().string(), "--dataset", data_set_in_all_modes().string()});
    EXPECT_EQ(checked.code, 0) << checked.out;
  }
}

/// The report stays light: its episodes are in pages beside it.
TEST_F(EvaluationReport, HasItsEpisodesInPagesBesideIt) {
  std::size_t pages = 0;
  for (const auto& entry : fs::directory_iterator(run() / "report")) {
    EXPECT_THAT(entry.path().filename().string(), EndsWith(".html"));
    ++pages;
  }
  EXPECT_EQ(pages, static_cast<std::size_t>((episodes() + 31) / 32));
  const std::string page = *read_file(run() / "report.html");
  const std::string list = page.substr(page.find("id=\"data\""));
  EXPECT_LT(list.find("</script>"), 500U * static_cast<std::size_t>(episodes()));
}

}  // namespace
}  // namespace unietp
