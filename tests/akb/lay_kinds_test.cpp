// What data/sense says of the kinds of categories and of what things are for, laid over the tables.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "akb/lay_kinds.h"
#include "core/files.h"
#include "core/text.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kKinds = "name,singular,parent\nthing,thing,\nfood,food,thing\nfruit,fruit,food\ncup,cup,thing\n";
const std::string kCategories =
    "simulator,category,kind,source\nai2thor,apple,fruit,curated\nai2thor,mug,cup,curated\nhabitat,apple,food,"
    "curated\n";

class LayKinds : public ::testing::Test {
 protected:
  void SetUp() override {
    test::write_small_tables(folder.path() / "akb", test::small_tables());
    write("kinds", kKinds);
    write("categories", kCategories);
  }
  void write(const std::string& table, const std::string& text) const {
    ASSERT_TRUE(write_file(folder.path() / "sense" / (table + ".csv"), text));
  }
  void functions(const std::string& rows) const {
    write("functions", "function,phrases,kinds,also,except,source\n" + rows);
  }
  std::vector<Tables> lay() { return read_all_tables(folder.path() / "akb", {}, errors); }
  std::string only_error() const { return errors.size() == 1 ? format(errors.front()) : std::to_string(errors.size()); }

  ScratchFolder folder;
  std::vector<Error> errors;
};

std::vector<std::string> phrases_of(const Tables& tables, const std::string& category) {
  std::vector<std::string> texts;
  for (const auto& alias : tables.aliases) {
    if (alias.category == category && alias.kind == AliasKind::Function) texts.push_back(alias.text);
  }
  return texts;
}

TEST_F(LayKinds, AKindComesWithAllWiderOnesNarrowestFirst) {
  const auto all = lay();
  ASSERT_THAT(errors, IsEmpty());
  EXPECT_THAT(test::category(all[0], "apple").kinds, ElementsAre("fruit", "food", "thing"));
  EXPECT_THAT(test::category(all[0], "plate").kinds, IsEmpty());
  EXPECT_THAT(test::category(all[2], "apple").kinds, ElementsAre("food", "thing"));
}

TEST_F(LayKinds, AFunctionHasTheCategoriesOfItsKindsAndThoseNamedWithoutTheExcluded) {
  functions("eat,something to eat|anything to eat,food,half_apple|plate,plate,curated\n");
  const auto all = lay();
  ASSERT_THAT(errors, IsEmpty());
  EXPECT_THAT(phrases_of(all[0], "apple"), ElementsAre("anything to eat", "something to eat"));
  EXPECT_THAT(phrases_of(all[0], "half_apple"), ElementsAre("anything to eat", "something to eat"));
  EXPECT_THAT(phrases_of(all[0], "plate"), IsEmpty());
  EXPECT_THAT(phrases_of(all[1], "apple"), IsEmpty()) << "it has no kind there";
}

TEST_F(LayKinds, APhraseThatTheTablesHaveStandsOnce) {
  functions("drink,something to drink from,cup,,,curated\n");
  EXPECT_THAT(phrases_of(lay()[0], "mug"), ElementsAre("something to drink from"));
}

TEST_F(LayKinds, ReportsEveryFaultAtItsCell) {
  functions("eat,something to eat,fod,,,curated\n");
  lay();
  EXPECT_THAT(only_error(), HasSubstr("functions.csv:2:22: schema error: 'fod' is not a kind of kinds.csv"));
  errors.clear();
  functions("eat,something to eat,food,aple,,curated\n");
  lay();
  EXPECT_THAT(only_error(), HasSubstr("2:27: schema error: no simulator has a category that is called 'aple'"));
  errors.clear();
  functions("a,something to eat,food,,,curated\nb,something to eat,cup,,,curated\n");
  lay();
  EXPECT_THAT(only_error(), HasSubstr("3:3: schema error: 'something to eat' stands twice"));
  errors.clear();
  functions("a,something to eat,,plate,plate,curated\n");
  lay();
  EXPECT_THAT(only_error(), HasSubstr("2:1: schema error: no simulator has a category that serves as this"));
}

/// One row of each trait, the first as told.
std::string traits(const std::string& one_size) {
  std::string text = "trait,kinds,also,except,source\none_size," + one_size + ",curated\n";
  for (const KindTrait trait : kKindTraits)
    if (trait != KindTrait::OneSize) text += std::string(name_of(trait)) + ",,,,curated\n";
  return text;
}

