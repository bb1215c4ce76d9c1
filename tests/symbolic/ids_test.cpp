#include "symbolic/id.h"

#include <gtest/gtest.h>

#include <concepts>
#include <set>
#include <utility>

#include "core/rng.h"
#include "logic/evaluate.h"
#include "logic/monitor.h"
#include "symbolic/goal.h"
#include "tests/support/committed_knowledge.h"

namespace unietp::symbolic {
namespace {

static_assert(!std::convertible_to<std::size_t, Id> && !std::convertible_to<Id, std::size_t>);
static_assert(!std::convertible_to<KindId, Id> && !std::convertible_to<SubstanceId, KindId>);
static_assert(!std::constructible_from<KindId, SubstanceId>);

TEST(Ids, ThingsAndRoomsAreNumberedApart) {
  for (const std::size_t position : {std::size_t{0}, std::size_t{4096}, std::size_t{40'000}}) {
    EXPECT_TRUE(Id::thing(position).is_thing());
    EXPECT_FALSE(Id::thing(position).is_room());
    EXPECT_TRUE(Id::room(position).is_room());
    EXPECT_EQ(Id::thing(position).index(), position);
    EXPECT_EQ(Id::room(position).index(), position);
  }
  for (const Id id : {kNobody, kAgent}) EXPECT_FALSE(id.is_thing() || id.is_room());
}

TEST(Ids, APositionPastTheLimitIsAnError) {
  EXPECT_THROW(Id::thing(std::size_t{1} << 31), std::length_error);
  EXPECT_THROW(Id::room(0x7FFF'FFFE), std::length_error);
  EXPECT_NO_THROW(Id::thing((std::size_t{1} << 31) - 1));
}

TEST(Substances, ASetOfThemIsASetOfAnySize) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    SubstanceSet set;
    std::set<SubstanceId> same;
    for (int i = 0; i < 200; ++i) {
      const SubstanceId one(rng.below(200));
      if (rng.chance(0.6)) {
        set.insert(one);
        same.insert(one);
      } else {
        set.erase(one);
        same.erase(one);
      }
      ASSERT_EQ(set.empty(), same.empty());
      ASSERT_EQ(set.has_other_than(one), same.size() > same.count(one));
      for (std::size_t s = 0; s < 200; ++s) ASSERT_EQ(set.contains(SubstanceId(s)), same.count(SubstanceId(s)) == 1);
    }
  }
}

/// A home with a number of empty mugs in it.
struct Mugs {
  Rules rules;
  Setting setting;
  World world;

  explicit Mugs(std::size_t count, Simulator simulator = Simulator::Ai2thor, const std::string& category = "Mug")
      : rules(committed_knowledge(simulator), capabilities_of(simulator), {category}) {
    setting.rules = &rules;
    setting.objects.rooms = {{"kitchen_1", "Kitchen"}, {"hall_1", "Hall"}};
    for (std::size_t i = 0; i < count; ++i) {
      ObjectEntry role;
      role.id = category + "_" + std::to_string(i);
      setting.objects.things.push_back(role);
      Thing thing;
      thing.at = Id::room(0);
      world.things.push_back(thing);
    }
    world.room = Id::room(1);
  }

  Formula goal(const std::string& text) const { return parse_formula("test", text, FormulaUse::Goal).value(); }
  bool holds_in_symbols(const std::string& text) const {
    const Goal written(goal(text), setting, world);
    return holds(written, written.root(), setting, world, Progress(written));
  }
  bool holds_in_logic(const std::string& text) const { return unietp::holds(goal(text), trace_of(setting, {world})); }
  bool holds_in_monitor(const std::string& text) const {
    const Trace trace = trace_of(setting, {world});
    Monitor monitor(goal(text));
    monitor.observe(trace.entities, trace.states[0]);
    return monitor.satisfied();
  }
};

TEST(ManyThings, TheLastOfFiveThousandIsAThingAndNoRoom) {
  Mugs home(5000);
  const Id last = Id::thing(4999), other = Id::thing(4096);
  home.world[last].where = PlaceKind::On;
  home.world[last].at = other;
  EXPECT_EQ(room_of(home.world, last), Id::room(0));
  EXPECT_TRUE(holds(home.setting, home.world, Predicate::On, last, other, kAnySymbol));
  const Trace trace = trace_of(home.setting, {home.world});  // entity i is thing i
  EXPECT_TRUE(trace.states[0].holds(Predicate::On, EntityIndex(4999), EntityIndex(4096)));
  for (const auto& [text, truth] :
       {std::pair("(at-end (count = 5000 (?x - Mug) (and)))", true),
        std::pair("(at-end (count = 4999 (?x - Mug) (exists (?r - Kitchen) (on_floor ?x ?r))))", true),
        std::pair("(at-end (exists (?r - Hall) (in_room agent ?r)))", true),
        std::pair("(at-end (exists (?x - Mug) (exists (?r - Hall) (in_room ?x ?r))))", false)}) {
    EXPECT_EQ(home.holds_in_symbols(text), truth) << text;
    EXPECT_EQ(home.holds_in_logic(text), truth) << text;
    EXPECT_EQ(home.holds_in_monitor(text), truth) << text;
  }
}

TEST(Counts, MeanTheSameInSymbolsAsInLogicForEachComparison) {
  const std::vector<std::string> comparisons{"=", ">=", "<=", ">", "<"};
  for (std::size_t dirty = 0; dirty <= 4; ++dirty) {
    for (std::size_t hot = 0; hot <= 4; ++hot) {
      Mugs home(4);
      for (std::size_t i = 0; i < dirty; ++i) home.world.things[i].set(Predicate::Dirty);
      for (std::size_t i = 0; i < hot; ++i) home.world.things[i].set(Predicate::Hot);
      for (const auto& sign : comparisons) {
        const auto expected = [&](std::size_t a, std::size_t b) {
          return sign == "=" ? a == b : sign == ">=" ? a >= b : sign == "<=" ? a <= b : sign == ">" ? a > b : a < b;
        };
        const auto expect = [&](const std::string& goal, bool truth) {
          EXPECT_EQ(home.holds_in_symbols(goal), truth) << goal << " of " << dirty << " and " << hot;
          EXPECT_EQ(home.holds_in_logic(goal), truth) << goal << " of " << dirty << " and " << hot;
          EXPECT_EQ(home.holds_in_monitor(goal), truth) << goal << " of " << dirty << " and " << hot;
        };
        for (std::size_t n = 0; n <= 5; ++n)
          expect("(at-end (count " + sign + " " + std::to_string(n) + " (?x - Mug) (dirty ?x)))", expected(dirty, n));
        expect("(at-end (count " + sign + " (number (?x - Mug) (dirty ?x)) (number (?y - Mug) (hot ?y))))",
               expected(dirty, hot));
      }
    }
  }
}

TEST(ManyThings, EachSubstanceOfBehaviorIsToldFromEachOther) {
  std::set<std::string> substances;
  for (const auto& row : committed_knowledge(Simulator::Behavior).effects()) {
    if ((row.treatment == Treatment::Fills || row.treatment == Treatment::Dispenses) && !row.gives.empty())
      substances.insert(row.gives);
  }
  ASSERT_GE(substances.size(), 45U);
  Mugs home(substances.size(), Simulator::Behavior, "mug");
  std::size_t i = 0;
  for (const auto& substance : substances) {
    const SubstanceId number = home.rules.symbol_number(substance);
    EXPECT_EQ(home.rules.symbol_named(substance), number);
    auto& thing = home.world.things[i++];
    thing.set(Predicate::Filled);
    thing.filling = number;
    thing.coats.insert(number);
  }
  EXPECT_EQ(home.rules.symbols().size(), substances.size());
  for (const auto& substance : substances) {
    const auto filled = "(at-end (count = 1 (?x - mug) (filled ?x " + substance + ")))";
    const auto covered = "(at-end (count = 1 (?x - mug) (covered ?x " + substance + ")))";
    for (const auto& text : {filled, covered}) {
      EXPECT_TRUE(home.holds_in_symbols(text)) << text;
      EXPECT_TRUE(home.holds_in_logic(text)) << text;
      EXPECT_TRUE(home.holds_in_monitor(text)) << text;
    }
  }
}

}  // namespace
}  // namespace unietp::symbolic
