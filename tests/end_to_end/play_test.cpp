// `unietp play` as a person uses it: lines in the terminal, clicks in the page, both in one session.
#include <signal.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../report/browser.h"
#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "served.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::Browser;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

Json demonstration(const std::string& mode, std::size_t task) {
  return json_lines(data_set_in_all_modes() / "demonstrations" / (mode + ".jsonl")).at(task);
}

/// A step as a person types it.
std::string typed_line(const Json& step) {
  std::string line = replace_all(step["action"], "_", " ");
  for (const auto& argument : step["args"])
    line += " " + (argument.is_string()
                       ? argument.get<std::string>()
                       : replace_all(argument["bbox"].dump().substr(1, argument["bbox"].dump().size() - 2), " ", ""));
  return line;
}

std::string play_command(const std::string& mode, std::size_t task, const std::string& options) {
  const std::string id = demonstration(mode, task)["task"];
  return "play '" + (data_set_in_all_modes() / id).string() + "' --mode " + mode + " " + options;
}

TEST(PlayInTheTerminal, TheStepsOfADemonstrationReachTheGoalInEachMode) {
  for (const std::string mode : {"M1", "M2", "M3"}) {
    SCOPED_TRACE(mode);
    const auto shown = demonstration(mode, 0);
    std::string lines;
    for (const auto& step : shown["steps"]) lines += typed_line(step) + "\n";
    const ScratchFolder scratch;
    ASSERT_TRUE(write_file(scratch.path() / "lines", lines));
    const auto ended = run_script("unietp " + play_command(mode, 0, "--no-page") + " < lines", scratch.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("Task " + shown["task"].get<std::string>() + ": "));
    EXPECT_THAT(ended.out, HasSubstr("The episode is over: the goal is reached."));
    EXPECT_THAT(ended.out, Not(HasSubstr("failed")));
  }
}

TEST(PlayInTheTerminal, ATextOfTheDataSetMovesNoCursor) {
  const ScratchFolder scratch;
  const fs::path set = scratch.path() / "set";
  fs::copy(data_set_in_all_modes(), set, fs::copy_options::recursive);
  auto tasks = json_lines(set / "tasks.jsonl");
  tasks[0]["instruction"]["text"] = "Put \xE2\x80\xAE it there.";
  std::string lines;
  for (const auto& task : tasks) lines += task.dump() + "\n";
  ASSERT_TRUE(write_file(set / "tasks.jsonl", lines));
  const auto ended = run_script(
      "printf 'quit\\n' | unietp play set/" + tasks[0]["id"].get<std::string>() + " --no-page", scratch.path());
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("Put ? it there."));
}

TEST(PlayInTheTerminal, EndsWithinTwoSecondsOfASignal) {
  LongCommand play(play_command("M1", 0, ""));
  play.until_printed("\n> ");
  const auto before = std::chrono::steady_clock::now();
  play.send(SIGTERM);
  EXPECT_EQ(play.wait().code, 130);
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(2));
}

/// A person with the terminal and the page side by side.
class PlayWithPage : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!Browser::installed()) GTEST_SKIP() << needs::kChromium;
  }
  void look(LongCommand& command, const std::string& address) {
    browser.emplace(folder.path());
    url = command.url();
    browser->visit(address);
  }
  /// The address with the session, as it is printed.
  static std::string printed_address(LongCommand& command) {
    const auto all = command.until_printed("\n> ");
    const auto start = all.find("http://");
    return all.substr(start, all.find('\n', start) - start);
  }
  std::string text(const std::string& selector) {
    return browser->evaluate("document.querySelector('" + selector + "').textContent").get<std::string>();
  }
  void after_turn(std::size_t turn) {
    browser->until("document.documentElement.dataset.turn === '" + std::to_string(turn) + "'");
  }
  /// Chooses what a step is done to and presses its button.
  void click(const Json& step) {
    for (const auto& argument : step["args"])
      browser->evaluate(argument.is_string()
                            ? "document.querySelector('[data-id=\"" + argument.get<std::string>() + "\"]').click()"
                            : "choose(" + argument.dump() + ")");
    browser->evaluate("document.querySelector('[data-action=" + step["action"].get<std::string>() + "]').click()");
  }
  void nothing_was_amiss() {
    EXPECT_THAT(browser->complaints, IsEmpty());
    EXPECT_THAT(browser->fetched, Each(StartsWith(url + "/")));
  }

  ScratchFolder folder;
  std::optional<Browser> browser;
  std::string url;
};

TEST_F(PlayWithPage, ClicksReachTheGoalAndTheTerminalTellsOfThem) {
  for (const std::string mode : {"M1", "M3"}) {
    SCOPED_TRACE(mode);
    LongCommand play(play_command(mode, 1, ""));
    look(play, printed_address(play));
    after_turn(1);
    const auto shown = demonstration(mode, 1);
    EXPECT_EQ(text("#title"), shown["task"]);
    std::size_t turn = 1;
    for (const auto& step : shown["steps"]) {
      click(step);
      after_turn(++turn);
    }
    EXPECT_THAT(text("#feedback"), HasSubstr("The episode is over: the goal is reached."));
    play.until_printed("The episode is over: the goal is reached.");
    play.write("again\n");
    after_turn(++turn);
    EXPECT_EQ(text("#feedback"), "Nothing has been done yet.");
    play.write("turn left\n");
    after_turn(++turn);
    EXPECT_THAT(text("#feedback"), HasSubstr("turn_left"));
    nothing_was_amiss();
    play.write("quit\n");
    EXPECT_EQ(play.wait().code, 0);
  }
}

TEST_F(PlayWithPage, InM3ThePageHasNoIdOfAnObject) {
  LongCommand play(play_command("M3", 0, ""));
  look(play, printed_address(play));
  after_turn(1);
  const auto page = browser->evaluate("document.body.outerHTML").get<std::string>();
  for (const auto& node :
       start_json(data_set_in_all_modes(), json_lines(data_set_in_all_modes() / "tasks.jsonl")[0])["nodes"])
    EXPECT_THAT(page, Not(HasSubstr(node["id"].get<std::string>())));
  nothing_was_amiss();
}

TEST_F(PlayWithPage, OfAServerOpensASessionOfItsOwnAndShowsTextsAsTexts) {
  const ScratchFolder scratch;
  const fs::path set = scratch.path() / "set";
  fs::copy(data_set_in_all_modes(), set, fs::copy_options::recursive);
  auto tasks = json_lines(set / "tasks.jsonl");
  const std::string hostile = "</p><script>window.hurt = 1</script><img src=x onerror=hurt=2> \"a\" & 'b'";
  tasks[0]["instruction"]["text"] = hostile;
  std::string lines;
  for (const auto& task : tasks) lines += task.dump() + "\n";
  ASSERT_TRUE(write_file(set / "tasks.jsonl", lines));
  LongCommand server("serve '" + set.string() + "' --port 0");
  look(server, server.url() + "/");
  browser->evaluate("document.querySelector('#task').value = " + tasks[0]["id"].dump());
  browser->evaluate("document.querySelector('#choose').requestSubmit()");
  after_turn(1);
  EXPECT_EQ(text("#instruction"), hostile);
  EXPECT_EQ(browser->evaluate("typeof window.hurt"), "undefined");
  EXPECT_THAT(browser->evaluate("document.querySelector('#picture').src").get<std::string>(),
              StartsWith("data:image/png;base64,"));
  nothing_was_amiss();
}

}  // namespace
}  // namespace unietp
