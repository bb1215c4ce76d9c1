// "A mug" or "the mug": what a text promises about the home.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "annotator/home_counts.h"
#include "annotator/noun_table.h"
#include "core/text.h"
#include "scene/trace.h"
#include "small_knowledge.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing_support::asking;
using testing_support::small_knowledge;

struct Thing {
  const char* kind;
  const char* state = "";
  const char* on = "";  // an id, "table_1"
};

/// A home of things called by their kind and place in the list: "table_1".
Scene home_of(const std::vector<Thing>& things, std::size_t bedrooms = 1) {
  Scene home;
  for (const Thing& thing : things) {
    Node node;
    node.id = lower(thing.kind) + "_" + std::to_string(home.nodes.size() + 1);
    node.category = thing.kind;
    if (*thing.state != '\0') node.states.set({*predicate_named(thing.state), ""});
    home.nodes.push_back(node);
    if (*thing.on != '\0') home.edges.insert({Predicate::On, home.nodes.back().id, thing.on});
  }
  for (std::size_t i = 1; i <= bedrooms; ++i) home.rooms.push_back({"bedroom_" + std::to_string(i), "bedroom", {}});
  return home;
}

std::vector<std::string> texts_in(const Scene& home, const std::string& goal, const Knowledge& knowledge) {
  const NounTable nouns(knowledge, committed_names());
  WritingOptions options;
  options.home = &home;
  std::vector<std::string> texts;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto written = write_instruction(asking(goal), knowledge, nouns, options, Rng(seed));
    EXPECT_TRUE(written) << goal << ": " << format(written.error());
    if (!written) break;
    EXPECT_THAT(check_instruction(written->text, asking(goal), knowledge, nouns, &home), IsEmpty()) << written->text;
    texts.push_back(lower(written->text));
  }
  return texts;
}

std::vector<std::string> faults_in(const Scene& home, const char* text, const char* goal) {
  static const Knowledge knowledge = small_knowledge();
  static const NounTable nouns(knowledge, committed_names());
  return check_instruction(text, asking(goal), knowledge, nouns, &home);
}

constexpr const char* kWash = "(exists (?m - Mug) (at-end (clean ?m)))";

TEST(Articles, AreDefiniteForWhatTheHomeHasOneOf) {
  const Knowledge knowledge = small_knowledge();
  EXPECT_THAT(texts_in(home_of({{"Mug", "dirty"}}), kWash, knowledge), Each(HasSubstr("the mug")));
  const auto of_two = texts_in(home_of({{"Mug", "dirty"}, {"Mug", "dirty"}}), kWash, knowledge);
  EXPECT_THAT(of_two, Each(Not(HasSubstr("the mug."))));
  EXPECT_THAT(of_two, Contains(HasSubstr("a mug")));
}

TEST(Articles, AreDefiniteForTheOnlyOneThatIsNotYetAsItIsWanted) {
  const Knowledge knowledge = small_knowledge();
  const Scene home = home_of({{"Table"}, {"Mug", "clean"}, {"Mug", "dirty"}});
  const char* goal = "(exists (?m - Mug) (exists (?t - Table) (at-end (and (clean ?m) (on ?m ?t)))))";
  EXPECT_THAT(texts_in(home, goal, knowledge), Each(AllOf(HasSubstr("the mug"), Not(HasSubstr("a mug")))));
  const Trace start = to_logic(home, {}), other = to_logic(home_of({{"Mug", "dirty"}, {"Mug", "dirty"}}), {});
  EXPECT_THAT(unique_variables(asking(goal).goal, HomeCounts(start)), ::testing::ElementsAre("m"));
  EXPECT_THAT(unique_variables(asking(goal).goal, HomeCounts(other)), IsEmpty());
  EXPECT_THAT(unique_variables(asking(goal).goal, HomeCounts()), IsEmpty());
}

TEST(Articles, AreDefiniteForThePlaceThatWasNamedBefore) {
  const Scene home =
      home_of({{"Desk"}, {"Dresser"}, {"Book", "", "desk_1"}, {"Vase", "", "dresser_2"}, {"Book"}, {"Vase"}});
  const char* swapped =
      "(exists (?a - (Book :where (exists (?e - Desk) (on ?a ?e)))) (exists (?d - (Vase :where (exists (?f - "
      "Dresser) (on ?d ?f)))) (exists (?b - Dresser) (exists (?c - Desk) (at-end (and (on ?a ?b) (on ?d ?c)))))))";
  EXPECT_THAT(texts_in(home, swapped, committed_knowledge(Simulator::Ai2thor)),
              Each(AllOf(Not(HasSubstr("a desk")), Not(HasSubstr("a dresser")))));
}

