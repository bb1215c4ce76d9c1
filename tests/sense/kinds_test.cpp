#include "sense/kinds.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr auto* kHead = "name,singular,plural,parent,purpose,relation,piece,personal,several,source\n";

std::vector<std::string> problems_of(const std::string& rows) {
  const ScratchFolder folder;
  EXPECT_TRUE(write_file(folder.path() / "kinds.csv", kHead + rows));
  std::vector<Error> errors;
  (void)read_kinds(folder.path() / "kinds.csv", errors);
  std::vector<std::string> texts;
  for (const auto& error : errors) texts.push_back(format(error));
  return texts;
}

TEST(Kinds, OfTheCommittedTableAreATreeOf60To150) {
  const auto& kinds = test::committed_sense().kinds();
  EXPECT_GE(kinds.all().size(), 60u);
  EXPECT_LE(kinds.all().size(), 150u);
  for (const auto& kind : kinds.all()) EXPECT_TRUE(kinds.is_a(kind.name, "thing")) << kind.name;
}

TEST(Kinds, EveryCategoryOfEverySimulatorHasOneAndNoOtherHas) {
  std::size_t categories = 0;
  const auto& sense = test::committed_sense();
  for (const auto simulator : kSimulators) {
    for (const auto& category : committed_knowledge(simulator).categories()) {
      const auto* fact = sense.kind_of(simulator, category.name);
      ASSERT_NE(fact, nullptr) << name_of(simulator) << " " << category.name;
      EXPECT_TRUE(fact->source == "curated" || fact->source.starts_with("derived:wordnet:")) << fact->source;
      ++categories;
    }
  }
  std::vector<Error> errors;
  EXPECT_EQ(read_category_kinds(test::sense_tables() / "categories.csv", sense.kinds(), errors).size(), categories);
}

/// Whoever goes up or down a table that is no tree never ends.
TEST(Kinds, OfATableThatIsNoTreeAreNone) {
  for (const char* rows : {"thing,thing,things,,all,,,,,curated\na,a,as,b,a,,,,,curated\nb,b,bs,a,b,,,,,curated\n",
                           "thing,thing,things,,all,,,,,curated\nthing,thing,things,thing,all,,,,,curated\n",
                           "thing,thing,things,,all,,,,,curated\n,mug,mugs,,to drink from,,,,,curated\n"}) {
    const ScratchFolder folder;
    EXPECT_TRUE(write_file(folder.path() / "kinds.csv", kHead + std::string(rows)));
    std::vector<Error> errors;
    EXPECT_THAT(read_kinds(folder.path() / "kinds.csv", errors).all(), IsEmpty()) << rows;
    EXPECT_FALSE(errors.empty()) << rows;
  }
}

/// Who goes up a line of kinds by recursion would need as much of the stack.
TEST(Kinds, AreAtMostAHundredAboveOneAnother) {
  const auto line = [](int kinds) {
    std::string rows = "k0,k,ks,,all,,,,,curated\n";
    for (int i = 1; i <= kinds; ++i)
      rows += "k" + std::to_string(i) + ",k,ks,k" + std::to_string(i - 1) + ",all,,,,,curated\n";
    return problems_of(rows);
  };
  EXPECT_THAT(line(100), IsEmpty());
  EXPECT_THAT(line(101), ::testing::ElementsAre(HasSubstr("has more than 100 kinds above it")));
}

TEST(Kinds, SayHowThingsAreAtAPlace) {
  const auto& kinds = test::committed_sense().kinds();
  EXPECT_EQ(kinds.place_role("on", "sink"), "in:sink");      // on or in it is the same
  EXPECT_EQ(kinds.place_role("on", "fridge"), "on:fridge");  // on it is elsewhere
  EXPECT_EQ(kinds.usual_relation("fridge"), "in");
  EXPECT_EQ(kinds.piece_of("fruit"), "fruit_piece");
  EXPECT_EQ(kinds.piece_of("bread"), "bread");
}

TEST(Kinds, RefusesATableThatIsNoTree) {
  EXPECT_THAT(problems_of("thing,thing,things,,all,,,,,curated\n"), IsEmpty());
  EXPECT_THAT(problems_of("thing,thing,things,,all,,,,,curated\ncup,cup,cups,crockery,drink,,,,,curated\n"),
              Contains(HasSubstr("'crockery' is not a kind of this table")));
  EXPECT_THAT(problems_of("thing,thing,things,,all,,,,,curated\na,a,a,b,x,,,,,curated\nb,b,b,a,x,,,,,curated\n"),
              Contains(HasSubstr("'a' is above itself")));
  EXPECT_THAT(problems_of("thing,thing,things,,all,,,,,curated\nthing,t,t,,all,,,,,curated\n"),
              Contains(HasSubstr("stands twice")));
  EXPECT_THAT(problems_of(",a,a,,all,,,,,curated\n"), Contains(HasSubstr("name")));
  EXPECT_THAT(problems_of("a,a,a,,all,,,,,curated\nb,b,b,,all,,,,,curated\n"),
              Contains(HasSubstr("expected one root")));
  EXPECT_THAT(problems_of("a,a,a,,all,beside,,,,curated\n"), Contains(HasSubstr("'beside' is no relation")));
  EXPECT_THAT(problems_of("a,a,a,,all,,,maybe,,curated\n"), Contains(HasSubstr("expected nothing or yes")));
}

}  // namespace
}  // namespace unietp
