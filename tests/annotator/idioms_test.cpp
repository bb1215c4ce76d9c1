// What people say in one breath: read as exactly its goal, and written for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "annotator/everyday_names.h"
#include "annotator/home_counts.h"
#include "annotator/meaning.h"
#include "annotator/noun_table.h"
#include "core/text.h"
#include "scene/trace.h"
#include "small_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::asking;
using testing_support::small_knowledge;

struct Said {
  const char* text;
  const char* goal;
  const char* words;  // that some text of the goal has
};

constexpr Said kSaid[] = {
    {"Take all the mugs off the table and put them down.",
     "(exists (?t - Table) (at-end (and (count = 0 (?a - Mug) (on ?a ?t)) (count = 0 (?b - Mug) (held ?b)))))",
     " and put them somewhere else"},
    {"Take the mug off the table.", "(at-end (forall (?t - Table) (forall (?a - Mug) (not (on ?a ?t)))))", nullptr},
    {"Leave exactly one mug on the table and put the others somewhere else.",
     "(exists (?t - Table) (at-end (and (count = 1 (?a - Mug) (on ?a ?t)) (count = 0 (?b - Mug) (held ?b)))))",
     "and put the others somewhere else"},
    {"Divide all the mugs between the table and the coffee table, with at least one on each.",
     "(exists (?t - Table) (exists (?c - CoffeeTable) (at-end (and (forall (?a - Mug) (or (on ?a ?t) (on ?a ?c)))"
     " (exists (?b - Mug) (on ?b ?t)) (exists (?d - Mug) (on ?d ?c))))))",
     "ivide all the mugs between"},
    {"Put the same number of mugs on the table and on the coffee table, with at least one on each.",
     "(exists (?t - Table) (exists (?c - CoffeeTable) (at-end (and (exists (?b - Mug) (on ?b ?c))"
     " (count = (number (?a - Mug) (on ?a ?t)) (number (?e - Mug) (on ?e ?c)))))))",
     "plit the mugs evenly between"},
    {"Put more mugs than bowls in the fridge.",
     "(exists (?f - Fridge) (at-end (count > (number (?a - Mug) (inside ?a ?f)) (number (?b - Bowl) (inside ?b ?f)))))",
     "ut more mugs than bowls in"},
    {"Keep the fridge closed until the mug is on the table, then open the fridge.",
     "(exists (?f - Fridge) (exists (?m - Mug) (exists (?t - Table) (and (until (closed ?f) (on ?m ?t))"
     " (at-end (and (on ?m ?t) (open ?f)))))))",
     ", then open "},
    {"Put all the bowls on the table, and only then all the mugs.",
     "(exists (?t - Table) (and (until (count = 0 (?b - Mug) (on ?b ?t)) (forall (?a - Bowl) (on ?a ?t)))"
     " (at-end (and (forall (?a - Bowl) (on ?a ?t)) (forall (?b - Mug) (on ?b ?t))))))",
     " first, and then "},
    {"Fill the mug with water, then pour it into the bowl.",
     "(exists (?a - Mug) (exists (?b - Bowl) (and (before (filled ?a water) (filled ?b water))"
     " (at-end (filled ?b water)))))",
     "pour it into"},
    {"Slice the apple, then cook a slice of it.",
     "(exists (?a - Apple) (exists (?s - Apple/slice) (and (before (sliced ?a) (cooked ?s))"
     " (at-end (and (slice_of ?s ?a) (cooked ?s))))))",
     "cook one of the slices"},
    {"Open the fridge, take all the mugs out of it and put them down, and close it again.",
     "(exists (?f - Fridge) (and (sometime (open ?f)) (at-end (and (closed ?f) (count = 0 (?a - Mug) (inside ?a ?f))"
     " (count = 0 (?b - Mug) (held ?b))))))",
     ", and close "},
    {"If the fridge is open, put a mug in it. If not, put one on a table.",
     "(or (exists (?f - (Fridge :where (open ?f))) (exists (?m - Mug) (at-end (inside ?m ?f))))"
     " (exists (?f - (Fridge :where (closed ?f))) (exists (?m - Mug) (exists (?t - Table) (at-end (on ?m ?t))))))",
     nullptr},
    {"Put a mug on the table. Do not open any fridge.",
     "(exists (?t - Table) (exists (?m - Mug) (and (at-end (on ?m ?t)) (forall (?f - Fridge) (always (closed ?f))))))",
     "o not open any fridge"},
    {"Close the open fridge. Leave the others closed.",
     "(and (exists (?f - (Fridge :where (open ?f))) (at-end (closed ?f)))"
     " (forall (?y - (Fridge :where (closed ?y))) (always (closed ?y))))",
     "the others"},
    {"Put a mug in the fridge. Leave the one on the table where it is.",
     "(exists (?f - Fridge) (exists (?m - Mug) (and (at-end (inside ?m ?f))"
     " (always (forall (?d - (Mug :where (exists (?t - Table) (on ?d ?t)))) (exists (?u - Table) (on ?d ?u)))))))",
     nullptr},
    {"Put a mug on the table. Don't open the fridge, it's still running.",
     "(exists (?t - Table) (exists (?m - Mug) (and (at-end (on ?m ?t))"
     " (forall (?f - (Fridge :where (power_on ?f))) (always (closed ?f))))))",
     nullptr},
    {"Take the mug out of the fridge and put it on a table.",
     "(exists (?m - (Mug :where (exists (?f - Fridge) (inside ?m ?f)))) (exists (?t - Table) (at-end (on ?m ?t))))",
     "ake the mug out of the fridge and put it on"},
    {"Put two mugs on the table and make sure that there are as many mugs as bowls on the table.",
     "(exists (?t - Table) (at-end (and (count = 2 (?m - Mug) (on ?m ?t))"
     " (count = (number (?a - Mug) (on ?a ?t)) (number (?b - Bowl) (on ?b ?t))))))",
     ", one for each bowl there"},
    {"Put enough mugs on the table, one for each bowl there.",
     "(exists (?t - Table) (at-end (and (count >= 2 (?m - Mug) (on ?m ?t))"
     " (count = (number (?a - Mug) (on ?a ?t)) (number (?b - Bowl) (on ?b ?t))))))",
     "enough mugs on a table, one for each bowl there"},
    {"Put two mugs on the table, one for each bowl there.",
     "(exists (?t - Table) (at-end (and (count = 2 (?m - Mug) (on ?m ?t))"
     " (count = (number (?a - Mug) (on ?a ?t)) (number (?b - Bowl) (on ?b ?t))))))",
     nullptr},
    {"Split the mugs evenly between the table and the coffee table.",
     "(exists (?t - Table) (exists (?c - CoffeeTable) (at-end (and (exists (?b - Mug) (on ?b ?c))"
     " (count = (number (?a - Mug) (on ?a ?t)) (number (?e - Mug) (on ?e ?c)))))))",
     nullptr},
    {"Put each of the mugs in a fridge or on a table.",
     "(forall (?m - Mug) (at-end (or (exists (?f - Fridge) (inside ?m ?f)) (exists (?t - Table) (on ?m ?t)))))",
     nullptr},
    {"Put the mug in the fridge, then the apple.",
     "(exists (?f - Fridge) (exists (?m - Mug) (exists (?a - Apple) (and (before (inside ?m ?f) (inside ?a ?f))"
     " (at-end (and (inside ?m ?f) (inside ?a ?f)))))))",
     ", then "},
    {"Put the mug in the fridge. Once it's in, close the fridge.",
     "(exists (?f - Fridge) (exists (?m - Mug) (and (before (inside ?m ?f) (closed ?f))"
     " (at-end (and (inside ?m ?f) (closed ?f))))))",
     nullptr},
    {"Cut a slice of apple and chill it.", "(exists (?s - Apple/slice) (at-end (cool ?s)))",
     "ut a slice of apple and chill it"},
    {"Heat the bread, chill the apple and put both on the table.",
     "(exists (?a - Bread) (exists (?b - Apple) (exists (?t - Table) (at-end (and (hot ?a) (cool ?b) (on ?a ?t) (on ?b "
     "?t))))))",
     " and put both on "},
    {"Put two mugs on the table and leave no more than one on the coffee table.",
     "(exists (?t - Table) (exists (?c - CoffeeTable) (at-end (and (count = 2 (?m - Mug) (on ?m ?t))"
     " (count <= 1 (?o - Mug) (on ?o ?c))))))",
     "nly one can stay on "},
    {"Put a mug on the table and don't leave any on the coffee table.",
     "(exists (?t - Table) (exists (?c - CoffeeTable) (exists (?m - Mug) (at-end (and (on ?m ?t)"
     " (forall (?o - Mug) (not (on ?o ?c))))))))",
     nullptr},
    {"Take all the mugs out of the fridge, put them somewhere else, and close the fridge again.",
     "(exists (?f - Fridge) (and (sometime (open ?f)) (at-end (and (closed ?f) (count = 0 (?a - Mug) (inside ?a ?f))"
     " (count = 0 (?b - Mug) (held ?b))))))",
     nullptr},
    {"Swap the mug on the table and the apple on the coffee table.",
     "(exists (?c - CoffeeTable) (exists (?m - (Mug :where (exists (?t - Table) (on ?m ?t)))) (exists (?a - (Apple "
     ":where (on ?a ?c))) (exists (?u - Table) (at-end (and (on ?m ?c) (on ?a ?u)))))))",
     nullptr},
    {"Turn on the lamp, put a mug on the table, and turn the lamp off again.",
     "(exists (?l - Lamp) (exists (?m - Mug) (exists (?t - Table) (and (sometime (power_on ?l))"
     " (at-end (and (power_off ?l) (on ?m ?t)))))))",
     " off again"},
    {"Put all the mugs either in the fridges or on the tables.",
     "(forall (?m - Mug) (at-end (or (exists (?f - Fridge) (inside ?m ?f)) (exists (?t - Table) (on ?m ?t)))))",
     "ut each of the mugs in a fridge or on a table"},
    {"Put all the mugs on the table except the red one.",
     "(exists (?t - Table) (and (always (forall (?r - (Mug :where (colour ?r red))) (not (on ?r ?t))))"
     " (at-end (forall (?m - (Mug :where (not (colour ?m red)))) (on ?m ?t)))))",
     nullptr},
    {"Take the mug out of the fridge and put it on the table. Put the apple there, too.",
     "(exists (?t - Table) (exists (?m - (Mug :where (exists (?f - Fridge) (inside ?m ?f)))) (exists (?a - Apple)"
     " (at-end (and (on ?m ?t) (on ?a ?t))))))",
     nullptr},
    {"If the fridge is open, put a mug in it. If not, put a mug on a table.",
     "(or (exists (?f - (Fridge :where (open ?f))) (exists (?m - Mug) (at-end (inside ?m ?f))))"
     " (exists (?f - (Fridge :where (closed ?f))) (exists (?m - Mug) (exists (?t - Table) (at-end (on ?m ?t))))))",
     nullptr},
};

