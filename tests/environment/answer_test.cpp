// What agents say, in every form that is accepted, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "environment/answer.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

const AnswerFrame kPixels{BoxForm::Pixels, 500, 400};

AnsweredAction by_id(const std::string& action, const std::string& id) { return {{action, {{id, std::nullopt}}}, {}}; }
AnsweredAction by_box(const std::string& action, const PixelBox& box) { return {{action, {{"", box}}}, {}}; }

AnsweredAction only_action(const std::string& text, const AnswerFrame& frame = kPixels) {
  const auto answer = parse_answer(text, frame);
  EXPECT_TRUE(answer) << text << ": " << answer.error().message;
  if (!answer || answer->actions.size() != 1) return {};
  return answer->actions.front();
}

TEST(Answers, AreReadInEveryFormOfOneAction) {
  const AnsweredAction pick = by_id("pick_up", "mug_1");
  for (const char* text :
       {R"({"action": "pick_up", "args": ["mug_1"]})", R"({"action": "pick_up", "args": "mug_1"})",
        R"({"action": "pick up", "args": ["mug_1"]})",
        R"({"reasoning": "It is near.", "action": "pick_up", "args": ["mug_1"]})",
        R"([{"action": "pick_up", "args": ["mug_1"]}])", R"({"actions": [{"action": "pick_up", "args": ["mug_1"]}]})",
        R"({"reasoning": "so", "actions": [{"action_name": "pick up", "args": {"object_id": "mug_1"}}]})",
        R"({"action_name": "Pick Up", "args": {"object_id": "mug_1", "room_id": null}})", "pick_up(mug_1)",
        "  pick_up( mug_1 )\n", "```json\n{\"action\": \"pick_up\", \"args\": [\"mug_1\"]}\n```",
        "I take it [now].\n{\"action\": \"pick_up\", \"args\": [\"mug_1\"]}",
        "Boxes like {x} aside: {\"action\": \"pick_up\", \"args\": [\"mug_1\"]} is it."}) {
    EXPECT_EQ(only_action(text), pick) << text;
  }
}

TEST(Answers, MayLackArguments) {
  for (const char* text :
       {R"({"action": "stop", "args": []})", R"({"action": "stop"})", R"({"action": "stop", "args": null})",
        R"({"action_name": "done", "args": {}})", "stop", "done", "stop()"})
    EXPECT_EQ(only_action(text), (AnsweredAction{{"stop", {}}, {}})) << text;
}

TEST(Answers, NameBoxesAndPointsInTheFormOfTheSettings) {
  const std::string box = R"({"action": "open", "args": [{"bbox": [50, 40, 100, 80]}]})";
  EXPECT_EQ(only_action(box), by_box("open", {50, 40, 100, 80}));
  EXPECT_EQ(only_action("open([50, 40, 100, 80])"), by_box("open", {50, 40, 100, 80}));
  EXPECT_EQ(only_action(R"({"action": "open", "args": [50, 40, 100, 80]})"), by_box("open", {50, 40, 100, 80}));
  EXPECT_EQ(only_action(R"({"action": "open", "args": [{"bbox": [0.1, 0.1, 0.2, 0.2]}]})", {BoxForm::Unit, 500, 400}),
            by_box("open", {50, 40, 100, 80}));
  EXPECT_EQ(
      only_action(R"({"action": "open", "args": [{"bbox": [100, 100, 200, 200]}]})", {BoxForm::Thousand, 500, 400}),
      by_box("open", {50, 40, 100, 80}));
  EXPECT_EQ(only_action(R"({"action": "open", "args": [{"bbox": [100, 200, 300, 400]}]})",
                        {BoxForm::ThousandYFirst, 500, 400}),
            by_box("open", {100, 40, 200, 120}));
  EXPECT_EQ(
      only_action(R"({"action_name": "pick up", "args": {"object_bbox": {"bbox": [1, 2, 3, 4], "category": "mug"}}})"),
      by_box("pick_up", {1, 2, 3, 4}));
  const AnsweredAction point{{"turn_to", {}}, PixelPoint{30, 20}};
  EXPECT_EQ(only_action(R"({"action_name": "turn to point", "args": {"pixel": [30, 20]}})"), point);
  EXPECT_EQ(only_action(R"({"action": "turn_to", "args": [{"point": [30, 20]}]})"), point);
  EXPECT_EQ(only_action(R"({"action": "turn_to", "args": [{"point": [50, 60]}]})", {BoxForm::ThousandYFirst, 500, 400}),
            point);
}

