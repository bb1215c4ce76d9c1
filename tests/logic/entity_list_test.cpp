#include "logic/entity_list.h"

#include <gtest/gtest.h>

#include "core/rng.h"
#include "logic/formula.h"
#include "logic/membership.h"

namespace unietp {
namespace {

Entity drawn_entity(std::size_t number, Rng& rng) {
  const std::vector<std::string> names{"Mug", "Apple", "AppleSliced", "kitchen"};
  Entity entity;
  entity.kind = rng.pick(std::vector{Entity::Kind::Object, Entity::Kind::Room, Entity::Kind::Agent});
  entity.category = rng.pick(names);
  entity.id = entity.category + "_" + std::to_string(number);
  if (rng.chance(0.3)) entity.slice_of = rng.pick(names);
  return entity;
}

std::vector<Domain> some_domains() {
  std::vector<Domain> domains(3);
  domains[0].kind = Domain::Kind::Object;
  domains[1].kind = Domain::Kind::Room;
  domains[2].kind = Domain::Kind::Agent;
  for (const bool slice : {false, true}) {
    Domain domain;
    domain.kind = Domain::Kind::Categories;
    domain.members = {{"Apple", slice}};
    domains.push_back(domain);
    domain.members = {{"Mug", slice}, {"Apple", true}, {"AppleSliced", false}};
    domains.push_back(domain);
  }
  return domains;
}

TEST(EntityList, SharedOrNotItHasTheSameEntitiesAndFindsTheSameOfEachDomain) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<Entity> plain;
    EntityList list;
    EntityList earlier;
    for (std::size_t i = 0; i < 30; ++i) {
      if (i == 10 || i == 20) {
        list.share();
        earlier = list;
      }
      plain.push_back(drawn_entity(i, rng));
      list.push_back(plain.back());
    }
    EXPECT_TRUE(std::equal(plain.begin(), plain.end(), list.begin(), list.end()));
    for (const Domain& domain : some_domains()) {
      std::vector<EntityIndex> expected;
      for (EntityIndex e; e.index() < plain.size(); ++e) {
        if (is_of(plain[e.index()], domain)) expected.push_back(e);
      }
      EXPECT_EQ(list.of(domain), expected);
    }
    EXPECT_EQ(earlier.size(), 20U);
    EXPECT_EQ(list.find_shared(plain[12].id), EntityIndex(12));
    EXPECT_EQ(list.find_shared(plain[25].id), std::nullopt);
    EXPECT_FALSE(earlier == list);
    earlier.follow(list);
    EXPECT_TRUE(earlier == list);
  }
}

}  // namespace
}  // namespace unietp