TEST(Idioms, AreReadAsExactlyTheirGoals) {
  const Knowledge knowledge = small_knowledge();
  for (const Said& said : kSaid) {
    const auto faults = check_instruction(said.text, asking(said.goal, "direct"), knowledge);
    EXPECT_TRUE(faults.empty()) << said.text << ": " << (faults.empty() ? "" : faults.front());
  }
}

TEST(Idioms, AreWrittenForTheirGoals) {
  const Knowledge knowledge = small_knowledge();
  const NounTable nouns(knowledge, committed_names());
  for (const Said& said : kSaid) {
    if (said.words == nullptr) continue;  // needs a home with one fridge
    std::vector<std::string> texts;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const auto written = write_instruction(asking(said.goal, "direct"), knowledge, nouns, {}, Rng(seed));
      ASSERT_TRUE(written) << said.goal << ": " << format(written.error());
      texts.push_back(written->text);
    }
    EXPECT_THAT(texts, Contains(HasSubstr(said.words))) << said.goal;
  }
}

TEST(Idioms, FurnitureIsCleanedAndDishesAreWashed) {
  const Knowledge knowledge = small_knowledge();
  const NounTable nouns(knowledge, committed_names());
  const auto texts = [&](const std::string& category) {
    std::vector<std::string> all;
    const auto asked = asking("(exists (?a - " + category + ") (at-end (clean ?a)))", "direct");
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const auto written = write_instruction(asked, knowledge, nouns, {}, Rng(seed));
      EXPECT_TRUE(written) << category;
      all.push_back(written ? lower(written->text) : "");
    }
    return all;
  };
  EXPECT_THAT(texts("CoffeeTable"), Each(Not(HasSubstr("wash "))));
  EXPECT_THAT(texts("Mug"), Contains(HasSubstr("wash ")));
}

