// Holds the placements against the bodies that the physics builds: an oracle that shares no code with akb/fit.cpp.
#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "simulation/shape.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

/// True when the box stands, turned or not, on one surface of the shape: `inside` on a cavity's floor, `on` outside
/// any.
bool stands(const Shape& shape, const Vec3& object, bool inside) {
  return std::any_of(shape.surfaces.begin(), shape.surfaces.end(), [&](const Surface& s) {
    if ((s.cavity >= 0) != inside) return false;
    const bool straight = object.x() <= 2 * s.half.x() && object.y() <= 2 * s.half.y();
    const bool turned = object.y() <= 2 * s.half.x() && object.x() <= 2 * s.half.y();
    return (straight || turned) && object.z() <= s.clearance;
  });
}

TEST(PlacementsInBodies, EveryPlacementHasASurfaceThatIsLargeEnough) {
  for (const auto simulator : kSimulators) {
    const auto tables = test::committed(simulator);
    std::map<std::string, const Category*> by_name;
    std::set<std::string> openable;
    for (const auto& c : tables.categories) by_name[c.name] = &c;
    for (const auto& f : tables.affordances) {
      if (f.affordance == "openable") openable.insert(f.category);
    }
    std::size_t bad = 0;
    for (const auto& p : tables.placements) {
      const Category& r = *by_name.at(p.receptacle);
      const auto shape = make_shape(r.archetype, r.size, openable.contains(r.name));
      if (stands(shape, by_name.at(p.object)->size, p.relation == "inside")) continue;
      ++bad;
      ADD_FAILURE() << name_of(simulator) << ": " << p.object << " " << p.relation << " " << p.receptacle;
      if (bad > 20) return;
    }
  }
}

TEST(PlacementsInBodies, EveryOpenableHasAJoint) {
  for (const auto simulator : kSimulators) {
    const auto tables = test::committed(simulator);
    for (const auto& f : tables.affordances) {
      if (f.affordance != "openable") continue;
      const Category& c = test::category(tables, f.category);
      EXPECT_FALSE(make_shape(c.archetype, c.size, true).joints.empty()) << name_of(simulator) << ": " << c.name;
    }
  }
}

}  // namespace
}  // namespace unietp
