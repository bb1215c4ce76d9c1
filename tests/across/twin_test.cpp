#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/rng.h"
#include "simulation/feedback.h"
#include "simulation/relations.h"
#include "simulation/world.h"
#include "symbolic/perform.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

using symbolic::Id;
using symbolic::kNobody;
using symbolic::PlaceKind;

/// The kitchen's knowledge, in which everything movable fits everywhere: geometry is for the physical twin to say.
Knowledge roomy(Simulator simulator) {
  const auto bare = testing::kitchen_knowledge(simulator);
  std::vector<Placement> placements;
  for (const auto& object : bare.categories()) {
    for (const auto& place : bare.categories()) {
      if (!object.movable || &object == &place) continue;
      for (const Predicate relation : {Predicate::On, Predicate::Inside})
        placements.push_back({object.name, relation, place.name, 0.1, 1000, object.source});
    }
  }
  return {simulator, bare.categories(), bare.affordances(), placements, bare.effects(), {}};
}

std::vector<std::string> names(const Knowledge& knowledge) {
  std::vector<std::string> found;
  for (const auto& category : knowledge.categories()) found.push_back(category.name);
  return found;
}

/// A physical scene as symbols. Things are numbered as the scene's nodes.
struct Twin {
  symbolic::Rules rules;
  symbolic::Setting setting;
  symbolic::World world;
  std::size_t things = 0;  // without the pieces that they could be cut into

  Twin(const Scene& scene, const Knowledge& knowledge, const Profile& profile)
      : rules(knowledge, offer_as(profile), names(knowledge)) {
    rules.symbol_number("wine");
    setting.rules = &rules;
    for (const auto& room : scene.rooms) setting.objects.rooms.push_back({room.id, room.type});
    for (const auto& node : scene.nodes) {
      symbolic::ObjectEntry role;
      role.id = node.id;
      role.kind = rules.kind_named(node.category).value();
      setting.objects.things.push_back(role);
      world.things.push_back(thing_of(scene, node));
      const bool seat = node.states.has(Predicate::SatOn) || node.states.has(Predicate::LainOn);
      if (seat) world.seat = Id::thing(world.things.size() - 1);
    }
    for (const auto& id : scene.agent.held) world.held = number(scene, id);
    world.room = Id::room(0);
    things = world.things.size();
    symbolic::add_pieces(setting, world);
  }

  static symbolic::Capabilities offer_as(const Profile& profile) {
    return {profile.actions, profile.power_needs_closed, profile.open_needs_power_off, profile.power_needs_plug,
            profile.attaching};
  }

  static Id number(const Scene& scene, std::string_view id) {
    return Id::thing(NodeIndex(scene.nodes).find(id).value());
  }

  symbolic::Thing thing_of(const Scene& scene, const Node& node) {
    symbolic::Thing thing;
    thing.at = Id::room(0);
    for (const auto& state : node.states.all()) {
      if (state.predicate == Predicate::Covered) {
        thing.coats.insert(rules.symbol_number(state.symbol));
        continue;
      }
      thing.set(state.predicate);
      if (state.predicate == Predicate::Filled) thing.filling = rules.symbol_number(state.symbol);
    }
    const auto& held = scene.agent.held;
    if (std::find(held.begin(), held.end(), node.id) != held.end()) {
      thing.where = PlaceKind::Hand;
      thing.at = kNobody;
    }
    std::size_t deepest = 0;
    for (const auto& edge : scene.edges) {
      if (edge.from != node.id || thing.where == PlaceKind::Hand || thing.where == PlaceKind::On) continue;
      if (edge.relation == Predicate::On) {
        thing.where = PlaceKind::On;
        thing.at = number(scene, edge.to);
      } else if (edge.relation == Predicate::Inside && depth(scene, edge.to) >= deepest) {
        deepest = depth(scene, edge.to);
        thing.where = PlaceKind::Inside;
        thing.at = number(scene, edge.to);
      }
    }
    return thing;
  }

  static std::size_t depth(const Scene& scene, const std::string& id) {
    return static_cast<std::size_t>(std::count_if(scene.edges.begin(), scene.edges.end(), [&](const Edge& edge) {
      return edge.relation == Predicate::Inside && edge.from == id;
    }));
  }
};

/// Failures that have nothing to do with geometry: both twins give the same.
bool is_symbolic(Failure failure) {
  using enum Failure;
  const std::set<Failure> kOfSymbols = {
      NotOffered,    InsideClosed,  ReceptacleClosed, NotPickupable, NotOpenable,      AlreadyOpen,      AlreadyClosed,
      NotSwitchable, AlreadyOn,     AlreadyOff,       MustBeClosed,  NotHolding,       HandsFull,        NotSliceable,
      NoKnife,       NoEffect,      VesselEmpty,      NotFillable,   AlreadyFull,      NotConsumable,    NotReady,
      NotASeat,      Seated,        NotSeated,        NotPluggable,  AlreadyPluggedIn, AlreadyUnplugged, NotPluggedIn,
      NotFoldable,   AlreadyFolded, NotBreakable,     AlreadyBroken};
  return kOfSymbols.count(failure) > 0;
}

/// Any action, mostly one that the symbols allow.
ActionType draw_action(const Twin& twin, Id target, Rng& rng) {
  std::vector<ActionType> all, possible;
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const auto& action : list) {
      if (action.type <= ActionType::TurnTo || action.type == ActionType::Stop) continue;
      if (is_extension(action.type) && !twin.rules.capabilities().has(action.type)) continue;
      const bool alone = action.argument == ActionArgument::None;
      auto trial = twin.world;
      all.push_back(action.type);
      if (perform(twin.setting, trial, {action.type, alone ? kNobody : target}) == Failure::None)
        possible.push_back(action.type);
    }
  }
  return possible.empty() || rng.chance(0.4) ? rng.pick(all) : rng.pick(possible);
}