TEST(Idioms, WithOneWordChangedMeanSomethingElse) {
  const Knowledge knowledge = small_knowledge();
  constexpr std::pair<const char*, std::size_t> kChanged[] = {
      {"Take all the mugs off the table.", 0},
      {"Leave exactly two mugs on the table and put the others somewhere else.", 2},
      {"Put the same number of bowls on the table and on the coffee table, with at least one on each.", 4},
      {"Put more bowls than mugs in the fridge.", 5},
      {"Keep the fridge closed until the mug is on the table.", 6},
      {"Put all the mugs on the table, and only then all the bowls.", 7},
      {"Fill the mug with water, then fill the bowl with water.", 8},
      {"Slice the apple, then cook a slice of apple.", 9},
      {"If the fridge is closed, put a mug in it. If not, put it on a table.", 11},
      {"Put two mugs on the table and make sure that there are as many mugs as apples on the table.", 16},
      {"Put two mugs on the table, one for each apple there.", 17},
      {"Split the bowls evenly between the table and the coffee table.", 18},
      {"Put each of the bowls in a fridge or on a table.", 19},
      {"Put the apple in the fridge, then the mug.", 20},
      {"Put the mug in the fridge. Once it's in, open the fridge.", 21},
      {"Cut a slice of apple and heat it up.", 22},
      {"Heat the bread, chill the apple and put both on the coffee table.", 23},
      {"Put two mugs on the table and leave no more than two on the coffee table.", 24},
      {"Put a mug on the coffee table and don't leave any on the table.", 25},
      {"Take all the mugs out of the fridge, put them somewhere else, and close the fridge.", 26},
      {"Swap the mug on the coffee table and the apple on the table.", 27},
      {"Turn off the lamp, put a mug on the table, and turn the lamp on again.", 28}};
  for (const auto& [text, of] : kChanged)
    EXPECT_FALSE(check_instruction(text, asking(kSaid[of].goal, "direct"), knowledge).empty()) << text;
}

