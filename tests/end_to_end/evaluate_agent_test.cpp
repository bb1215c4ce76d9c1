// `unietp evaluate --resume` with an agent that is not the one that began the run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "data_set.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kTurning = R"(import json, sys
class Agent:
    def begin(self, episode): self.left = 2
    def act(self, observation):
        self.left -= 1
        return 'turn_left' if self.left >= 0 else 'stop'
if __name__ == '__main__':
    agent = Agent()
    for line in sys.stdin:
        call = json.loads(line)
        if call['method'] == 'begin': agent.begin({})
        answer = {'jsonrpc': '2.0', 'id': call['id'], 'result': {'action': agent.act({})}}
        print(json.dumps(answer), flush=True)
)";

class EvaluateAgent : public ::testing::Test {
 protected:
  EvaluateAgent() {
    fs::create_directories(file("mine/deep"));
    for (const char* name : {"agent.py", "mine/agent.py"}) EXPECT_TRUE(write_file(file(name), kTurning));
    EXPECT_TRUE(write_file(file("mine/deep/more.py"), "left = 2\n"));
  }
  fs::path file(const std::string& name) const { return scratch_.path() / name; }
  Ended evaluate(const std::string& policy, bool resume) const {
    std::vector<std::string> arguments{"-c",
                                       "exec unietp \"$@\"",
                                       "unietp",
                                       "evaluate",
                                       small_data_set().string(),
                                       "--policy",
                                       policy,
                                       "--limit",
                                       "1",
                                       "--out",
                                       "run",
                                       "--report-pictures",
                                       "0"};
    if (resume) arguments.emplace_back("--resume");
    RunningProgram program("/bin/sh", arguments, scratch_.path());
    return program.wait();
  }
  /// Begins a run with a policy, changes one of its files, and tries to go on.
  void expect_refusal(const std::string& policy, const std::string& changed) const {
    const Ended first = evaluate(policy, false);
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_EQ(evaluate(policy, true).code, 0) << "nothing has changed";
    const std::string sound = *read_file(file(changed));
    ASSERT_TRUE(write_file(file(changed), sound + "# another\n"));
    const Ended refused = evaluate(policy, true);
    EXPECT_EQ(refused.code, 2) << refused.out;
    EXPECT_THAT(refused.err, HasSubstr("agent.files: " + changed + " has changed"));
    ASSERT_TRUE(write_file(file(changed), sound));
    EXPECT_EQ(evaluate(policy, true).code, 0);
  }

  ScratchFolder scratch_;
};

TEST_F(EvaluateAgent, AnotherModuleIsNotResumed) {
  fs::create_directories(file("agent"));  // which Python does not import in its place
  expect_refusal("python:agent.Agent", "agent.py");
}

TEST_F(EvaluateAgent, AnotherPackageIsNotResumed) { expect_refusal("python:mine.agent.Agent", "mine/deep/more.py"); }

TEST_F(EvaluateAgent, AnotherCommandsFileIsNotResumed) { expect_refusal("python3 agent.py", "agent.py"); }

}  // namespace
}  // namespace unietp
