#include "annotator/llm_writer.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "../llm/asking.h"
#include "../llm/wording_model.h"
#include "core/text.h"
#include "small_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using test::ChatServer;
using test::completion;
using test::http;
using test::Received;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::asking;
using testing_support::small_knowledge;

constexpr const char* kGoal = "(exists (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))";
/// The same, as a judge may put it.
constexpr const char* kJudged = "(at-end (not (forall (?x - Table) (not (exists (?y - Mug) (on ?y ?x))))))";

std::string saying(const std::string& text) { return completion("{\"instruction\": \"" + text + "\"}"); }
std::string judging(const std::string& formula) { return completion("{\"formula\": \"" + formula + "\"}"); }
bool is_judging(const Received& received) { return received.user.find("The instruction:\n") != std::string::npos; }

/// A server that words with these answers, one after the other, the last one ever after, and judges with one.
ChatServer::Handler answering(std::vector<std::string> wordings, std::string judgment) {
  auto next = std::make_shared<std::atomic<std::size_t>>(0);
  return [wordings = std::move(wordings), judgment = std::move(judgment), next](const Received& received) {
    if (is_judging(received)) return judgment;
    return wordings[std::min(next->fetch_add(1), wordings.size() - 1)];
  };
}

class LlmWriter : public ::testing::Test {
 protected:
  LlmWriter() : knowledge_(small_knowledge()), nouns_(knowledge_, committed_names()) {}

  WordingTask task(const char* goal, std::uint64_t seed = 1) const {
    return {asking(goal), &knowledge_, &nouns_, {"Mug", "Table"}, {}, "kitchen: table, 2 mugs\n", {}, Rng(seed)};
  }
  std::vector<Result<Instruction>> written(ChatServer& server, const std::vector<WordingTask>& tasks,
                                           int at_once = 4) const {
    LlmOptions ask = test::quick();
    ask.at_once = at_once;
    LlmWriterOptions options;
    options.model = "tiny";
    options.ask = [&](const std::vector<LlmRequest>& requests) {
      return ask_all(test::endpoint_of(server), requests, ask, nullptr);
    };
    return write_instructions_with_llm(tasks, options);
  }
  Instruction one(ChatServer& server) const {
    const auto all = written(server, {task(kGoal)});
    EXPECT_EQ(all.size(), 1U);
    EXPECT_TRUE(all[0]) << format(all[0].error());
    return *all[0];
  }
  void expect_grammar(const Instruction& written, const char* why) const {
    EXPECT_EQ(written.writer, "grammar");
    EXPECT_THAT(written.why, HasSubstr(why));
    EXPECT_TRUE(check_instruction(written.text, asking(kGoal), knowledge_, nouns_).empty()) << written.text;
    EXPECT_THAT(written.why + written.text, Not(HasSubstr(test::kKey)));
  }
  Knowledge knowledge_;
  NounTable nouns_;
};

TEST_F(LlmWriter, TakesATextThatASecondCallUnderstandsAsTheGoal) {
  ChatServer server(answering({saying("Would you mind leaving a mug on the table?")}, judging(kJudged)));
  const auto written = one(server);
  EXPECT_EQ(written.text, "Would you mind leaving a mug on the table?");
  EXPECT_EQ(written.writer, "llm:tiny");
  EXPECT_EQ(written.why, "");
  EXPECT_THAT(written.checks, ::testing::Contains("judged-back"));
  ASSERT_EQ(server.count(), 2);
  EXPECT_TRUE(server.received()[0].structured);
  EXPECT_THAT(server.received()[0].user, HasSubstr(kGoal));
  EXPECT_THAT(server.received()[0].user, HasSubstr("kitchen: table, 2 mugs"));
  EXPECT_THAT(server.received()[1].user, Not(HasSubstr(kGoal)));  // the judge is not told what to find
  EXPECT_THAT(server.received()[1].user, HasSubstr("Would you mind leaving a mug on the table?"));
}

