// What is read out of a server's headers and a model's text.
#include <gmock/gmock.h>

#include "llm/json_object.h"
#include "llm/one_field.h"
#include "llm/retry_after.h"

namespace unietp {
namespace {

TEST(RetryAfter, IsSecondsOrADate) {
  EXPECT_EQ(retry_after_s("7", ""), 7);
  EXPECT_EQ(retry_after_s("0.5", ""), 0.5);
  EXPECT_EQ(retry_after_s("Wed, 21 Oct 2015 07:28:30 GMT", "Wed, 21 Oct 2015 07:28:00 GMT"), 30);
  EXPECT_EQ(retry_after_s("Wed, 21 Oct 2015 07:28:00 GMT", "Wed, 21 Oct 2015 09:00:00 GMT"), 0);
  EXPECT_EQ(retry_after_s("Wed, 21 Oct 2015 07:28:00 GMT", ""), 0);  // long ago by the clock
}

TEST(RetryAfter, ThatDoesNotReadIsNone) {
  for (const char* text : {"", "-1", "nan", "inf", "soon", "7 s", "1e999"})
    EXPECT_FALSE(retry_after_s(text, "")) << text;
}

TEST(JsonObject, IsTakenOutOfAText) {
  EXPECT_EQ(*json_object_in(R"( {"a": 1} )"), R"({"a": 1})");
  EXPECT_EQ(*json_object_in("```json\n{\"a\": \"}\\\"{\"}\n```"), "{\"a\": \"}\\\"{\"}");
  EXPECT_EQ(*json_object_in("As {you} said: {\"a\": {}} and {\"b\": 2}"), "{\"a\": {}}");
  EXPECT_EQ(*json_object_in("<think>{\"a\": 1}</think>{\"a\": 2}"), "{\"a\": 2}");
  EXPECT_EQ(*json_object_in("<think>{\"a\": 1}</think> as I thought"), "{\"a\": 1}");
  std::string brackets = "I mean ";
  for (int i = 0; i < 63; ++i) brackets += "{x} ";
  EXPECT_EQ(*json_object_in(brackets + "{\"a\": 1}"), "{\"a\": 1}") << "the last of 64 brackets that are tried";
  EXPECT_FALSE(json_object_in(brackets + "{x} {\"a\": 1}"));
}

TEST(JsonObject, IsMissedWhereThereIsNone) {
  for (const std::string& text : {std::string(), std::string("no"), std::string("{\"a\": }"), std::string("{a: 1}"),
                                  std::string(3000000, '{'), std::string("{\"a\": \"\xff\"}")})
    EXPECT_FALSE(json_object_in(text)) << text.substr(0, 20);
}

TEST(OneField, IsReadBack) {
  const auto request = one_field_request("s", "u", "instruction");
  EXPECT_THAT(request.schema, ::testing::HasSubstr("instruction"));
  EXPECT_EQ(*field_of({R"({"instruction": "Go."})"}, "instruction"), "Go.");
  for (const char* text : {"{}", "[]", "", R"({"instruction": 3})"}) EXPECT_FALSE(field_of({text}, "instruction"));
}

}  // namespace
}  // namespace unietp
