#include "grounding/packing.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

Collider box(double width) {
  Shape shape;
  shape.parts.push_back({Part::Kind::Box, {}, Vec3(width, 0.1, 0.1), -1});
  return {shape, 0};
}

std::vector<Pose> along(std::initializer_list<double> places) {
  std::vector<Pose> spots;
  for (const double x : places) spots.push_back({Vec3(x, 0, 0), Quat::Identity()});
  return spots;
}

TEST(Packing, EachThingHasASpotOfItsOwn) {
  const Collider wide = box(0.4), narrow = box(0.2);
  EXPECT_TRUE(fit_together({{&wide, along({0, 0.2})}, {&narrow, along({0, 0.5})}}));
  EXPECT_FALSE(fit_together({{&wide, along({0, 0.2})}, {&narrow, along({0, 0.1})}}));
  EXPECT_FALSE(fit_together({{&wide, along({0})}, {&narrow, {}}}));
}

TEST(Packing, AFirstChoiceIsTakenBackWhereTheNextThingWouldFindNothing) {
  const Collider wide = box(0.4);
  // The middle spot comes first and leaves no room for any other.
  EXPECT_TRUE(fit_together({{&wide, along({0.2, 0, 0.45})}, {&wide, along({0.2, 0, 0.45})}}));
  EXPECT_FALSE(
      fit_together({{&wide, along({0.2, 0, 0.45})}, {&wide, along({0.2, 0, 0.45})}, {&wide, along({0.2, 0, 0.45})}}));
}

TEST(Packing, WhatOnlyTouchesFits) {
  const Collider wide = box(0.4);
  EXPECT_TRUE(fit_together({{&wide, along({0})}, {&wide, along({0.4})}}));
  EXPECT_FALSE(fit_together({{&wide, along({0})}, {&wide, along({0.39})}}));
}

}  // namespace
}  // namespace unietp