TEST(Answers, NameTheActionsOfTheReleasedRunner) {
  for (const auto& [theirs, ours] :
       std::vector<std::pair<std::string, std::string>>{{"done", "stop"},
                                                        {"go to", "go_to"},
                                                        {"turn to point", "turn_to"},
                                                        {"place to point", "place_on"},
                                                        {"turn base to looking direction", "turn_base_to_look"},
                                                        {"reset head direction", "reset_head"},
                                                        {"heat the object in hand with", "heat_with"},
                                                        {"soak the object in hand with", "soak_with"},
                                                        {"move hand forward", "move_hand_forward"}}) {
    const AnsweredAction said = only_action(R"({"action_name": ")" + theirs + R"("})");
    EXPECT_EQ(said.command.action, ours);
    EXPECT_TRUE(action_named(ours)) << ours;
  }
}

TEST(Answers, MayBeSeveralActions) {
  const auto answer = parse_answer(R"({"reasoning": "first", "actions": [{"action": "go_to", "args": ["mug_1"]},
                                      {"action": "pick_up", "args": ["mug_1"]}]})",
                                   kPixels);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->actions, (std::vector{by_id("go_to", "mug_1"), by_id("pick_up", "mug_1")}));
  EXPECT_EQ(answer->reasoning, "first");
}

TEST(Answers, ThatCannotBeReadSayWhatWasExpectedAndRepeatNothing) {
  const std::string secret = "mug_77";
  for (const std::string& text :
       {std::string(), std::string("I do not know about mug_77."),
        std::string("{\"action\": \"pick_up\", \"args\": [\"mug_77\""), std::string(R"({"act": "mug_77"})"),
        std::string(R"({"action": ["mug_77"]})"), std::string(R"({"action": "pick_up", "args": ["mug_77", "mug_77"]})"),
        std::string(R"({"action": "pick_up", "args": [{"bbox": [1, 2, 3]}]})"),
        std::string(R"({"action": "", "args": ["mug_77"]})"), std::string(R"({"action": " ", "args": ["mug_77"]})"),
        std::string(R"({"action": "a"} {"action": "mug_77"})"), std::string("[]"), std::string("{}"), std::string("7"),
        std::string("\"mug_77\""), std::string("{\"actions\": [7]}"), std::string("\xff\xfe{mug_77"),
        std::string(200, '['), R"({"action": ")" + std::string(300, 'x') + "\"}",
        std::string("pick_up(mug_77\n\x01)")}) {
    const auto answer = parse_answer(text, kPixels);
    ASSERT_FALSE(answer) << text;
    EXPECT_THAT(answer.error().message, HasSubstr("expected")) << text;
    EXPECT_EQ(answer.error().message.find(secret), std::string::npos) << answer.error().message;
  }
  std::string many = "[";
  for (int i = 0; i < 101; ++i) many += std::string(i == 0 ? "" : ",") + R"({"action": "stop"})";
  EXPECT_FALSE(parse_answer(many + "]", kPixels));
}

TEST(Answers, OfAnyLengthTakeLittleTime) {
  for (const char* piece : {"[", "{", "{\"a\":", "\"", "```", "[{}", "{}"}) {
    std::string text;
    while (text.size() < (1U << 20)) text += piece;
    text.resize(1U << 20);
    EXPECT_FALSE(parse_answer(text, kPixels));
  }
}

}  // namespace
}  // namespace unietp
