#include "core/error.h"

#include <gtest/gtest.h>

#include "core/digest.h"
#include "core/in_quotes.h"
#include "core/result.h"

namespace unietp {
namespace {

TEST(Error, IsFormattedWithFileLineColumnAndKind) {
  EXPECT_EQ(format({Error::Kind::Parse, "kitchen.json", {3, 7}, "expected ':'"}),
            "kitchen.json:3:7: parse error: expected ':'");
  EXPECT_EQ(format({Error::Kind::Io, "a.txt", {}, "cannot read"}), "a.txt: file error: cannot read");
  EXPECT_EQ(format({Error::Kind::Unsatisfiable, "", {}, "no room"}), "unsatisfiable: no room");
  EXPECT_EQ(format({Error::Kind::Usage, "", {1, 2}, "m"}), "1:2: usage error: m");
}

TEST(Error, ShowsNothingThatMovesTheCursorOrTurnsTheText) {
  EXPECT_EQ(
      format({Error::Kind::Io, "a\nb\x1b[2J", {}, "k\u00fcche \u4e2d \u009b1m \u202egnp.exe\u2066 \x7f\r\u200f."}),
      "a?b?[2J: file error: k\u00fcche \u4e2d ?1m ?gnp.exe? ???.");
  EXPECT_EQ(for_terminal("cut\xe2\x80"), "cut\xe2\x80");
}

TEST(Locate, CountsLinesAndBytesFromOne) {
  constexpr std::string_view kText = "ab\ncd\n";
  EXPECT_EQ(locate(kText, 0), (SourcePos{1, 1}));
  EXPECT_EQ(locate(kText, 2), (SourcePos{1, 3}));
  EXPECT_EQ(locate(kText, 3), (SourcePos{2, 1}));
  EXPECT_EQ(locate(kText, 6), (SourcePos{3, 1}));
  EXPECT_EQ(locate("", 0), (SourcePos{1, 1}));
}

TEST(Result, HoldsAValueOrAnError) {
  const Result<int> value = 3;
  const Result<int> error = Error{Error::Kind::Io, "f", {}, "m"};
  ASSERT_TRUE(value);
  EXPECT_EQ(*value, 3);
  ASSERT_FALSE(error);
  EXPECT_EQ(error.error().where, "f");
}

// FIPS 180-2, appendix B.1 and the digest of nothing.
TEST(Sha256, GivesTheKnownDigests) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace unietp
