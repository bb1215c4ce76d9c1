// What a simulator's program answers, and programs that answer otherwise.
#include "evaluation/simulator_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Scene kitchen() {
  Scene scene;
  Node fridge;
  fridge.id = "fridge_1";
  fridge.category = "fridge";
  fridge.states.set({Predicate::Closed, ""});
  fridge.states.set({Predicate::PowerOn, ""});
  scene.nodes = {fridge};
  return scene;
}

std::string answer(const std::string& result) { return R"({"jsonrpc":"2.0","id":7,"result":)" + result + "}"; }

TEST(ASimulatorsAnswer, IsWhatChangedInOurWords) {
  const auto read =
      read_simulator_answer(answer(R"({"success":true,"message":"","states":{"fridge_1":["open","power_on"]},
                 "edges_added":[["on","mug_1","table_1"],["inside","mug_1","fridge_1"]],
                 "edges_removed":[["in_room","agent","hall_1"]],"held":["mug_1"]})"),
                            7, kitchen(), {});
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_TRUE(read->success);
  ASSERT_EQ(read->changes.nodes.size(), 1U);
  EXPECT_TRUE(read->changes.nodes.front().states.has(Predicate::Open));
  EXPECT_TRUE(read->changes.nodes.front().states.has(Predicate::PowerOn));
  EXPECT_FALSE(read->changes.nodes.front().states.has(Predicate::Closed));
  EXPECT_THAT(read->changes.edges_removed, ElementsAre(Edge{Predicate::InRoom, "agent", "hall_1"}));
  EXPECT_EQ(read->changes.edges_added.size(), 2U);
  EXPECT_THAT(read->changes.agent->held, ElementsAre("mug_1"));
}

TEST(ASimulatorsAnswer, MayTellOfAPieceThatOurPhysicsMake) {
  Delta ours;
  ours.nodes.push_back(kitchen().nodes.front());
  ours.nodes.back().id = "apple_1_slice_1";
  const std::string told = answer(R"json({"success":true,"message":"","edges_added":[],"edges_removed":[],
                 "states":{"apple_1_slice_1":[],"fridge_1":["filled(water)"]}})json");
  const auto read = read_simulator_answer(told, 7, kitchen(), ours);
  ASSERT_TRUE(read) << format(read.error());
  ASSERT_EQ(read->changes.nodes.size(), 2U);
  EXPECT_EQ(read->changes.nodes.front(), ours.nodes.front());
  EXPECT_TRUE(read->changes.nodes.back().states.has(Predicate::Filled));
  EXPECT_FALSE(read_simulator_answer(told, 7, kitchen(), {})) << "a piece of nothing";
}

TEST(ASimulatorsAnswer, MayTellOfTheMomentsThatLeadToIt) {
  const auto told = [](const std::string& last) {
    const std::string nothing = R"(,"edges_added":[],"edges_removed":[])";
    return answer(R"({"success":true,"message":"","states":{"fridge_1":["closed","power_off"]})" + nothing +
                  R"(,"moments":[{"states":{"fridge_1":["open","power_on"]})" + nothing +
                  R"(},{"states":{"fridge_1":)" + last + "}" + nothing + "}]}");
  };
  const auto read = read_simulator_answer(told(R"(["closed","power_off"])"), 7, kitchen(), {});
  ASSERT_TRUE(read) << format(read.error());
  ASSERT_EQ(read->moments.size(), 2U);
  EXPECT_TRUE(read->moments.front().nodes.front().states.has(Predicate::Open));
  EXPECT_TRUE(read->moments.back().nodes.front().states.has(Predicate::PowerOff));
  const auto elsewhere = read_simulator_answer(told(R"(["closed","power_on"])"), 7, kitchen(), {});
  ASSERT_FALSE(elsewhere) << "moments that lead to another state";
  EXPECT_THAT(elsewhere.error().message, HasSubstr("moments"));
}

TEST(ASimulatorsAnswer, TellsAllThatCoversAThing) {
  Scene dusty = kitchen();
  Node fridge = dusty.nodes.front();
  fridge.states.set({Predicate::Covered, "dust"});
  fridge.states.set({Predicate::Covered, "jam"});
  dusty.nodes = {fridge};
  const std::string told = R"json({"success":true,"message":"","edges_added":[],"edges_removed":[],
                 "states":{"fridge_1":["covered(jam)","closed"]}})json";
  const auto read = read_simulator_answer(answer(told), 7, dusty, {});
  ASSERT_TRUE(read) << format(read.error());
  ASSERT_EQ(read->changes.nodes.size(), 1U);
  const StateSet& states = read->changes.nodes.front().states;
  EXPECT_TRUE(states.has(State{Predicate::Covered, "jam"}));
  EXPECT_FALSE(states.has(State{Predicate::Covered, "dust"}));
  EXPECT_TRUE(states.has(Predicate::PowerOn)) << "what it does not speak of stays";
}

TEST(ASimulatorsAnswer, ThatIsNoneIsRefusedWithAReason) {
  const std::string rest = R"(,"message":"","edges_added":[],"edges_removed":[])";
  for (const auto& [line, why] : {
           std::pair{std::string("no"), "parse error"},
           std::pair{answer("{}"), "success"},
           std::pair{answer(R"({"success":1,"states":{})" + rest + "}"), "true or false"},
           std::pair{answer(R"({"success":true,"states":{"mug_9":["open"]})" + rest + "}"), "id of an object"},
           std::pair{answer(R"({"success":true,"states":{"fridge_1":["ajar"]})" + rest + "}"), "state"},
           std::pair{answer(R"({"success":true,"states":{},"message":"","edges_added":[["open","a","b"]],)"
                            R"("edges_removed":[]})"),
                     "a relation and two ids"},
           std::pair{std::string(R"({"jsonrpc":"2.0","id":8,"result":{}})"), "expected 7"},
           std::pair{std::string(R"({"jsonrpc":"2.0","id":7,"error":{"message":"no graph"}})"), "no graph"},
       }) {
    const auto read = read_simulator_answer(line, 7, kitchen(), {});
    ASSERT_FALSE(read) << line;
    EXPECT_THAT(format(read.error()), HasSubstr(why));
  }
}

TEST(ASimulatorsProgram, IsWrittenWithAllThatItNeeds) {
  const ScratchFolder folder;
  for (const auto& backend : simulator_backends()) {
    const auto command = simulator_command(backend, folder.at(backend));
    ASSERT_TRUE(command) << format(command.error());
    EXPECT_THAT(*command, ElementsAre("python3", folder.at(backend) + "/act_" + backend + ".py"));
    EXPECT_TRUE(std::filesystem::exists(folder.at(backend) + "/acting.py"));
  }
  EXPECT_TRUE(std::filesystem::exists(folder.at("ai2thor") + "/run_ai2thor.py"));
}

TEST(ASimulatorsProgram, ThatIsUnknownIsRefused) {
  const ScratchFolder folder;
  const auto refused = simulator_command("virtualhom", folder.at("none"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(format(refused.error()), HasSubstr("virtualhome"));
  EXPECT_FALSE(std::filesystem::exists(folder.at("none")));
}

}  // namespace
}  // namespace unietp
