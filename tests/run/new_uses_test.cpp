// Texts that call things by what they are for are about many kinds of things.
#include "run/new_uses.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../resources/committed.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Template& place_one_on() {
  return *std::find_if(committed().templates.begin(), committed().templates.end(),
                       [](const Template& one) { return one.name == "place-one-on"; });
}
const Knowledge& ai2thor() { return committed().backend(Simulator::Ai2thor).knowledge; }

TEST(NewUses, AreTheKindsThatAStyleHasWordsFor) {
  const Binding mug{{"A", "Mug"}, {"B", "DiningTable"}}, keys{{"A", "KeyChain"}, {"B", "DiningTable"}};
  EXPECT_THAT(uses_of(place_one_on(), mug, Style::Function, ai2thor()), ElementsAre(Trait{Dimension::Use, "cup"}));
  EXPECT_THAT(uses_of(place_one_on(), mug, Style::Direct, ai2thor()), IsEmpty());
  EXPECT_THAT(uses_of(place_one_on(), mug, std::nullopt, ai2thor()), IsEmpty());
  EXPECT_THAT(uses_of(place_one_on(), keys, Style::Function, ai2thor()), IsEmpty());  // nothing to do with it
}

TEST(NewUses, OthersComeFirst) {
  const Parameter& thing = place_one_on().parameters.front();
  const CategoryWeight even = [](const Parameter&, const std::string&) { return 1.0; };
  Frequencies counts;
  const auto weight = [&](std::optional<Style> style, const std::string& category, int part) {
    return with_new_uses(even, {style, 1, part}, place_one_on(), ai2thor(), counts)(thing, category);
  };
  const double before = weight(Style::Function, "Mug", 0);
  counts.add({Dimension::Use, "cup"});
  EXPECT_LT(weight(Style::Function, "Mug", 0), 0.1 * before);
  EXPECT_EQ(weight(Style::Function, "KeyChain", 0), 1);  // has no such words
  EXPECT_EQ(weight(Style::Direct, "Mug", 0), 1);
  int preferred = 0;
  for (int part = 0; part < kUseParts; ++part) preferred += weight(Style::Function, "Apple", part) == 1 ? 1 : 0;
  EXPECT_EQ(preferred, 1);
}

}  // namespace
}  // namespace unietp
