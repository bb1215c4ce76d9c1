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

/// True when the object, upright on the floor and turned or not, hits no part of the shape and has one over it.
bool goes_under(const Shape& shape, double height, const Vec3& object) {
  const auto free = [&](const Vec3& box) {
    const Vec3 low(-box.x() / 2, -box.y() / 2, -height / 2), high(box.x() / 2, box.y() / 2, -height / 2 + box.z());
    return std::none_of(shape.parts.begin(), shape.parts.end(), [&](const Part& part) {
      const Vec3 from = part.pose.position - part.size / 2, to = part.pose.position + part.size / 2;
      return (from.array() < high.array()).all() && (to.array() > low.array()).all();
    });
  };
  const bool covered = std::any_of(shape.parts.begin(), shape.parts.end(), [&](const Part& part) {
    const Vec3 from = part.pose.position - part.size / 2, to = part.pose.position + part.size / 2;
    return from.x() < 0 && to.x() > 0 && from.y() < 0 && to.y() > 0 && from.z() >= -height / 2 + object.z();
  });
  return covered && (free(object) || free({object.y(), object.x(), object.z()}));
}

/// True when both boxes, each turned or not, stand side by side on one surface of the shape.
bool stand_together(const Shape& shape, const Vec3& a, const Vec3& b) {
  return std::any_of(shape.surfaces.begin(), shape.surfaces.end(), [&](const Surface& s) {
    if (s.cavity >= 0 || std::max(a.z(), b.z()) > s.clearance) return false;
    for (int turns = 0; turns < 8; ++turns) {
      const bool along_y = (turns & 1) != 0, turn_a = (turns & 2) != 0, turn_b = (turns & 4) != 0;
      const Vec2 room = 2 * (along_y ? Vec2(s.half.y(), s.half.x()) : s.half);
      const Vec2 one = turn_a ? Vec2(a.y(), a.x()) : Vec2(a.x(), a.y());
      const Vec2 two = turn_b ? Vec2(b.y(), b.x()) : Vec2(b.x(), b.y());
      if (one.x() + two.x() <= room.x() && std::max(one.y(), two.y()) <= room.y()) return true;
    }
    return false;
  });
}

/// What the placements of one simulator say, held against its bodies.
class Bodies {
 public:
  explicit Bodies(const Tables& tables) {
    for (const auto& c : tables.categories) by_name_[c.name] = &c;
    for (const auto& f : tables.affordances) {
      if (f.affordance == "openable") openable_.insert(f.category);
    }
    for (const auto& p : tables.placements) {
      if (p.relation == Predicate::On) supports_[p.object].insert(p.receptacle);
    }
  }

  bool agree(const Placement& p) const {
    const Vec3& object = by_name_.at(p.object)->size;
    if (p.relation == Predicate::Under)
      return goes_under(shape(p.receptacle), by_name_.at(p.receptacle)->size.z(), object);
    if (p.relation != Predicate::NextTo) return stands(shape(p.receptacle), object, p.relation == Predicate::Inside);
    const auto own = supports_.find(p.object), its = supports_.find(p.receptacle);
    if (own == supports_.end() || its == supports_.end()) return false;
    return std::any_of(own->second.begin(), own->second.end(), [&](const std::string& support) {
      return its->second.contains(support) && stand_together(shape(support), object, by_name_.at(p.receptacle)->size);
    });
  }

 private:
  Shape shape(const std::string& name) const {
    const Category& c = *by_name_.at(name);
    return make_shape(c.archetype, c.size, openable_.contains(name));
  }

  std::map<std::string, const Category*> by_name_;
  std::set<std::string> openable_;
  std::map<std::string, std::set<std::string>> supports_;
};

TEST(PlacementsInBodies, EveryPlacementHasRoomInTheBodies) {
  for (const auto simulator : kSimulators) {
    const auto tables = test::committed(simulator);
    const Bodies bodies(tables);
    std::size_t bad = 0;
    EXPECT_FALSE(tables.placements.empty());
    for (const auto& p : tables.placements) {
      if (bodies.agree(p)) continue;
      ++bad;
      ADD_FAILURE() << name_of(simulator) << ": " << p.object << " " << info(p.relation).name << " " << p.receptacle;
      if (bad > 20) return;
    }
  }
}

TEST(PlacementsInBodies, AWrongOneIsSeen) {
  const auto tables = test::committed(Simulator::Ai2thor);
  const Bodies bodies(tables);
  EXPECT_TRUE(bodies.agree({"Mug", Predicate::On, "DiningTable", 1, 1, {}}));
  EXPECT_FALSE(bodies.agree({"Sofa", Predicate::On, "Mug", 1, 1, {}}));
  EXPECT_FALSE(bodies.agree({"Sofa", Predicate::Under, "DiningTable", 1, 1, {}}));
  EXPECT_FALSE(bodies.agree({"Boots", Predicate::Under, "Bed", 1, 1, {}}));
  EXPECT_FALSE(bodies.agree({"Mug", Predicate::NextTo, "Fridge", 1, 1, {}}));
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
