#include "templates/phrasing.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

Knowledge two_categories() {
  Category mug;
  mug.name = "Mug";
  mug.display = "mug";
  mug.plural = "mugs";
  mug.source = {"curated", 1};
  Category bread = mug;
  bread.name = "Bread";
  bread.display = bread.plural = "bread";
  bread.countable = false;
  Category oven = mug;
  oven.name = "Oven";
  oven.display = "oven";
  oven.plural = "ovens";
  return Knowledge(Simulator::Ai2thor, {bread, mug, oven}, {}, {}, {}, {});
}

TEST(Phrasing, SlotsTakeTheFormTheyAskFor) {
  const auto knowledge = two_categories();
  const auto filled = [&](std::string_view text) {
    return fill_phrasing(text, {{"A", "Mug"}, {"B", "Bread"}, {"C", "Oven"}, {"R", "Kitchen"}}, knowledge);
  };
  EXPECT_EQ(filled("Put two {A:plural} and {B:indefinite} {C:into}."), "Put two mugs and some bread into the oven.");
  EXPECT_EQ(filled("{C:indefinite} is in {R:definite}."), "An oven is in the kitchen.");
  EXPECT_EQ(filled("Take {A} {C:out-of}; keep {B:slice}."), "Take mug out of the oven; keep a slice of bread.");
  EXPECT_EQ(filled("{D:plural} stay."), "{D:plural} stay.");
}

TEST(Phrasing, MalformedSlotsAreNamedWithTheirPlace) {
  const auto reading = read_slots("Open {a}, {A:many}, {A and }B.");
  ASSERT_EQ(reading.errors.size(), 3U);
  EXPECT_EQ(reading.errors[0].pos.column, 6);
  EXPECT_NE(reading.errors[1].message.find("unknown form 'many'"), std::string::npos);
  EXPECT_TRUE(reading.slots.empty());
}

TEST(Phrasing, EveryFormHasAnExampleAndIsUnderstood) {
  for (const auto& form : slot_forms()) {
    const auto reading = read_slots("{A:" + std::string(form.name) + "}");
    EXPECT_TRUE(reading.errors.empty()) << form.name;
    EXPECT_FALSE(form.example.empty()) << form.name;
  }
}

}  // namespace
}  // namespace unietp