/// A home of things called "table_1", of a kind and in a state each.
Scene home_of(std::initializer_list<std::pair<const char*, const char*>> kinds) {
  Scene home;
  for (const auto& [kind, state] : kinds) {
    Node node;
    node.id = lower(kind) + "_" + std::to_string(home.nodes.size() + 1);
    node.category = kind;
    if (*state != '\0') node.states.set({*predicate_named(state), ""});
    home.nodes.push_back(node);
  }
  return home;
}

TEST(HomeCounts, MakeAllAndSomeOfOneThingTheSame) {
  const auto goal = [](const char* text) { return *parse_formula("test", text, FormulaUse::Goal); };
  const Trace start = to_logic(home_of({{"Table", ""}, {"Mug", "dirty"}, {"Mug", "clean"}}), {});
  const auto here = [&](const char* text) { return expanded(as_in_home(goal(text), HomeCounts(start))); };
  const char* all = "(forall (?m - Mug) (forall (?t - Table) (at-end (not (on ?m ?t)))))";
  EXPECT_TRUE(same_expanded(here(all), here("(exists (?t - Table) (at-end (forall (?m - Mug) (not (on ?m ?t)))))")));
  EXPECT_FALSE(same_expanded(here(all), here("(exists (?t - Table) (at-end (exists (?m - Mug) (not (on ?m ?t)))))")));
  EXPECT_FALSE(
      same_expanded(here("(forall (?m - Mug) (at-end (clean ?m)))"), here("(exists (?m - Mug) (at-end (clean ?m)))")));
  EXPECT_TRUE(same_expanded(here("(forall (?m - (Mug :where (dirty ?m))) (at-end (clean ?m)))"),
                            here("(exists (?m - (Mug :where (dirty ?m))) (at-end (clean ?m)))")));
  EXPECT_FALSE(same_expanded(here("(forall (?m - (Mug :where (dirty ?m))) (at-end (clean ?m)))"),
                             here("(exists (?m - (Mug :where (clean ?m))) (at-end (clean ?m)))")));
  EXPECT_TRUE(same_expanded(here("(at-end (count = 2 (?m - Mug) (clean ?m)))"),
                            here("(forall (?m - Mug) (at-end (clean ?m)))")));
  EXPECT_FALSE(same_expanded(here("(at-end (count <= 2 (?m - Mug) (clean ?m)))"),
                             here("(forall (?m - Mug) (at-end (clean ?m)))")));
}