TEST_F(LlmWriter, SendsBackWhatWasWrongAndTakesTheNext) {
  ChatServer server(
      answering({saying("Put a mug in the fridge."), saying("Put a mug on the table.")}, judging(kJudged)));
  EXPECT_EQ(one(server).writer, "llm:tiny");
  ASSERT_EQ(server.count(), 3);  // the first text fails the check of words and is not judged
  EXPECT_THAT(server.received()[1].user, HasSubstr("refused"));
  EXPECT_THAT(server.received()[1].user, HasSubstr("fridge"));
}

TEST_F(LlmWriter, ATextThatIsUnderstoodOtherwiseIsRefused) {
  ChatServer server(answering({saying("Put a mug on the table.")},
                              judging("(forall (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))")));
  expect_grammar(one(server), "understood as (forall");
  EXPECT_EQ(server.count(), 6);  // three texts, three readings
}

TEST_F(LlmWriter, AJudgeThatGivesNoFormulaIsAskedOnceMore) {
  std::atomic<int> judged = 0;
  ChatServer server([&](const Received& received) {
    if (!is_judging(received)) return saying("Put a mug on the table.");
    return judged++ == 0 ? judging("put(mug, table)") : judging(kJudged);
  });
  EXPECT_EQ(one(server).writer, "llm:tiny");
  ASSERT_EQ(server.count(), 3);
  EXPECT_THAT(server.received()[2].user, HasSubstr("could not be read"));
}

struct BadAnswer {
  const char* name;
  std::string http;
};

/// Of no use for the goal of these tests, each in a way of its own.
std::vector<BadAnswer> bad_answers() {
  return {BadAnswer{"Refusal", completion("I am sorry, but I cannot help with that.")},
          BadAnswer{"RefusalAsJson", saying("I am sorry, but I cannot help with that.")},
          BadAnswer{"RefusalField",
                    http("200 OK", R"({"choices":[{"message":{"content":null,"refusal":"I cannot help."}}]})")},
          BadAnswer{"Empty", saying("")},
          BadAnswer{"EmptyBody", http("200 OK", "")},
          BadAnswer{"CutText", saying("Put a mug on")},
          BadAnswer{"CutObject", completion("{\"instruction\": \"Put a mug on the ta")},
          BadAnswer{"CutBody", "HTTP/1.1 200 OK\r\nContent-Length: 500\r\n\r\n{\"choices\":[{\"mess"},
          BadAnswer{"German", saying("Stelle einen Becher auf den Tisch.")},
          BadAnswer{"Spanish", saying("Pon una taza sobre la mesa, por favor.")},
          BadAnswer{"Html", http("200 OK", "<html>Log in</html>")},
          BadAnswer{"NotJson", completion("put(mug, table)")},
          BadAnswer{"WrongField", completion("{\"text\": \"Put a mug on the table.\"}")},
          BadAnswer{"WrongType", completion("{\"instruction\": 3}")},
          BadAnswer{"AnotherGoal", saying("Fly to the moon.")},
          BadAnswer{"LeakedId", saying("Put mug_3 on the table.")}};
}

TEST_F(LlmWriter, RetriesABadAnswerAndTakesABetterOne) {
  for (const auto& bad : bad_answers()) {
    SCOPED_TRACE(bad.name);
    ChatServer server(answering({bad.http, saying("Put a mug on the table.")}, judging(kJudged)));
    const auto written = one(server);
    EXPECT_EQ(written.writer, "llm:tiny") << written.why;
    EXPECT_EQ(server.count(), 3);  // the bad one, the good one, and its reading
  }
}

TEST_F(LlmWriter, FallsBackToTheGrammarAfterNothingButBadAnswers) {
  for (const auto& bad : bad_answers()) {
    SCOPED_TRACE(bad.name);
    ChatServer server(answering({bad.http}, judging(kJudged)));
    const auto written = one(server);
    expect_grammar(written, "");
    EXPECT_NE(written.why, "");
    EXPECT_GE(server.count(), 3);  // tries of a text, or the attempts of a request
  }
}