TEST(Lists, EndWithWhatIsToldByAPlace) {
  const char* goal =
      "(exists (?a - (Mug :where (exists (?f - Fridge) (nearest ?a ?f)))) (exists (?b - Bowl) (exists (?t - Table) "
      "(at-end (and (on ?a ?t) (on ?b ?t))))))";
  const Scene home = home_of({{"Table"}, {"Fridge"}, {"Mug"}, {"Mug"}, {"Bowl"}});
  const NounTable nouns(small_knowledge(), committed_names());
  int at_the_end = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto written = write_instruction(asking(goal), small_knowledge(), nouns, {}, Rng(seed));
    ASSERT_TRUE(written) << format(written.error());
    EXPECT_EQ(written->text.find("fridge and"), std::string::npos) << written->text;
    if (written->text.find("bowl and the mug") != std::string::npos) ++at_the_end;
  }
  EXPECT_GT(at_the_end, 10);  // most texts list both
}

TEST(Another, NeedsNoNounBesideTheFirst) {
  const char* goal =
      "(exists (?a - Mug) (exists (?o - Mug) (exists (?t - Table) (exists (?c - CoffeeTable) (at-end (and (not (= ?a "
      "?o)) (on ?a ?t) (on ?o ?c)))))))";
  const Scene home = home_of({{"Table"}, {"CoffeeTable"}, {"Mug"}, {"Mug"}, {"Mug"}});
  EXPECT_THAT(faults_in(home, "Put a mug on the table and another on the coffee table.", goal), IsEmpty());
  EXPECT_THAT(faults_in(home, "Put a bowl on the table and another on the coffee table.", goal), Not(IsEmpty()));
  EXPECT_THAT(texts_in(home, goal, small_knowledge()), Contains(HasSubstr("another on")));
}

TEST(Articles, OfOneOfSeveralRoomsAndBesideWhatThereIsOneOf) {
  const Knowledge knowledge = small_knowledge();
  const Scene home = home_of({{"Table"}, {"Mug"}, {"Mug"}, {"Bowl"}});
  const char* both =
      "(exists (?a - Mug) (exists (?b - Bowl) (exists (?t - Table) (at-end (and (on ?a ?t) (on ?b ?t))))))";
  EXPECT_THAT(texts_in(home, both, knowledge), Each(HasSubstr("one of the mugs")));
  const Scene two = home_of({{"Mug"}}, 2);
  const char* brought = "(exists (?m - Mug) (exists (?r - bedroom) (at-end (in_room ?m ?r))))";
  EXPECT_THAT(texts_in(two, brought, committed_knowledge(Simulator::Ai2thor)), Each(HasSubstr("one of the bedrooms")));
}

TEST(Removal, OfTheMugIsOfTheOnlyOneThere) {
  const char* goal = "(exists (?t - Table) (at-end (forall (?m - Mug) (not (on ?m ?t)))))";
  const Scene one = home_of({{"Table"}, {"Mug", "", "table_1"}, {"Mug"}});
  const Scene two = home_of({{"Table"}, {"Mug", "", "table_1"}, {"Mug", "", "table_1"}});
  EXPECT_THAT(faults_in(one, "Take the mug off the table.", goal), IsEmpty());
  EXPECT_THAT(faults_in(two, "Take the mug off the table.", goal), Not(IsEmpty()));
  EXPECT_THAT(faults_in(two, "Take both mugs off the table.", goal), IsEmpty());
  EXPECT_THAT(faults_in(one, "Take both mugs off the table.", goal), Not(IsEmpty()));
  const Knowledge knowledge = small_knowledge();
  EXPECT_THAT(texts_in(one, goal, knowledge), Each(HasSubstr("take the mug off the table")));
  EXPECT_THAT(texts_in(two, goal, knowledge), Each(HasSubstr("take both mugs off the table")));
}

TEST(Removal, IsOffTheOneThatItIsOn) {
  const char* goal = "(at-end (forall (?t - Table) (forall (?m - Mug) (not (on ?m ?t)))))";
  const Scene home = home_of({{"Table"}, {"Table"}, {"Mug", "", "table_1"}});
  EXPECT_THAT(texts_in(home, goal, small_knowledge()), Each(HasSubstr("take the mug off the table")));
}

TEST(Leaving, OneOfTwoLeavesTheOtherOne) {
  const char* goal =
      "(exists (?t - Table) (at-end (and (count = 1 (?m - Mug) (on ?m ?t)) (count = 0 (?o - Mug) (held ?o)))))";
  const Scene two = home_of({{"Table"}, {"Mug", "", "table_1"}, {"Mug", "", "table_1"}, {"Mug"}});
  const Scene three = home_of({{"Table"}, {"Mug", "", "table_1"}, {"Mug", "", "table_1"}, {"Mug", "", "table_1"}});
  EXPECT_THAT(texts_in(two, goal, small_knowledge()), Each(HasSubstr("put the other one somewhere else")));
  EXPECT_THAT(texts_in(three, goal, small_knowledge()), Each(HasSubstr("put the others somewhere else")));
  EXPECT_THAT(faults_in(three, "Leave just one mug on the table and put the other one somewhere else.", goal),
              Not(IsEmpty()));
}

