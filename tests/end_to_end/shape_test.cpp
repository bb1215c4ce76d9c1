// `unietp shape`: lists, draws and checks families of shapes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

TEST(ShapeCommand, ListsAndDrawsFamiliesAndAnswersAnUnknownOneWithTheNearest) {
  const ScratchFolder folder;
  const auto listed = run_program({"shape", "list"});
  EXPECT_EQ(listed.code, 0);
  EXPECT_THAT(listed.out, HasSubstr("mug   "));
  const auto shown = run_program({"shape", "show", "mug", "--out", folder.at("mug.png")});
  ASSERT_EQ(shown.code, 0) << shown.err;
  const auto other = run_program({"shape", "show", "bottle", "--out", folder.at("bottle.png")});
  ASSERT_EQ(other.code, 0) << other.err;
  EXPECT_EQ(read_file(folder.at("mug.png"))->substr(1, 3), "PNG");
  EXPECT_NE(*read_file(folder.at("mug.png")), *read_file(folder.at("bottle.png")));
  const auto unknown = run_program({"shape", "show", "mgu", "--out", folder.at("no.png")});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("mug"));
}

TEST(ShapeCommand, DrawsObjectsInAState) {
  const ScratchFolder folder;
  const auto draw = [&](const std::string& file, const std::vector<std::string>& state) {
    std::vector<std::string> arguments{"shape", "show", "kettle", "--out", folder.at(file)};
    arguments.insert(arguments.end(), state.begin(), state.end());
    return run_program(arguments);
  };
  EXPECT_EQ(draw("closed.png", {}).code, 0);
  EXPECT_EQ(draw("open.png", {"--state", "open"}).code, 0);
  EXPECT_EQ(draw("full.png", {"--state", "filled:coffee"}).code, 0);
  EXPECT_NE(*read_file(folder.at("closed.png")), *read_file(folder.at("open.png")));
  EXPECT_NE(*read_file(folder.at("closed.png")), *read_file(folder.at("full.png")));
  const auto unknown = draw("no.png", {"--state", "opne"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("open"));
}

TEST(ShapeCommand, LintsFilesWithLineAndColumnAndTheBuiltInShapesWithAllSizes) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("good.shapes"), "(family a (means \"a\") (ball -1 1 -1 1 -1 1))\n"));
  ASSERT_TRUE(write_file(folder.at("bad.shapes"), "(family a (means \"a\")\n (bal -1 1 -1 1 -1 1))\n"));
  EXPECT_EQ(run_program({"shape", "lint", folder.at("good.shapes")}).code, 0);
  const auto bad = run_program({"shape", "lint", folder.at("bad.shapes")});
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.err, HasSubstr("bad.shapes:2:2: parse error: expected a part; did you mean \"ball\"?"));
  const auto built_in = run_program({"shape", "lint"});
  EXPECT_EQ(built_in.code, 0) << built_in.err;
  EXPECT_THAT(built_in.out, HasSubstr("behavior"));
}

TEST(ShapeCommand, DrawsAQuizWithItsAnswersApart) {
  const ScratchFolder folder;
  const auto drawn = run_program(
      {"shape", "quiz", "things", "--movables", "20", "--furniture", "8", "--seed", "5", "--out", folder.at("quiz")});
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(drawn.out, "28 questions on 2 sheets in " + folder.at("quiz") + "\n");
  EXPECT_EQ(read_file(folder.at("quiz/sheet-02.png"))->substr(1, 3), "PNG");
  const auto questions = split(*read_file(folder.at("quiz/questions.csv")), '\n');
  const auto answers = split(*read_file(folder.at("quiz/answers.csv")), '\n');
  ASSERT_EQ(questions.size(), 30U);  // a header, and nothing after the last line
  ASSERT_EQ(answers.size(), 30U);
  EXPECT_THAT(questions[25], ::testing::MatchesRegex("25,2,1,1,[0-9]+x[0-9]+x[0-9]+,furniture"));
  for (std::size_t i = 1; i <= 28; ++i) {  // no question names its category
    const auto category = split(answers[i], ',')[2];
    EXPECT_THAT(questions[i], ::testing::Not(HasSubstr(category))) << answers[i];
  }
  EXPECT_EQ(run_program({"shape", "quiz", "states", "--count", "0", "--out", folder.at("none")}).code, 2);
  EXPECT_EQ(run_program({"shape", "quiz", "smells", "--out", folder.at("none")}).code, 2);
}

}  // namespace
}  // namespace unietp