TEST_F(LayKinds, ATraitHasTheCategoriesOfItsKindsAndThoseNamedWithoutTheExcluded) {
  write("kind_traits", traits("food,plate,half_apple"));
  const auto all = lay();
  ASSERT_THAT(errors, IsEmpty());
  EXPECT_TRUE(has_trait(test::category(all[0], "apple"), KindTrait::OneSize));
  EXPECT_TRUE(has_trait(test::category(all[0], "plate"), KindTrait::OneSize)) << "it is named, and has no kind";
  EXPECT_FALSE(has_trait(test::category(all[0], "half_apple"), KindTrait::OneSize));
  EXPECT_FALSE(has_trait(test::category(all[0], "mug"), KindTrait::OneSize));
  EXPECT_FALSE(has_trait(test::category(all[0], "apple"), KindTrait::Dish));
}

TEST_F(LayKinds, ReportsFaultsOfTraits) {
  write("kind_traits", traits("fod,,"));
  lay();
  ASSERT_THAT(errors, ::testing::Not(IsEmpty()));
  EXPECT_THAT(format(errors.front()),
              HasSubstr("kind_traits.csv:2:10: schema error: 'fod' is not a kind of kinds.csv"));
  errors.clear();
  write("kind_traits", "trait,kinds,also,except,source\nhuge,food,,,curated\n");
  lay();
  EXPECT_THAT(only_error(), HasSubstr("kind_traits.csv:2:1"));
  errors.clear();
  write("kind_traits", "trait,kinds,also,except,source\ndish,food,,,curated\n");
  lay();
  EXPECT_THAT(only_error(), HasSubstr("no row of 'one_size'"));
}

class CommittedFunctions : public ::testing::Test {
 protected:
  void SetUp() override {
    std::vector<Error> errors;
    all = read_all_tables(test::committed_tables(), {}, errors);
    ASSERT_THAT(errors, IsEmpty());
  }
  std::vector<Tables> all;
};

TEST_F(CommittedFunctions, ManyAreServedByAKindAndHalfHaveSeveralPhrases) {
  std::map<std::string, std::set<std::string>> phrases, members;
  for (const auto& tables : all) {
    std::map<std::string, std::set<std::string>> here;
    for (const auto& alias : tables.aliases) {
      if (!alias.source.source.starts_with("derived:function:")) continue;
      phrases[alias.source.source].insert(alias.text);
      here[alias.source.source].insert(alias.category);
    }
    for (const auto& [function, categories] : here) {
      if (categories.size() > members[function].size()) members[function] = categories;
    }
  }
  int wide = 0, several = 0;
  for (const auto& [function, texts] : phrases) {
    several += texts.size() >= 2 ? 1 : 0;
    wide += members[function].size() >= 2 ? 1 : 0;
  }
  EXPECT_GE(wide, 40);
  EXPECT_GE(several * 2, static_cast<int>(phrases.size()));
}

TEST_F(CommittedFunctions, EachTraitIsOfSomeCategoriesAndNotOfAll) {
  for (const KindTrait trait : kKindTraits) {
    std::size_t with = 0, without = 0;
    for (const auto& tables : all) {
      for (const auto& category : tables.categories) ++(has_trait(category, trait) ? with : without);
    }
    EXPECT_GT(with, 0U) << name_of(trait);
    EXPECT_GT(without, 0U) << name_of(trait);
  }
  EXPECT_TRUE(has_trait(test::category(all[0], "Egg"), KindTrait::OneSize));
  EXPECT_FALSE(has_trait(test::category(all[0], "Mug"), KindTrait::OneSize));
}

/// "a toy" would mean the category that is called toy.
TEST_F(CommittedFunctions, NoPhraseIsTheNameOfACategory) {
  for (const auto& tables : all) {
    std::set<std::string> names;
    for (const auto& category : tables.categories) names.insert({lower(category.display), lower(category.plural)});
    for (const auto& alias : tables.aliases) {
      if (alias.kind == AliasKind::Synonym) names.insert(lower(alias.text));
    }
    for (const auto& alias : tables.aliases) {
      if (alias.kind != AliasKind::Function) continue;
      for (const auto* article : {"a ", "an ", "any ", "some "}) {
        const bool begins = alias.text.starts_with(article);
        EXPECT_FALSE(begins && names.contains(alias.text.substr(std::string(article).size()))) << alias.text;
      }
    }
  }
}

}  // namespace
}  // namespace unietp
