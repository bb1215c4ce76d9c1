#include "sense/generic_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(GenericWords, MayMeanAnyThingOfTheirKinds) {
  const auto& sense = test::committed_sense();
  const Thing fruit{"fruit", "piece of fruit", {}}, apple{"fruit", "apple", {}}, fork{"cutlery", "fork", {}};
  EXPECT_TRUE(sense.may_mean(fruit, apple));
  EXPECT_FALSE(sense.may_mean(apple, fruit));
  EXPECT_FALSE(sense.may_mean(fruit, fruit)) << "two of one name are told apart otherwise";
  EXPECT_FALSE(sense.may_mean(fruit, fork));
  EXPECT_TRUE(sense.may_mean({"cutlery", "piece of silverware", {}}, fork));
}

TEST(GenericWords, AFaultyRowIsReportedWithItsPlace) {
  const auto problems = [](const std::string& rows) {
    const ScratchFolder folder;
    EXPECT_TRUE(write_file(folder.path() / "generic_words.csv", "words,kinds,source\n" + rows));
    std::vector<Error> errors;
    (void)read_generic_words(folder.path() / "generic_words.csv", test::committed_sense().kinds(), errors);
    std::vector<std::string> texts;
    for (const auto& error : errors) texts.push_back(format(error));
    return texts;
  };
  EXPECT_THAT(problems("fruit|piece_of_fruit,fruit,curated\n"), IsEmpty());
  EXPECT_THAT(problems("fruit,fruits,curated\n"), Contains(HasSubstr("2:7: schema error: 'fruits' is not a kind")));
  EXPECT_THAT(problems("fruit,fruit,curated\nfruit,food,curated\n"), Contains(HasSubstr("'fruit' stands twice")));
  EXPECT_THAT(problems("fruit,,curated\n"), Contains(HasSubstr("expected kinds")));
}

}  // namespace
}  // namespace unietp
