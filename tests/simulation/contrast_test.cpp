// Which looks of one thing a picture tells apart.
#include "simulation/contrast.h"

#include <gtest/gtest.h>

#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

Node mug() {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  return object_of(knowledge, *knowledge.find("Mug"), 0);
}

TEST(Contrast, TellsColorsMaterialsAndStatesApartThatPicturesShow) {
  Node red = mug(), blue = red, metal = red, wooden = red, dirty = red;
  red.color = "red";
  blue.color = "blue";
  metal.material = "metal";
  wooden.material = "wood";
  dirty.states.set({Predicate::Dirty, ""});
  EXPECT_TRUE(distinguishable(contrast_of(red, blue, Simulator::Ai2thor)));
  EXPECT_TRUE(distinguishable(contrast_of(metal, wooden, Simulator::Ai2thor)));
  EXPECT_TRUE(distinguishable(contrast_of(mug(), dirty, Simulator::Ai2thor)));
}

TEST(Contrast, DoesNotTellApartWhatLooksTheSame) {
  Node clear = mug(), transparent = clear;
  clear.color = "clear";
  transparent.color = "transparent";
  const Contrast none = contrast_of(clear, transparent, Simulator::Ai2thor);
  EXPECT_EQ(none.mean, 0);
  EXPECT_EQ(none.clear, 0);
  EXPECT_FALSE(distinguishable(none));
}

TEST(Contrast, ComparesAThingWithItselfAsAnotherOneIs) {
  Node one = mug(), other = mug();
  one.states.set({Predicate::Dirty, ""});
  other.states.set({Predicate::Clean, ""});
  other.states.set({Predicate::Filled, "coffee"});
  other.color = "green";
  const auto clean = with_look_of(one, other, Predicate::Dirty);
  ASSERT_TRUE(clean);
  EXPECT_TRUE(clean->states.has(Predicate::Clean));
  EXPECT_FALSE(clean->states.has(Predicate::Filled));
  EXPECT_EQ(clean->color, one.color);
  EXPECT_EQ(with_look_of(one, other, Predicate::Color)->color, "green");
  EXPECT_EQ(with_look_of(one, one, Predicate::Dirty), std::nullopt);
  EXPECT_EQ(with_look_of(one, other, Predicate::On), std::nullopt);
}

}  // namespace
}  // namespace unietp
