#include "akb/csv.h"

#include <gtest/gtest.h>

#include "core/rng.h"

namespace unietp {
namespace {

std::vector<std::string> texts(const CsvRow& row) {
  std::vector<std::string> fields;
  for (const auto& cell : row) fields.push_back(cell.text);
  return fields;
}
using Fields = std::vector<std::string>;

TEST(ReadCsv, ReadsQuotedCommasQuotesAndLineEnds) {
  const auto file = read_csv("t.csv", "a,b\r\n\"x,y\",\"he said \"\"no\"\"\"\n\"two\nlines\",\n");
  ASSERT_TRUE(file.errors.empty()) << format(file.errors.front());
  ASSERT_EQ(file.rows.size(), 2U);
  EXPECT_EQ(texts(file.rows[0]), (Fields{"x,y", "he said \"no\""}));
  EXPECT_EQ(texts(file.rows[1]), (Fields{"two\nlines", ""}));
}

TEST(ReadCsv, KeepsThePlaceOfEveryField) {
  const auto file = read_csv("t.csv", "a,b\n\"x\ny\",cd\nef,g\n");
  ASSERT_TRUE(file.errors.empty());
  EXPECT_EQ(file.rows[0][1].pos, (SourcePos{3, 4}));
  EXPECT_EQ(file.rows[1][1].pos, (SourcePos{4, 4}));
}

TEST(ReadCsv, TakesALastLineWithoutItsEnd) {
  const auto file = read_csv("t.csv", "a,b\n1,2");
  ASSERT_TRUE(file.errors.empty());
  EXPECT_EQ(texts(file.rows.at(0)), (Fields{"1", "2"}));
}

struct BadCase {
  const char* text;
  const char* message;
};
class BadCsv : public ::testing::TestWithParam<BadCase> {};
TEST_P(BadCsv, IsReportedWithItsPlaceAndWhatIsAccepted) {
  const auto file = read_csv("t.csv", GetParam().text);
  ASSERT_EQ(file.errors.size(), 1U);
  EXPECT_EQ(format(file.errors.front()), GetParam().message);
}
INSTANTIATE_TEST_SUITE_P(
    Each, BadCsv,
    ::testing::Values(
        BadCase{"", "t.csv:1:1: parse error: no header; expected a line of column names"},
        BadCase{"a,b\nx\"y,1\n",
                "t.csv:2:2: parse error: quote inside an unquoted field; expected the whole field in quotes and the "
                "quote doubled"},
        BadCase{"a,b\n\"x\"y,1\n",
                "t.csv:2:4: parse error: text after a closing quote; expected a comma or the end of the line"},
        BadCase{"a,b\n1,\"x\n", "t.csv:2:3: parse error: quoted field without end; expected a closing quote"},
        BadCase{"a,b\n1\r,2\n", "t.csv:2:2: parse error: carriage return without line feed; expected LF or CRLF"},
        BadCase{"a,b\n\n1,2\n", "t.csv:2:1: parse error: empty line; expected a row of fields"},
        BadCase{"a,b\n1,2,3\n", "t.csv:2:1: parse error: 3 fields; expected 2 as in the header"},
        BadCase{"a,,c\n1,2,3\n", "t.csv:1:3: parse error: column without a name; expected one"},
        BadCase{"a,b,a\n1,2,3\n", "t.csv:1:5: parse error: column 'a' is duplicated; expected each once"},
        BadCase{"\xEF\xBB\xBF"
                "a\n1\n",
                "t.csv:1:1: parse error: byte order mark; expected UTF-8 without one"}));

TEST(ReadCsv, GoesOnAfterABadRow) {
  const auto file = read_csv("t.csv", "a,b\n1\n2,\"x\"y\n3,4\n");
  EXPECT_EQ(file.errors.size(), 2U);
  ASSERT_EQ(file.rows.size(), 1U);
  EXPECT_EQ(texts(file.rows[0]), (Fields{"3", "4"}));
}

TEST(ReadCsv, ReadsBackAFieldThatBeginsWithAByteOrderMark) {
  const auto file = read_csv("t.csv", csv_line({"\xEF\xBB\xBF"
                                                "one",
                                                "two"}) +
                                          csv_line({"1", "2"}));
  EXPECT_TRUE(file.errors.empty());
  EXPECT_EQ(texts(file.header), (Fields{"\xEF\xBB\xBF"
                                        "one",
                                        "two"}));
}

TEST(ReadCsv, ReadsBackWhatCsvLineWroteForAnySeed) {
  constexpr std::string_view kLetters = "ab,\"\n\r ;|\xC3\xA9";
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<Fields> rows;
    std::string text = csv_line({"one", "two", "three"});
    for (std::uint64_t row = rng.below(6); row > 0; --row) {
      Fields fields(3);
      for (auto& field : fields) {
        for (std::uint64_t n = rng.below(6); n > 0; --n) field += kLetters[rng.below(kLetters.size())];
      }
      text += csv_line(fields);
      rows.push_back(fields);
    }
    const auto file = read_csv("t.csv", text);
    ASSERT_TRUE(file.errors.empty()) << format(file.errors.front());
    ASSERT_EQ(file.rows.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(texts(file.rows[i]), rows[i]);
  }
}

}  // namespace
}  // namespace unietp
