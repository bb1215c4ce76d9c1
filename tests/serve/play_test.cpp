#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kitchen_tasks.h"
#include "serve/play_line.h"
#include "serve/play_page.h"
#include "serve/play_terminal.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::vector<std::string> kOffered{"go_to",    "move_forward", "move_left", "pick_up",
                                        "place_in", "place_on",     "stop"};
const std::vector<ListedThing> kListed{{"mug_1", "Mug"}, {"sink_1", "Sink"}};

std::string typed(const std::string& line) {
  const auto action = typed_action(line, kOffered, kListed);
  return action ? *action : "no: " + action.error().message;
}

TEST(TypedAction, IsNamedByItsBeginningAndItsTargetByNumberOrId) {
  EXPECT_EQ(typed("pick_up mug_1"), R"({"action":"pick_up","args":["mug_1"]})");
  EXPECT_EQ(typed("  Pick up   1 "), R"({"action":"pick_up","args":["mug_1"]})");
  EXPECT_EQ(typed("go 2"), R"({"action":"go_to","args":["sink_1"]})");
  EXPECT_EQ(typed("place in(sink_1)"), R"({"action":"place_in","args":["sink_1"]})");
  EXPECT_EQ(typed("stop"), R"({"action":"stop","args":[]})");
  EXPECT_EQ(typed("move_f"), R"({"action":"move_forward","args":[]})");
  EXPECT_EQ(typed("pick 10,20"), R"({"action":"pick_up","args":[{"point":[10,20]}]})");
  EXPECT_EQ(typed("pick 10, 20, 30, 40"), R"({"action":"pick_up","args":[{"bbox":[10,20,30,40]}]})");
}

TEST(TypedAction, ThatIsNoneOrMoreThanOneIsNotTriedInTheEpisode) {
  EXPECT_THAT(typed("place 2"), HasSubstr("place_in, place_on"));
  EXPECT_THAT(typed("pik_up 2"), HasSubstr("did you mean pick_up?"));
  EXPECT_THAT(typed("go 3"), HasSubstr("nothing has the number 3"));
  EXPECT_THAT(typed("go 0"), HasSubstr("nothing has the number 0"));
  EXPECT_THAT(typed("go -1"), StartsWith("no: "));
  EXPECT_THAT(typed("go"), HasSubstr("go_to what?"));
  EXPECT_THAT(typed("go 1 2"), HasSubstr("go_to is done to one thing"));
  EXPECT_THAT(typed("stop 1"), HasSubstr("stop is done to nothing"));
  EXPECT_THAT(typed(""), HasSubstr("expected an action"));
  EXPECT_THAT(typed("()"), HasSubstr("expected an action"));
}

class Terminal : public ::testing::Test {
 protected:
  PlayTerminal opened(const std::string& mode) {
    PlayChoice choice;
    choice.mode = mode;
    choice.procedural = true;
    auto terminal = PlayTerminal::open(protocol, choice);
    EXPECT_TRUE(terminal);
    return std::move(*terminal);
  }
  Protocol protocol{testing::kitchen_tasks(), {}};
};

TEST_F(Terminal, APersonPlaysATaskToItsEnd) {
  auto terminal = opened("M1");
  EXPECT_THAT(terminal.begin(), StartsWith("Task kitchen-1: Put the mug on the counter.\nStep 0, 50 left"));
  EXPECT_THAT(terminal.typed("home counter"), HasSubstr("   1 countertop_1"));
  EXPECT_THAT(terminal.typed("go mug_1"), StartsWith("go_to(mug_1): done\nStep 1, 49 left"));
  EXPECT_THAT(terminal.typed("pick countertop_1"), HasSubstr("pick_up(countertop_1): failed. "));
  EXPECT_THAT(terminal.typed("pick up mug_1"), HasSubstr("In the hand: mug_1."));
  EXPECT_THAT(terminal.typed("home counter"), HasSubstr("   1 countertop_1"));
  EXPECT_THAT(terminal.typed("go 1"), HasSubstr("go_to(countertop_1): done"));
  EXPECT_THAT(terminal.typed("place on countertop_1"), HasSubstr("place_on(countertop_1): done"));
  EXPECT_THAT(terminal.typed("stop"), HasSubstr("The episode is over: the goal is reached."));
  EXPECT_THAT(terminal.typed("again"), HasSubstr("Step 0"));
  EXPECT_THAT(terminal.typed("stop"), HasSubstr("The episode is over: the goal is not reached."));
  EXPECT_FALSE(terminal.is_over());
  EXPECT_EQ(terminal.typed("quit"), "");
  EXPECT_TRUE(terminal.is_over());
}

TEST_F(Terminal, InM3NoIdOfAnObjectIsShown) {
  auto terminal = opened("M3");
  std::string all = terminal.begin();
  EXPECT_THAT(all, HasSubstr("Step 0, 150 left"));
  for (const char* line : {"look", "home", "turn left", "pick 250,250"}) all += terminal.typed(line);
  EXPECT_THAT(all, Not(HasSubstr("mug_1")));
  EXPECT_THAT(all, Not(HasSubstr("countertop_1")));
  EXPECT_THAT(all, HasSubstr("Step 2, 148 left"));
}

TEST_F(Terminal, TellsWhatThePageDid) {
  auto terminal = opened("M1");
  EXPECT_EQ(terminal.watch(), "");
  const auto step = "{\"session\": \"" + terminal.session() + "\", \"action\": \"go_to(mug_1)\"}";
  EXPECT_FALSE(protocol.call("step", step, std::chrono::steady_clock::now()).failure);
  EXPECT_THAT(terminal.watch(), StartsWith("go_to(mug_1): done\nStep 1"));
  EXPECT_EQ(terminal.watch(), "");
}

TEST(PlayPage, AsksItsOwnServerAndNobodyElse) {
  const auto page = play_page();
  EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data:;"));
  EXPECT_THAT(page, HasSubstr("connect-src 'self'"));
  EXPECT_THAT(page, Not(HasSubstr("http://")));
  EXPECT_THAT(page, Not(HasSubstr("innerHTML")));
}

}  // namespace
}  // namespace unietp
