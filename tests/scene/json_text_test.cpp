#include "scene/json_text.h"

#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/rng.h"

namespace unietp {
namespace {

template <class Value>
std::string text_of(const Value& value) {
  std::string text;
  JsonText(text).value(value);
  return text;
}

TEST(JsonText, ATreeThatWasReadIsWrittenAsItStood) {
  for (const std::string text :
       {R"({"a":[],"b":{},"c":[1,-2,1e-04,1e-05,1e+22,-0.0,5.0],"d":{"e":null,"f":[true,{"g":"x\"y"}]}})", "[]", "7"}) {
    std::string again;
    JsonText(again).tree(nlohmann::ordered_json::parse(text));
    EXPECT_EQ(again, text);
  }
}

TEST(JsonText, PutsCommasBetweenAndNowhereElse) {
  std::string text;
  JsonText json(text);
  json.open_object();
  json.key("empty");
  json.open_list();
  json.close_list();
  json.key("list");
  json.open_list();
  json.value(1);
  json.open_object();
  json.close_object();
  json.value(true);
  json.raw("[2,3]");
  json.close_list();
  json.key("text");
  json.value("a");
  json.close_object();
  EXPECT_EQ(text, R"({"empty":[],"list":[1,{},true,[2,3]],"text":"a"})");
}

TEST(JsonText, WritesNumbersThatReadBackToTheSameBits) {
  EXPECT_EQ(text_of(0.0), "0.0");
  EXPECT_EQ(text_of(-0.0), "-0.0");
  EXPECT_EQ(text_of(2.5), "2.5");
  EXPECT_EQ(text_of(1e300), "1e+300");
  EXPECT_EQ(text_of(std::numeric_limits<double>::quiet_NaN()), "null");
  Rng rng(1);
  for (int i = 0; i < 20000; ++i) {
    const auto number = i % 2 == 0 ? std::bit_cast<double>(rng.next()) : rng.uniform(-20, 20);
    if (!std::isfinite(number)) continue;
    const auto read = nlohmann::json::parse(text_of(number));
    ASSERT_TRUE(read.is_number_float()) << text_of(number);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.get<double>()), std::bit_cast<std::uint64_t>(number));
  }
}

TEST(JsonText, EscapesWhatATextMayNotHold) {
  EXPECT_EQ(text_of("mug_1"), "\"mug_1\"");
  EXPECT_EQ(text_of("a \"b\" \\ \n \xC3\xA9"), "\"a \\\"b\\\" \\\\ \\n \xC3\xA9\"");
  EXPECT_EQ(text_of("\xFF"), "\"\xEF\xBF\xBD\"") << "broken UTF-8";
}

}  // namespace
}  // namespace unietp