/// What both twins have of one moment: the states of the things, and what is in the hand.
struct Seen {
  std::vector<std::uint64_t> states;
  std::vector<symbolic::SubstanceSet> coats;
  std::vector<symbolic::SubstanceId> fillings;
  Id held = kNobody;
  bool operator==(const Seen&) const = default;
};

/// Moments that an action leads through; of those alike and one after another only the first.
class Moments {
 public:
  explicit Moments(std::size_t things) : things_(things) {}
  void add(const symbolic::World& world) {
    Seen seen;
    for (std::size_t k = 0; k < things_; ++k) {
      seen.states.push_back(world.things[k].states);
      seen.coats.push_back(world.things[k].coats);
      seen.fillings.push_back(world.things[k].filling);
    }
    seen.held = world.held;
    if (all_.empty() || all_.back() != seen) all_.push_back(std::move(seen));
  }
  const std::vector<Seen>& all() const { return all_; }

 private:
  std::size_t things_;
  std::vector<Seen> all_;
};

/// What an action needs and changes is written twice, with and without geometry; this holds one against the other: the
/// states of all things and what is in the hand agree after every action that physics lets happen, and at every moment
/// that a composite one leads through.
TEST(Twins, PhysicsAndSymbolsAgreeOnWhatActionsNeedAndDo) {
  std::size_t done = 0, refused = 0, composite = 0, most_moments = 0;
  std::set<ActionType> succeeded;
  const std::vector<std::pair<Simulator, ActionProfile>> kinds = {{Simulator::Ai2thor, ActionProfile::Unietp},
                                                                  {Simulator::Behavior, ActionProfile::Unietp},
                                                                  {Simulator::Ai2thor, ActionProfile::Wide},
                                                                  {Simulator::Virtualhome, ActionProfile::Wide},
                                                                  {Simulator::Behavior, ActionProfile::Wide}};
  for (const auto& [simulator, actions] : kinds) {
    const auto knowledge = roomy(simulator);
    const auto profile = testing::kitchen_profile(simulator, actions);
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
      Rng rng = Rng(seed).fork(name_of(actions), static_cast<std::uint64_t>(simulator));
      auto made = World::create(testing::wide_kitchen(simulator), knowledge, profile);
      ASSERT_TRUE(made) << format(made.error());
      auto& world = *made;
      for (int i = 0; i < 60; ++i) {
        const auto target = rng.pick(world.scene().nodes).id;
        world.step({ActionType::GoTo, {target}});
        Twin before(world.scene(), knowledge, profile);
        const Id id = Twin::number(world.scene(), target);
        if (before.world.held != id) before.world.by = root_of(before.world, id);
        const auto action = draw_action(before, id, rng);
        const bool alone = info(action).argument == ActionArgument::None;
        const auto outcome =
            world.step({action, alone ? std::vector<std::string>{} : std::vector<std::string>{target}});
        if (!outcome.success && !is_symbolic(outcome.failure)) continue;
        const std::size_t things = before.things;
        Moments in_symbols(things), in_physics(things);
        in_symbols.add(before.world);
        in_physics.add(before.world);
        std::vector<symbolic::World> passed;
        const auto failure = perform(before.setting, before.world, {action, alone ? kNobody : id}, &passed);
        SCOPED_TRACE(std::string(info(action).name) + "(" + target + ") " + feedback_with_ids(outcome.detail));
        if (!outcome.success) {
          EXPECT_EQ(name_of(failure), name_of(outcome.failure));
          ++refused;
          continue;
        }
        ASSERT_EQ(name_of(failure), name_of(Failure::None));
        Twin after(world.scene(), knowledge, profile);
        for (std::size_t k = 0; k < before.setting.objects.things.size(); ++k) {
          if (k >= after.world.things.size() || before.setting.objects.things[k].whole != kNobody) continue;
          const auto& symbols = before.world.things[k];
          const auto& physics = after.world.things[k];
          ASSERT_EQ(symbols.states, physics.states) << before.setting.objects.things[k].id;
          ASSERT_EQ(symbols.coats, physics.coats) << before.setting.objects.things[k].id;
          ASSERT_EQ(symbols.filling, physics.filling) << before.setting.objects.things[k].id;
        }
        ASSERT_EQ(before.world.held, after.world.held);
        for (const symbolic::World& between : passed) in_symbols.add(between);
        in_symbols.add(before.world);
        for (const PassedMoment& one : world.passed())
          in_physics.add(Twin(world.at(one.moment).scene(), knowledge, profile).world);
        if (!world.passed().empty()) {
          ASSERT_TRUE(in_symbols.all() == in_physics.all());
          most_moments = std::max(most_moments, in_physics.all().size());
          ++composite;
        }
        succeeded.insert(action);
        ++done;
      }
    }
  }
  EXPECT_GT(done, 150U);
  EXPECT_GT(refused, 150U);
  EXPECT_GE(composite, 10U);
  EXPECT_GE(most_moments, 8U) << "opened, put in, closed, switched on, off, opened, taken, closed";
  EXPECT_GE(succeeded.size(), 14U) << "too few kinds of action came about";
  for (const ActionInfo& action : extension_actions()) EXPECT_EQ(succeeded.count(action.type), 1U) << action.name;
}

}  // namespace
}  // namespace unietp
