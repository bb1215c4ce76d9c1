#include "report/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base64.h"
#include "report/asset.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(Html, NothingInATextEndsTheElementThatItStandsIn) {
  EXPECT_EQ(escaped_html("<b a=\"1\" c='2'>&"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
  EXPECT_EQ(json_in_html("[\"</script><!--\"]"), "[\"\\u003c/script>\\u003c!--\"]");
}

TEST(Html, APageNamesItsOnlyScriptByItsDigestAndFetchesNothing) {
  const auto html = to_html({"a < b", {"p{}"}, "<p>x</p>", {{"data", "[]"}}, {"var a", "var b"}});
  EXPECT_THAT(html, HasSubstr("<title>a &lt; b</title>"));
  EXPECT_THAT(html, HasSubstr("script-src 'sha256-"));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  EXPECT_THAT(html, Not(HasSubstr("http://")));
  EXPECT_THAT(html, HasSubstr("<script>var a\nvar b\n</script>"));
}

TEST(Html, OnlyAPageThatSaysSoAsksTheServerThatItCameFrom) {
  HtmlPage page{"a", {}, "", {}, {}};
  EXPECT_THAT(to_html(page), Not(HasSubstr("connect-src")));
  page.asks_its_server = true;
  EXPECT_THAT(to_html(page), HasSubstr("; connect-src 'self'\""));
}

TEST(Asset, ChartJsComesWithItsLicense) {
  EXPECT_THAT(std::string(asset("chart.min.js").substr(0, 200)), HasSubstr("Released under the MIT License"));
  EXPECT_THAT(std::string(asset("chart.min.js")), Not(HasSubstr("</script")));
  EXPECT_EQ(asset("nothing.js"), "");
}

}  // namespace
}  // namespace unietp