TEST_F(LlmWriter, FallsBackToTheGrammarWhenNothingComes) {
  for (const std::string& answer :
       {std::string(), http("500 Internal Server Error", "oh"),
        http("401 Unauthorized", std::string("{\"error\":{\"message\":\"bad key ") + test::kKey + "\"}}")}) {
    ChatServer server([&](const Received&) { return answer; });
    expect_grammar(one(server), "no answer");
  }
}

TEST_F(LlmWriter, FallsBackWhenTheJudgeDoesNotAnswer) {
  ChatServer server(answering({saying("Put a mug on the table.")}, http("503 Busy", "")));
  expect_grammar(one(server), "no answer");
}

TEST_F(LlmWriter, ManyTasksKeepTheirOrderHoweverManyAreUnderWay) {
  const std::vector<std::string> goals{kGoal, "(exists (?a - Lamp) (at-end (power_on ?a)))",
                                       "(exists (?a - Fridge) (at-end (open ?a)))",
                                       "(forall (?a - Mug) (at-end (clean ?a)))"};
  std::vector<std::string> texts;
  for (const int at_once : {1, 4}) {
    test::WordingModel model;
    ChatServer server([&](const Received& received) { return model(received); });
    std::vector<WordingTask> tasks;
    for (std::uint64_t i = 0; i < 12; ++i) tasks.push_back(task(goals[i % 4].c_str(), i));
    std::string all;
    for (const auto& written : written(server, tasks, at_once)) {
      ASSERT_TRUE(written);
      EXPECT_EQ(written->writer, "llm:tiny") << written->why;
      all += written->text + "\n";
    }
    texts.push_back(all);
  }
  EXPECT_EQ(texts[0], texts[1]);
}

TEST_F(LlmWriter, ADryRunShowsTheFirstRoundAndAsksNothing) {
  LlmWriterOptions options;
  options.ask = [](const std::vector<LlmRequest>&) -> std::vector<Result<LlmAnswer>> {
    ADD_FAILURE() << "asked";
    return {};
  };
  const auto requests = first_requests({task(kGoal), task(kGoal, 2)}, options);
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_THAT(requests[0].user, HasSubstr(kGoal));
}

TEST_F(LlmWriter, AsksForWhatTheGrammarSaysWithExamplesOfIts) {
  constexpr const char* kOrder =
      "(exists (?a - Mug) (exists (?b - Table) (and (before (clean ?a) (on ?a ?b)) (at-end (and (clean ?a) (on ?a "
      "?b))))))";
  const auto requests = first_requests({task(kOrder)}, {});
  ASSERT_EQ(requests.size(), 1U);
  const std::string& rules = requests[0].system;
  for (const char* asked : {"short imperatives", "everyday names", "'the' for what the home has one of",
                            "'a' or 'one of the' where it has several", "'it' or 'them'", "number words",
                            "Leave out all that is about the request itself", "'make sure that'",
                            "Do not be polite ('please', 'could you', 'kindly'), unless the style asks for it"})
    EXPECT_THAT(rules, HasSubstr(asked));
  std::vector<std::string> examples;
  for (const std::string& line : split(requests[0].user, '\n'))
    if (line.starts_with("- ")) examples.push_back(line.substr(2));
  EXPECT_GE(examples.size(), 2U);
  EXPECT_EQ(std::set<std::string>(examples.begin(), examples.end()).size(), examples.size()) << requests[0].user;
  for (const std::string& example : examples) {
    EXPECT_THAT(check_instruction(example, asking(kOrder), knowledge_, nouns_), ::testing::IsEmpty()) << example;
    for (const char* frame : {"please", "Please", "ould you", "ant you", "ake sure", "task"})
      EXPECT_THAT(example, Not(HasSubstr(frame)));
    EXPECT_LE(split(example, ' ').size(), 14U) << example;
  }
}

}  // namespace
}  // namespace unietp