/// "Put some bread in the fridge. Leave the one on the table where it is."
TEST(Leaving, IsOfOnesOnlyWhereTheyAreCounted) {
  const Knowledge knowledge = small_knowledge();
  const NounTable nouns(knowledge, committed_names());
  const auto texts = [&](const std::string& thing) {
    const auto asked = asking("(exists (?f - Fridge) (exists (?a - " + thing +
                                  ") (and (at-end (inside ?a ?f)) (always (forall (?d - (" + thing +
                                  " :where (exists (?c - Table) (on ?d ?c)))) (exists (?e - Table) (on ?d ?e)))))))",
                              "distractor");
    const Scene home = home_of({{"Table"}, {"Fridge"}, {thing.c_str(), "", "table_1"}, {thing.c_str()}});
    WritingOptions options;
    options.home = &home;
    std::vector<std::string> all;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
      if (const auto written = write_instruction(asked, knowledge, nouns, options, Rng(seed)))
        all.push_back(lower(written->text));
    return all;
  };
  EXPECT_THAT(texts("Mug"), Contains(HasSubstr("leave the one on the table where it is")));
  EXPECT_THAT(texts("Bread"), AllOf(Not(IsEmpty()), Each(Not(HasSubstr("the one ")))));
}

TEST(Both, IsOfTwo) {
  const char* goal = "(exists (?t - Table) (forall (?m - Mug) (at-end (on ?m ?t))))";
  EXPECT_THAT(faults_in(home_of({{"Table"}, {"Mug"}, {"Mug"}}), "Put both mugs on the table.", goal), IsEmpty());
  EXPECT_THAT(faults_in(home_of({{"Table"}, {"Mug"}, {"Mug"}, {"Mug"}}), "Put both mugs on the table.", goal),
              Not(IsEmpty()));
}

TEST(Pairs, AreCalledByTheirNameWhereThereIsOne) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Virtualhome);
  const NounTable nouns(knowledge, committed_names());
  EXPECT_EQ(nouns.without_set("clothespants"), "pants");
  EXPECT_EQ(nouns.without_set("mug"), "");
  const char* goal = "(exists (?a - clothespants) (exists (?b - bed) (at-end (on ?a ?b))))";
  EXPECT_THAT(texts_in(home_of({{"clothespants"}, {"bed"}}), goal, knowledge), Each(HasSubstr("the pants")));
  EXPECT_THAT(texts_in(home_of({{"clothespants"}, {"clothespants"}, {"bed"}}), goal, knowledge),
              Each(HasSubstr("a pair of pants")));
}

TEST(Sets, AreCalledByTheirThingsWhereThereIsOne) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  EXPECT_EQ(NounTable(knowledge, committed_names()).without_set("KeyChain"), "keys");
  const char* goal = "(exists (?a - KeyChain) (exists (?b - Desk) (at-end (on ?a ?b))))";
  EXPECT_THAT(texts_in(home_of({{"KeyChain"}, {"Desk"}}), goal, knowledge), Each(HasSubstr("the keys")));
  EXPECT_THAT(texts_in(home_of({{"KeyChain"}, {"KeyChain"}, {"Desk"}}), goal, knowledge),
              Each(HasSubstr("a set of keys")));
  const char* beside = "(exists (?d - (Drawer :where (exists (?a - KeyChain) (inside ?a ?d)))) (at-end (open ?d)))";
  EXPECT_THAT(check_instruction("Open the drawer where the keys are kept.", asking(beside), knowledge,
                                NounTable(knowledge, committed_names())),
              IsEmpty());
  // "Bananas" is a synonym, too, which does not make one of them.
  const char* all = "(at-end (exists (?t - diningtable) (forall (?a - bananas) (on ?a ?t))))";
  EXPECT_THAT(texts_in(home_of({{"bananas"}, {"diningtable"}}), all, committed_knowledge(Simulator::Virtualhome)),
              Each(Not(HasSubstr(": "))));
  // Where a single key is a thing of its own, "the keys" are several of those.
  EXPECT_EQ(NounTable(committed_knowledge(Simulator::Behavior), committed_names()).without_set("keys"), "");
}

TEST(Opened, FurnitureThatIsToStayOpenIsLeftOpen) {
  const char* goal = "(exists (?f - Fridge) (exists (?e - Egg) (at-end (and (open ?f) (inside ?e ?f)))))";
  const Scene home = home_of({{"Fridge", "closed"}, {"Egg"}});
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const NounTable nouns(knowledge, committed_names());
  const auto faults = [&](const char* text) { return check_instruction(text, asking(goal), knowledge, nouns, &home); };
  EXPECT_THAT(texts_in(home, goal, knowledge), Each(HasSubstr("leave it open.")));
  EXPECT_THAT(faults("Open the fridge and put the egg in it. Leave it open."), IsEmpty());
  EXPECT_THAT(faults("Put the egg in the fridge. Leave it open."), IsEmpty());
  EXPECT_THAT(faults("Open the fridge and put the egg in it. Leave it closed."), Not(IsEmpty()));
}

TEST(Halves, AndLeavesAreCountedAsPeopleDo) {
  const NounTable foods(committed_knowledge(Simulator::Behavior), committed_names());
  EXPECT_EQ(foods.display("half_crawfish")->plural, "crawfish halves");
  EXPECT_EQ(NounTable(committed_knowledge(Simulator::Ai2thor), committed_names()).display("LettuceSliced")->singular,
            "piece of lettuce");
}

}  // namespace
}  // namespace unietp
