#include "sense/use_states.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

UseStates committed_uses() {
  std::vector<Error> errors;
  auto read = read_use_states(test::sense_tables() / "use_states.csv", test::committed_sense().kinds(), errors);
  for (const auto& error : errors) ADD_FAILURE() << format(error);
  return read;
}

TEST(UseStates, SayHowPeopleFindWhatTheyUse) {
  const auto uses = committed_uses();
  const auto& kinds = test::committed_sense().kinds();
  EXPECT_THAT(uses.of("plate", "in:dishwasher", kinds), ElementsAre(Predicate::Dirty));
  EXPECT_THAT(uses.of("plate", "in:kitchen_cabinet", kinds), ElementsAre(Predicate::Clean));
  EXPECT_THAT(uses.of("plate", "on:dining_table", kinds), ElementsAre(Predicate::Clean));
  EXPECT_THAT(uses.of("vase", "in:storage_cabinet", kinds), ElementsAre(Predicate::Empty));
  EXPECT_THAT(uses.of("garment", "in:hamper", kinds), ElementsAre(Predicate::Dirty));
  EXPECT_THAT(uses.of("cup", "fill:coffee", kinds), ElementsAre(Predicate::Clean));
  EXPECT_THAT(uses.of("meal", "heat", kinds), ElementsAre(Predicate::Cooked));
  EXPECT_THAT(uses.of("raw_meat", "in:microwave", kinds), ElementsAre(Predicate::Cooked));
  EXPECT_THAT(uses.of("raw_meat", "cook", kinds), IsEmpty());
  EXPECT_THAT(uses.of("raw_meat", "in:oven", kinds), IsEmpty());
  EXPECT_THAT(uses.of("book", "on:dining_table", kinds), IsEmpty());
  EXPECT_THAT(uses.of("no_kind_at_all", "on:dining_table", kinds), IsEmpty());
}

TEST(UseStates, OfWhatCarriesDependOnWhatItCarries) {
  const auto uses = committed_uses();
  const auto& kinds = test::committed_sense().kinds();
  EXPECT_THAT(uses.of("plate", "carry:fruit", kinds), ElementsAre(Predicate::Clean));
  EXPECT_THAT(uses.of("bakeware", "carry:meal", kinds), ElementsAre(Predicate::Clean, Predicate::Empty));
  EXPECT_THAT(uses.of("plate", "carry:cutlery", kinds), IsEmpty());
  EXPECT_THAT(uses.of("shelf", "carry:fruit", kinds), IsEmpty());
}

TEST(UseStates, OfAGroupTheFirstRowDecides) {
  const auto& kinds = test::committed_sense().kinds();
  const UseStates uses({{"in:sink", {"cup"}, Predicate::Dirty},
                        {"in:*", {"tableware"}, Predicate::Clean},
                        {"in:*", {"cup"}, Predicate::Cool}});
  EXPECT_THAT(uses.of("cup", "in:sink", kinds), ElementsAre(Predicate::Dirty, Predicate::Cool));
  EXPECT_THAT(uses.of("bowl", "in:sink", kinds), ElementsAre(Predicate::Clean));
}

TEST(UseStates, AFaultyRowIsReportedWithItsPlace) {
  const auto problems = [](const std::string& rows) {
    const ScratchFolder folder;
    EXPECT_TRUE(write_file(folder.path() / "use_states.csv", "use,things,state,source\n" + rows));
    std::vector<Error> errors;
    (void)read_use_states(folder.path() / "use_states.csv", test::committed_sense().kinds(), errors);
    std::vector<std::string> texts;
    for (const auto& error : errors) texts.push_back(format(error));
    return texts;
  };
  EXPECT_THAT(problems("in:sink,plate|cup,dirty,curated\n"), IsEmpty());
  EXPECT_THAT(problems("in:sink,plat,dirty,curated\n"), Contains(HasSubstr("2:9: schema error: 'plat' is not a kind")));
  EXPECT_THAT(problems("in:sink,plate,filled,curated\n"), Contains(HasSubstr("filled")));
  EXPECT_THAT(problems("in:sink,,dirty,curated\n"), Contains(HasSubstr("expected kinds")));
}

}  // namespace
}  // namespace unietp
