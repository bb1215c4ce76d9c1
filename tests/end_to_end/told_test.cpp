// What an agent is told is the same, byte for byte, wherever it meets a task: in an environment, in the chats that it
// was trained on, and in an evaluation.
#include <map>

#include <gtest/gtest.h>

#include "core/text.h"
#include "data_set.h"
#include "environment/picture_text.h"
#include "task_sources.h"
#include "tests/llm/server.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::ChatServer;
using test::completion;
using test::Received;

/// One way to train on demonstrations and to evaluate in the same form.
struct Form {
  Mode mode;
  std::string unit, chat;           // of the export, of the evaluation
  std::string observation, images;  // likewise
};

std::string name(const Form& form) {
  return std::string(name_of(form.mode)) + "-" + form.unit + "-" + form.observation;
}

/// The text of a message, without its pictures. A text before a picture ends its line.
std::string text_of(const Json& content) {
  if (content.is_string()) return content;
  std::string text;
  for (const Json& part : content) {
    if (part["type"] == "text") text += part["text"];
  }
  return content.size() > 1 && text.ends_with('\n') ? text.substr(0, text.size() - 1) : text;
}

using Chat = std::vector<std::pair<std::string, std::string>>;  // role and text

Chat chat_of(const Json& messages) {
  Chat chat;
  for (const Json& one : messages) chat.emplace_back(one["role"], text_of(one["content"]));
  return chat;
}

/// The chats of an export.
std::vector<Chat> exported(const Form& form, const fs::path& out) {
  const Ended ended = run_program({"export", data_set_in_all_modes().string(), "--format", "sft", "--modes",
                                   std::string(name_of(form.mode)), "--unit", form.unit, "--observation",
                                   form.observation, "--out", out.string()});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const std::string ending = form.observation == "boxes" ? ".jsonl" : ".trl.jsonl";
  std::vector<Chat> chats;
  for (const Json& line : json_lines(out / (std::string(name_of(form.mode)) + ending)))
    chats.push_back(chat_of(line["messages"]));
  return chats;
}

/// What a model is asked that gives these replies, one after the other.
std::vector<Chat> asked(const Form& form, const std::vector<std::string>& replies, const fs::path& out) {
  ChatServer server(
      [&](const Received& request) { return completion(replies.at(static_cast<std::size_t>(request.number))); });
  const Ended ended = run_program({"evaluate", data_set_in_all_modes().string(), "--model", "m", "--llm-url",
                                   server.url, "--at-once", "1", "--modes", std::string(name_of(form.mode)), "--chat",
                                   form.chat, "--images", form.images, "--out", out.string()});
  EXPECT_EQ(ended.code, 0) << ended.err;
  std::vector<Chat> chats;
  for (const Received& one : server.received()) chats.push_back(chat_of(Json::parse(one.body)["messages"]));
  return chats;
}

class TrainingAndEvaluation : public ::testing::TestWithParam<Form> {};

TEST_P(TrainingAndEvaluation, TellTheSame) {
  const ScratchFolder scratch;
  const Form& form = GetParam();
  std::vector<Chat> wanted;
  std::vector<std::string> replies;
  for (const Chat& chat : exported(form, scratch.at("chats"))) {
    for (std::size_t i = 0; i < chat.size(); ++i) {
      if (chat[i].first != "assistant") continue;
      wanted.emplace_back(chat.begin(), chat.begin() + static_cast<std::ptrdiff_t>(i));
      replies.push_back(chat[i].second);
    }
  }
  ASSERT_GT(wanted.size(), 40U);
  const auto sent = asked(form, replies, scratch.at("run"));
  ASSERT_EQ(sent.size(), wanted.size());
  for (std::size_t i = 0; i < sent.size(); ++i) ASSERT_EQ(sent[i], wanted[i]) << "request " << i;
}

INSTANTIATE_TEST_SUITE_P(EachForm, TrainingAndEvaluation,
                         ::testing::Values(Form{Mode::M1, "step", "single", "boxes", "none"},
                                           Form{Mode::M2, "episode", "multi", "boxes", "none"},
                                           Form{Mode::M2, "step", "single", "both", "current"},
                                           Form{Mode::M3, "episode", "multi", "image", "current"}),
                         [](const auto& form) { return replace_all(name(form.param), "-", "_"); });

TEST(TrainingAndEnvironments, TellTheSame) {
  const ScratchFolder scratch;
  const TaskSource tasks = source(data_set_in_all_modes());
  for (const Form& form : {Form{Mode::M1, "episode", "", "both", ""}, Form{Mode::M2, "episode", "", "boxes", ""},
                           Form{Mode::M3, "episode", "", "image", ""}}) {
    const auto chats = exported(form, scratch.at(name(form)));
    ASSERT_EQ(chats.size(), tasks.size());
    for (std::size_t position = 0; position < chats.size(); ++position) {
      Environment environment = environment_of(tasks, position, form.mode);
      ASSERT_EQ(environment.prompt(), chats[position][0].second);
      for (std::size_t i = 1; i + 1 < chats[position].size(); i += 2) {
        std::string told = environment.text();
        const std::string shown = form.observation == "boxes" ? picture_text(environment) : "";
        if (!shown.empty()) told += "\n" + shown;
        ASSERT_EQ(told, chats[position][i].second) << "turn " << i;
        (void)environment.step(chats[position][i + 1].second);
      }
      EXPECT_TRUE(environment.over());
    }
  }
}

}  // namespace
}  // namespace unietp