TEST(HomeCounts, AreWhatATextSaysOfOneTwoAndMore) {
  const Knowledge knowledge = small_knowledge();
  const NounTable nouns(knowledge, committed_names());
  const Scene home = home_of({{"Table", ""},
                              {"Mug", "dirty"},
                              {"Bowl", "clean"},
                              {"Bowl", "dirty"},
                              {"Fridge", "open"},
                              {"Fridge", "closed"},
                              {"Apple", ""},
                              {"Apple", ""},
                              {"Apple", ""}});
  constexpr std::array<const char*, 3> kSaidHere[] = {
      {"(forall (?m - Mug) (at-end (clean ?m)))", "the mug.", "all"},
      {"(forall (?m - (Bowl :where (dirty ?m))) (at-end (clean ?m)))", "the dirty bowl.", "all"},
      {"(forall (?m - Bowl) (at-end (clean ?m)))", "both bowls", "all"},
      {"(exists (?t - Table) (at-end (count = 2 (?m - Bowl) (on ?m ?t))))", "both bowls on the table.", "exactly"},
      {"(exists (?t - Table) (at-end (count = 3 (?m - Apple) (on ?m ?t))))", "all the apples on the table.", "exactly"},
      {"(exists (?t - Table) (at-end (count = 2 (?m - Apple) (on ?m ?t))))", "two apples on the table.", "all"},
      {"(and (exists (?f - (Fridge :where (open ?f))) (at-end (closed ?f)))"
       " (forall (?y - (Fridge :where (closed ?y))) (always (closed ?y))))",
       "the other one", "others"}};
  for (const auto& [goal, words, never] : kSaidHere) {
    std::vector<std::string> texts;
    WritingOptions options;
    options.home = &home;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const auto written = write_instruction(asking(goal), knowledge, nouns, options, Rng(seed));
      ASSERT_TRUE(written) << goal << ": " << format(written.error());
      texts.push_back(written->text);
    }
    EXPECT_THAT(texts, Contains(HasSubstr(words))) << goal;
    EXPECT_THAT(texts, Each(Not(HasSubstr(never)))) << goal;
  }
}

TEST(EverydayNames, AreThoseOfOneEnglishAndBothAreRead) {
  Category stove;
  stove.name = "Stove";
  stove.display = "oven stove";
  stove.plural = "oven stoves";
  const Knowledge knowledge(Simulator::Ai2thor, {stove}, {}, {}, {}, {});
  const NounTable us(knowledge, committed_names()), gb(knowledge, committed_names(), English::Gb);
  EXPECT_EQ(us.display("Stove")->singular, "stove");
  EXPECT_EQ(gb.display("Stove")->singular, "cooker");
  for (const NounTable* nouns : {&us, &gb})
    for (const char* name : {"stove", "cooker", "oven stove"}) EXPECT_TRUE(nouns->is_name(name)) << name;
}

}  // namespace
}  // namespace unietp
