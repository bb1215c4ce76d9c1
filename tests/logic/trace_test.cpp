#include "logic/trace.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/rng.h"

namespace unietp {
namespace {

constexpr std::size_t kEntities = 300;
constexpr Predicate kStates[] = {Predicate::Open, Predicate::Dirty, Predicate::Held};

/// The same truths, kept the plain way.
struct Plain {
  std::set<EntityIndex> existing;
  std::map<Predicate, std::set<EntityIndex>> states;
  std::set<std::pair<EntityIndex, EntityIndex>> on;
};

void change(Facts& facts, Plain& plain, Rng& rng) {
  const auto one = EntityIndex(rng.below(kEntities)), other = EntityIndex(rng.below(kEntities));
  const Predicate state = kStates[rng.below(std::size(kStates))];
  switch (rng.below(7)) {
    case 0:
      facts.set_exists(one), plain.existing.insert(one);
      break;
    case 1:
      facts.set(state, one), plain.states[state].insert(one);
      break;
    case 2:
      facts.set(Predicate::On, one, other), plain.on.emplace(one, other);
      break;
    case 3:
      facts.clear(state, one), plain.states[state].erase(one);
      break;
    case 4:
      facts.clear(Predicate::On, one, other), plain.on.erase({one, other});
      break;
    case 5:
      facts.clear_states(one);
      for (auto& [predicate, entities] : plain.states) entities.erase(one);
      break;
    default:
      facts.forget(one), plain.existing.erase(one);
      for (auto& [predicate, entities] : plain.states) entities.erase(one);
      std::erase_if(plain.on, [&](const auto& pair) { return pair.first == one; });
  }
}

void expect_same(const Facts& facts, const Plain& plain) {
  for (const Predicate state : kStates) {
    std::vector<EntityIndex> with;
    for (EntityIndex entity; entity.index() < kEntities; ++entity) {
      const bool holds =
          plain.existing.contains(entity) && plain.states.contains(state) && plain.states.at(state).contains(entity);
      EXPECT_EQ(facts.holds(state, entity), holds) << entity.index();
      if (holds) with.push_back(entity);
    }
    EXPECT_EQ(facts.with(state), with);
  }
  for (EntityIndex entity; entity.index() < kEntities; ++entity) {
    std::vector<std::pair<Predicate, EntityIndex>> relations;
    for (const auto& [first, second] : plain.on) {
      if (first == entity && plain.existing.contains(first) && plain.existing.contains(second))
        relations.emplace_back(Predicate::On, second);
    }
    EXPECT_EQ(facts.relations(entity), relations) << entity.index();
  }
}

TEST(StateFacts, AreWhatWasSetAndCopiesStayWhatTheyWereForAnySeed) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Facts facts;
    Plain plain;
    for (EntityIndex entity; entity.index() < kEntities; entity = EntityIndex(entity.index() + 1 + rng.below(3))) {
      facts.set_exists(entity), plain.existing.insert(entity);
    }
    std::vector<std::pair<Facts, Plain>> copies;
    for (int copy = 0; copy < 6; ++copy) {
      for (int i = 0; i < 40 * copy * copy; ++i) change(facts, plain, rng);
      copies.emplace_back(facts, plain);
    }
    for (const auto& [before, expected] : copies) expect_same(before, expected);
  }
}

}  // namespace
}  // namespace unietp
