#include "serve/line_input.h"

#include <unistd.h>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace unietp {
namespace {

using std::chrono::milliseconds;
using Got = LineInput::Got;

class LineInputs : public ::testing::Test {
 protected:
  LineInputs() { EXPECT_EQ(::pipe(ends_), 0); }
  ~LineInputs() override {
    ::close(ends_[0]);
    end();
  }
  void write(std::string_view bytes) const {
    EXPECT_EQ(::write(ends_[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  void end() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  int in() const { return ends_[0]; }

 private:
  int ends_[2] = {-1, -1};
};

TEST_F(LineInputs, GivesTheLinesInOrderAlsoEmptyOnesAndOneWithoutALineFeed) {
  LineInput input(in(), 100);
  write("a\n\nb");
  EXPECT_EQ(input.next(milliseconds(0)), Got::Line);
  EXPECT_EQ(input.line(), "a");
  EXPECT_EQ(input.next(milliseconds(0)), Got::Line);
  EXPECT_EQ(input.line(), "");
  EXPECT_EQ(input.next(milliseconds(0)), Got::Nothing);
  write("c\nd");
  EXPECT_EQ(input.next(milliseconds(0)), Got::Line);
  EXPECT_EQ(input.line(), "bc");
  end();
  EXPECT_EQ(input.next(milliseconds(0)), Got::Line);
  EXPECT_EQ(input.line(), "d");
  EXPECT_EQ(input.next(milliseconds(0)), Got::End);
  EXPECT_EQ(input.next(milliseconds(0)), Got::End);
}

TEST_F(LineInputs, ALineThatIsTooLongIsToldOnceAndSkippedWhereverItsPiecesEnd) {
  for (const std::size_t piece : {1U, 3U, 9U, 100U}) {
    SCOPED_TRACE(piece);
    LineInput input(in(), 4);
    const std::string all = "12345\n1234\n1234567890123\nab\n";
    std::vector<Got> got;
    std::string lines;
    for (std::size_t from = 0; from < all.size(); from += piece) {
      write(std::string_view(all).substr(from, piece));
      for (Got now = input.next(milliseconds(0)); now != Got::Nothing; now = input.next(milliseconds(0))) {
        got.push_back(now);
        if (now == Got::Line) lines += input.line() + ";";
      }
    }
    EXPECT_EQ(got, (std::vector<Got>{Got::TooLong, Got::Line, Got::TooLong, Got::Line}));
    EXPECT_EQ(lines, "1234;ab;");
  }
}

TEST_F(LineInputs, ALongLineThatNeverEndsIsTooLongAndThenTheEnd) {
  LineInput input(in(), 4);
  write("123456");
  end();
  EXPECT_EQ(input.next(milliseconds(0)), Got::TooLong);
  EXPECT_EQ(input.next(milliseconds(0)), Got::End);
}

}  // namespace
}  // namespace unietp
