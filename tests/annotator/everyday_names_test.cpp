// Things are called as people call them, not as a catalog lists them.
#include "annotator/everyday_names.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>

#include "annotator/noun_table.h"
#include "annotator/rare_names.h"
#include "core/text.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

TEST(EverydayNames, OfPackagesSayWhatIsInThem) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Behavior);
  const NounTable nouns(knowledge);
  int packages = 0;
  for (const Category& category : knowledge.categories()) {
    for (const std::string package : {"jar", "sack", "carton", "package"}) {
      if (!category.name.ends_with("_" + package) || category.kinds.empty() || category.kinds[0] == "outside") continue;
      const std::string content = category.name.substr(0, category.name.size() - package.size() - 1);
      // "The honey jar" is another category than "the jar of honey".
      if (content == "liquid" || content.starts_with("hinge") || knowledge.find(package + "_of_" + content) != nullptr)
        continue;
      ++packages;
      EXPECT_NE(nouns.display(category.name)->singular.find(" of "), std::string::npos) << category.name;
    }
  }
  EXPECT_GT(packages, 30);
}

TEST(EverydayNames, AreThoseOfOneCategoryInBothEnglishes) {
  for (const Simulator simulator : kSimulators) {
    const Knowledge& knowledge = committed_knowledge(simulator);
    for (const English english : {English::Us, English::Gb}) {
      const NounTable nouns(knowledge, english);
      std::map<std::string, std::string> named;
      for (const Category& category : knowledge.categories()) {
        const auto [at, is_new] = named.emplace(nouns.display(category.name)->singular, category.name);
        EXPECT_TRUE(is_new) << name_of(simulator) << ": " << category.name << " and " << at->second << " are both '"
                            << at->first << "'";
      }
    }
  }
}

TEST(EverydayNames, DifferBetweenTheTwoEnglishes) {
  EXPECT_EQ(everyday_name("chickpea can", English::Us), "can of chickpeas");
  EXPECT_EQ(everyday_name("chickpea can", English::Gb), "tin of chickpeas");
  EXPECT_EQ(everyday_name("mug", English::Us), "");
}

TEST(RareNames, AreNotSaid) {
  EXPECT_FALSE(is_said("multiport hub", English::Us));
  EXPECT_FALSE(is_said("rucksack", English::Us));
  EXPECT_TRUE(is_said("rucksack", English::Gb));
  EXPECT_TRUE(is_said("coffee mug", English::Us));
}

}  // namespace
}  // namespace unietp
