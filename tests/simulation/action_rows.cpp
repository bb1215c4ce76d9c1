#include "tests/simulation/action_rows.h"

#include <cmath>
#include <numbers>

#include "scene/fresh_id.h"
#include "tests/simulation/kitchen.h"

namespace unietp::testing {
namespace {

using enum ActionType;
using F = Failure;
using Alter = std::function<void(Scene&)>;
using Outcome = std::function<bool(const Scene&)>;

Action go(const char* id) { return {GoTo, {id}}; }
/// The hand holds `id`, and the agent stands by `at`.
std::vector<Action> with(const char* id, const char* at) { return {go(id), {PickUp, {id}}, go(at)}; }

Node& node(Scene& scene, const std::string& id) { return *edit_node(scene, id); }

Node& block(Scene& scene, const Vec3& center, const Vec3& size, double yaw = 0) {
  Node& added = add(scene, fresh_id(scene, "CounterTop"), kitchen_knowledge(scene.simulator), "CounterTop", 0, 0, 0);
  added.pose = upright(center, yaw);
  added.size = size;
  return added;
}

Vec3 ahead(const Scene& scene, double along, double height) {
  const Agent& agent = scene.agent;
  return {agent.position.x() + along * std::cos(agent.yaw), agent.position.y() + along * std::sin(agent.yaw), height};
}

/// The agent stands in the corner of the room that is farthest from the object.
Alter far_from(const std::string& id) {
  return [id](Scene& scene) {
    const Vec2 at = node(scene, id).pose.position.head<2>();
    scene.agent.position = {at.x() < 2.5 ? 4.6 : 0.4, at.y() < 2 ? 2.8 : 0.3};
  };
}

/// A board between the camera and the object.
Alter screened(const std::string& id) {
  return [id](Scene& scene) {
    const Vec3 to = node(scene, id).pose.position;
    const Vec2 from = scene.agent.position, way = to.head<2>() - from;
    const Vec2 middle = from + way.normalized() * 0.12;
    block(scene, {middle.x(), middle.y(), 1.25}, {3, 0.02, 2.5}, std::atan2(way.y(), way.x()) + std::numbers::pi / 2);
  };
}

/// A closed cabinet around the object.
Alter shut_in(const std::string& id) {
  return [id](Scene& scene) {
    Node& inner = node(scene, id);
    if (inner.pose.position.z() - inner.size.z() / 2 < 0.01) inner.pose.position.z() += 0.02;  // not on the floor
    const Pose pose = inner.pose;
    const Vec3 size = inner.size + Vec3::Constant(0.3);
    Node& around = add(scene, "cabinet_1", kitchen_knowledge(scene.simulator), "Fridge", 0, 0, 0);
    around.pose = pose;
    around.size = size;
  };
}

Alter state(const std::string& id, Predicate predicate, const std::string& symbol = "") {
  return [=](Scene& scene) { node(scene, id).states.set({predicate, symbol}); };
}

Outcome is(const std::string& id, Predicate predicate, const std::string& symbol = "") {
  return [=](const Scene& scene) { return find_node(scene, id)->states.has(State{predicate, symbol}); };
}
Outcome edge(Predicate relation, const std::string& from, const std::string& to) {
  return [=](const Scene& scene) { return has_edge(scene, relation, from, to); };
}
Outcome holds(const std::string& id) {
  return [=](const Scene& scene) { return scene.agent.held == std::vector<std::string>{id}; };
}
/// What is held is as asked, and still held.
Outcome treated(const std::string& id, Predicate predicate, const std::string& symbol = "") {
  return [=](const Scene& scene) { return holds(id)(scene) && is(id, predicate, symbol)(scene); };
}

/// Puts the agent, with what it holds, on free floor.
void stand(Scene& scene, double yaw) {
  scene.agent.position = {1.3, 2.4};
  scene.agent.yaw = yaw;
  for (const std::string& id : scene.agent.held) node(scene, id).pose = upright(ahead(scene, 0.45, 1.0), yaw);
}

/// Boxes on all four sides of the body.
void box_in(Scene& scene) {
  const Vec2 at = scene.agent.position;
  for (const Vec2& side : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
    const Vec2 center = at + 0.5 * side;
    block(scene, {center.x(), center.y(), 0.5}, {0.3 + std::abs(side.y()), 0.3 + std::abs(side.x()), 1});
  }
}
/// Something solid where the hand is.
void fill_hand_space(Scene& scene) { block(scene, ahead(scene, 0.45, 1.0), {1.4, 1.4, 0.3}); }
void fill_sink(Scene& scene) { block(scene, node(scene, "sink_1").pose.position + Vec3(0, 0, 0.3), {0.5, 0.4, 0.2}); }
void roof_over_plate(Scene& scene) {
  block(scene, node(scene, "plate_1").pose.position + Vec3(0, 0, 0.04), {0.16, 0.16, 0.03});
}
void tilt(Scene& scene, const std::string& id, double angle) {
  Pose& pose = node(scene, id).pose;
  pose.rotation = pose.rotation * Quat(Eigen::AngleAxisd(angle, Vec3::UnitX()));
  pose.position.z() += 0.25;
}

class Table {
 public:
  std::vector<ActionRow> rows;

  void good(ActionType action, const char* target, std::vector<Action> before, Outcome effect, Alter alter = nullptr) {
    rows.push_back({action, F::None, target, std::move(before), std::move(alter), std::move(effect)});
  }
  void bad(ActionType action, F failure, const char* target, std::vector<Action> before, Alter alter = nullptr) {
    rows.push_back({action, failure, target, std::move(before), std::move(alter), nullptr});
  }
  /// What every action by hand on an object needs: not shut in, in reach, in sight.
  void by_hand(ActionType action, const char* target, const std::vector<Action>& before, const Alter& first = nullptr) {
    for (const auto& [failure, alter] : {std::pair<F, Alter>{F::InsideClosed, shut_in(target)},
                                         {F::TooFar, far_from(target)},
                                         {F::NotVisible, screened(target)}}) {
      bad(action, failure, target, before, [first, alter = alter](Scene& scene) {
        if (first) first(scene);
        alter(scene);
      });
    }
  }
};

void moving(Table& t) {
  // Each way along +x, where the floor is free for a step of a meter.
  for (const auto& [move, yaw] :
       {std::pair{MoveForward, 0.0}, std::pair{MoveBackward, std::numbers::pi},
        std::pair{MoveLeft, -std::numbers::pi / 2}, std::pair{MoveRight, std::numbers::pi / 2}}) {
    const Alter free = [yaw = yaw](Scene& scene) { stand(scene, yaw); };
    t.good(move, "", {}, nullptr, free);
    t.bad(move, F::Blocked, "", {}, [free](Scene& scene) {
      free(scene);
      box_in(scene);
    });
    t.bad(move, F::Seated, "", {}, state("sofa_1", Predicate::SatOn));
  }
  for (const ActionType turn : {TurnLeft, TurnRight}) {
    t.good(turn, "", {}, nullptr);
    t.bad(turn, F::Seated, "", {}, state("sofa_1", Predicate::LainOn));
  }
  const auto pitch = [](double degrees) {
    return [degrees](Scene& scene) { scene.agent.pitch = degrees * std::numbers::pi / 180; };
  };
  t.good(LookUp, "", {}, nullptr, pitch(10));
  t.bad(LookUp, F::Blocked, "", {}, pitch(-89));
  t.good(LookDown, "", {}, nullptr, pitch(-10));
  t.bad(LookDown, F::Blocked, "", {}, pitch(89));
  t.good(TurnBaseToLook, "", {}, [](const Scene&) { return true; });
  t.good(
      ResetHead, "", {}, [](const Scene& scene) { return scene.agent.pitch == 0; }, pitch(20));
  for (const ActionType move : {MoveHandForward, MoveHandBackward, MoveHandLeft, MoveHandRight, RotateHand}) {
    t.good(move, "", with("mug_1", "kitchen_1"), nullptr);
    t.bad(move, F::NotHolding, "", {});
    t.bad(move, F::Blocked, "", with("mug_1", "kitchen_1"), fill_hand_space);
  }
  t.good(GoTo, "fridge_1", {}, nullptr);
  t.bad(GoTo, F::NoStandingPlace, "fridge_1", {}, box_in);
  t.bad(GoTo, F::Seated, "fridge_1", {}, state("sofa_1", Predicate::SatOn));
  t.good(TurnTo, "mug_1", {go("mug_1"), {TurnLeft, {}}}, nullptr);
  t.bad(TurnTo, F::NotVisible, "mug_1", {go("mug_1")}, screened("mug_1"));
  t.good(Stop, "", {}, [](const Scene&) { return true; });
}

void taking_and_placing(Table& t) {
  t.good(PickUp, "mug_1", {go("mug_1")}, holds("mug_1"));
  t.bad(PickUp, F::NotPickupable, "diningtable_1", {go("diningtable_1")});
  t.bad(PickUp, F::Seated, "plate_1", {go("plate_1")}, state("plate_1", Predicate::SatOn));
  t.bad(PickUp, F::HandsFull, "mug_1", with("potato_1", "mug_1"));
  t.by_hand(PickUp, "mug_1", {go("mug_1")});
  t.bad(PickUp, F::TooHeavy, "mug_1", {go("mug_1")}, [](Scene& scene) { node(scene, "mug_1").mass = 1000; });

  t.good(PlaceOn, "plate_1", with("potato_1", "plate_1"), edge(Predicate::On, "potato_1", "plate_1"));
  t.bad(PlaceOn, F::NotHolding, "plate_1", {go("plate_1")});
  t.by_hand(PlaceOn, "plate_1", with("potato_1", "plate_1"));
  t.bad(PlaceOn, F::NotAReceptacle, "apple_1", with("potato_1", "apple_1"));
  t.bad(PlaceOn, F::DoesNotFit, "knife_1", with("plate_1", "knife_1"));
  t.bad(PlaceOn, F::NoFreePlace, "plate_1", with("potato_1", "plate_1"), roof_over_plate);
  t.bad(PlaceOn, F::DidNotRest, "plate_1", with("apple_1", "plate_1"),
        [](Scene& scene) { tilt(scene, "plate_1", 0.9); });

  t.good(PlaceIn, "sink_1", with("mug_1", "sink_1"), edge(Predicate::Inside, "mug_1", "sink_1"));
  t.bad(PlaceIn, F::NotHolding, "sink_1", {go("sink_1")});
  t.by_hand(PlaceIn, "sink_1", with("mug_1", "sink_1"));
  t.bad(PlaceIn, F::ReceptacleClosed, "fridge_1", with("mug_1", "fridge_1"));
  t.bad(PlaceIn, F::NotAReceptacle, "diningtable_1", with("mug_1", "diningtable_1"));
  t.bad(PlaceIn, F::DoesNotFit, "mug_1", with("plate_1", "mug_1"));
  t.bad(PlaceIn, F::NoFreePlace, "sink_1", with("mug_1", "sink_1"), fill_sink);
  t.bad(PlaceIn, F::DidNotRest, "sink_1", with("apple_1", "sink_1"), [](Scene& scene) { tilt(scene, "sink_1", 2.2); });

  t.good(
      Drop, "", with("mug_1", "kitchen_1"), [](const Scene& scene) { return scene.agent.held.empty(); },
      [](Scene& scene) { stand(scene, 0); });
  t.bad(Drop, F::NotHolding, "", {});
  t.bad(Drop, F::Blocked, "", with("mug_1", "kitchen_1"), fill_hand_space);
  t.bad(Drop, F::DidNotRest, "", with("mug_1", "kitchen_1"), [](Scene& scene) {  // beyond the wall
    node(scene, "mug_1").pose.position = {-0.3, 2.4, 1};
  });
}

void doors_and_power(Table& t) {
  const auto before_door = [](double along) {
    return [along](Scene& scene) {
      block(scene, node(scene, "microwave_1").pose.position + Vec3(along, -0.4, 0), {0.04, 0.04, 0.04});
    };
  };
  const std::vector<Action> opened{go("microwave_1"), {Open, {"microwave_1"}}};
  t.good(Open, "microwave_1", {go("microwave_1")}, is("microwave_1", Predicate::Open));
  t.bad(Open, F::NotOpenable, "mug_1", {go("mug_1")});
  t.by_hand(Open, "microwave_1", {go("microwave_1")});
  t.bad(Open, F::AlreadyOpen, "microwave_1", opened);
  t.bad(Open, F::AlreadyOn, "microwave_1", {go("microwave_1")}, state("microwave_1", Predicate::PowerOn));
  t.bad(Open, F::Blocked, "microwave_1", {go("microwave_1")}, before_door(-0.1));

  t.good(Close, "microwave_1", opened, is("microwave_1", Predicate::Closed));
  t.bad(Close, F::NotOpenable, "mug_1", {go("mug_1")});
  t.by_hand(Close, "microwave_1", opened);
  t.bad(Close, F::AlreadyClosed, "microwave_1", {go("microwave_1")});
  t.bad(Close, F::Blocked, "microwave_1", opened, before_door(-0.1));

  t.good(TurnOn, "microwave_1", {go("microwave_1")}, is("microwave_1", Predicate::PowerOn));
  t.bad(TurnOn, F::NotSwitchable, "mug_1", {go("mug_1")});
  t.by_hand(TurnOn, "microwave_1", {go("microwave_1")});
  t.bad(TurnOn, F::AlreadyOn, "microwave_1", {go("microwave_1")}, state("microwave_1", Predicate::PowerOn));
  t.bad(TurnOn, F::MustBeClosed, "microwave_1", opened);
  t.bad(TurnOn, F::NotPluggedIn, "lamp_1", {go("lamp_1")});

  t.good(TurnOff, "lamp_1", {go("lamp_1")}, is("lamp_1", Predicate::PowerOff), state("lamp_1", Predicate::PowerOn));
  t.bad(TurnOff, F::NotSwitchable, "mug_1", {go("mug_1")});
  t.by_hand(TurnOff, "lamp_1", {go("lamp_1")});
  t.bad(TurnOff, F::AlreadyOff, "lamp_1", {go("lamp_1")});
}

void contents(Table& t) {
  const auto knife = with("knife_1", "apple_1");
  t.good(Slice, "apple_1", knife, is("apple_1", Predicate::Sliced));
  t.bad(Slice, F::NotSliceable, "plate_1", with("knife_1", "plate_1"));
  t.bad(Slice, F::NoKnife, "apple_1", {go("apple_1")});
  t.by_hand(Slice, "apple_1", knife);

  const auto wine = with("winebottle_1", "mug_1");
  t.good(PourTo, "mug_1", wine, is("mug_1", Predicate::Filled, "wine"));
  t.bad(PourTo, F::NotHolding, "mug_1", {go("mug_1")});
  t.bad(PourTo, F::VesselEmpty, "sink_1", with("mug_1", "sink_1"));
  t.by_hand(PourTo, "mug_1", wine);
  t.bad(PourTo, F::NotFillable, "plate_1", with("winebottle_1", "plate_1"));
  t.bad(PourTo, F::AlreadyFull, "mug_1", wine, state("mug_1", Predicate::Filled, "water"));

  t.good(UseUp, "soapbar_1", {go("soapbar_1")}, is("soapbar_1", Predicate::UsedUp));
  t.bad(UseUp, F::NotConsumable, "mug_1", {go("mug_1")});
  t.by_hand(UseUp, "soapbar_1", {go("soapbar_1")});

  const auto towel = with("towel_1", "plate_1");
  t.good(
      Wipe, "plate_1", towel,
      [](const Scene& scene) { return !find_node(scene, "plate_1")->states.has(Predicate::Covered); },
      state("plate_1", Predicate::Covered, "dust"));
  t.bad(Wipe, F::NotHolding, "plate_1", {go("plate_1")});
  t.bad(Wipe, F::NoEffect, "mug_1", with("towel_1", "mug_1"));
  t.by_hand(Wipe, "plate_1", towel);
  t.bad(Wipe, F::NotReady, "plate_1", towel, state("plate_1", Predicate::Dirty));

  const auto ketchup = with("ketchup_1", "plate_1");
  t.good(SpreadTo, "plate_1", ketchup, is("plate_1", Predicate::Covered, "ketchup"));
  t.bad(SpreadTo, F::NotHolding, "plate_1", {go("plate_1")});
  t.bad(SpreadTo, F::NoEffect, "mug_1", with("ketchup_1", "mug_1"));
  t.by_hand(SpreadTo, "plate_1", ketchup);
}

void treatments(Table& t) {
  const auto fill = [](const std::string& id) {
    return [id](Scene& scene) {
      const Node& tool = node(scene, id);
      const Vec3 low = tool.archetype == Archetype::Block ? Vec3(0, 0, tool.size.z() / 2 + 0.035) : Vec3(0, 0.03, 0);
      const Vec3 size = tool.archetype == Archetype::Block ? Vec3(tool.size.x(), tool.size.y(), 0.03)
                                                           : Vec3(tool.size - Vec3(0.06, 0.14, 0.06));
      block(scene, tool.pose.position + low, size);
    };
  };
  const auto treat = [&](ActionType action, const char* item, const char* tool, const char* useless, Outcome effect,
                         Alter alter = nullptr) {
    t.good(action, tool, with(item, tool), std::move(effect), std::move(alter));
    t.bad(action, F::NotHolding, tool, {go(tool)});
    t.bad(action, F::NoEffect, useless, with(item, useless));
    t.by_hand(action, tool, with(item, tool));
    t.bad(action, F::NoFreePlace, tool, with(item, tool),
          std::string(tool) == "sink_1" ? Alter(fill_sink) : fill(tool));
  };
  treat(SoakWith, "towel_1", "sink_1", "microwave_1", treated("towel_1", Predicate::Soaked));
  treat(HeatWith, "potato_1", "microwave_1", "sink_1", treated("potato_1", Predicate::Hot));
  treat(CoolWith, "mug_1", "fridge_1", "microwave_1", treated("mug_1", Predicate::Cool));
  treat(WashWith, "mug_1", "sink_1", "microwave_1", treated("mug_1", Predicate::Clean),
        state("mug_1", Predicate::Dirty));
  treat(CookWith, "potato_1", "microwave_1", "sink_1", treated("potato_1", Predicate::Cooked));
  treat(BurnWith, "potato_1", "stove_1", "microwave_1", treated("potato_1", Predicate::Burnt));
  treat(FillWith, "mug_1", "sink_1", "microwave_1", treated("mug_1", Predicate::Filled, "water"));
}

void extension(Table& t) {
  const std::vector<Action> at_sofa{go("sofa_1")}, at_lamp{go("lamp_1")}, at_towel{go("towel_1")}, at_mug{go("mug_1")};
  for (const auto& [action, state_of_seat] :
       {std::pair{SitOn, Predicate::SatOn}, std::pair{LieOn, Predicate::LainOn}}) {
    t.good(action, "sofa_1", at_sofa, is("sofa_1", state_of_seat));
    t.bad(action, F::NotASeat, "mug_1", at_mug);
    t.bad(action, F::Seated, "sofa_1", at_sofa, state("sofa_1", Predicate::SatOn));
    t.by_hand(action, "sofa_1", at_sofa);
    t.bad(action, F::NoFreePlace, "sofa_1", at_sofa, [](Scene& scene) {
      Node& pile = add(scene, "towel_9", kitchen_knowledge(scene.simulator), "Towel", 4.2, 1.2, 0.402);
      pile.size = {0.5, 1.5, 0.1};
    });
  }
  t.good(
      StandUp, "", {}, [](const Scene& scene) { return !find_node(scene, "sofa_1")->states.has(Predicate::SatOn); },
      state("sofa_1", Predicate::SatOn));
  t.bad(StandUp, F::NotSeated, "", {});

  t.good(PlugIn, "lamp_1", at_lamp, is("lamp_1", Predicate::PluggedIn));
  t.bad(PlugIn, F::NotPluggable, "mug_1", at_mug);
  t.by_hand(PlugIn, "lamp_1", at_lamp);
  t.bad(PlugIn, F::AlreadyPluggedIn, "lamp_1", at_lamp, state("lamp_1", Predicate::PluggedIn));
  t.good(Unplug, "lamp_1", at_lamp, is("lamp_1", Predicate::Unplugged), state("lamp_1", Predicate::PluggedIn));
  t.bad(Unplug, F::NotPluggable, "mug_1", at_mug);
  t.by_hand(Unplug, "lamp_1", at_lamp);
  t.bad(Unplug, F::AlreadyUnplugged, "lamp_1", at_lamp);

  t.good(Fold, "towel_1", at_towel, is("towel_1", Predicate::Folded));
  t.bad(Fold, F::NotFoldable, "mug_1", at_mug);
  t.bad(Fold, F::AlreadyFolded, "towel_1", at_towel, state("towel_1", Predicate::Folded));
  t.bad(Fold, F::HandsFull, "towel_1", with("potato_1", "towel_1"));
  t.by_hand(Fold, "towel_1", at_towel);
  t.bad(Fold, F::Blocked, "towel_1", at_towel, [](Scene& scene) {
    node(scene, "bulb_1").pose.position = node(scene, "towel_1").pose.position + Vec3(0, 0, 0.046);
  });

  const auto folded = state("towel_1", Predicate::Folded);
  t.good(Unfold, "towel_1", at_towel, is("towel_1", Predicate::Unfolded), folded);
  t.bad(Unfold, F::NotFoldable, "mug_1", at_mug);
  t.bad(Unfold, F::AlreadyUnfolded, "towel_1", at_towel);
  t.bad(Unfold, F::HandsFull, "towel_1", with("potato_1", "towel_1"), folded);
  t.by_hand(Unfold, "towel_1", at_towel, folded);
  t.bad(Unfold, F::Blocked, "towel_1", at_towel, [folded](Scene& scene) {
    folded(scene);
    node(scene, "bulb_1").pose.position = node(scene, "towel_1").pose.position + Vec3(0, 0, 0.046);
  });

  t.good(Break, "mug_1", at_mug, is("mug_1", Predicate::Broken));
  t.bad(Break, F::NotBreakable, "plate_1", {go("plate_1")});
  t.bad(Break, F::AlreadyBroken, "mug_1", at_mug, state("mug_1", Predicate::Broken));
  t.by_hand(Break, "mug_1", at_mug);

  t.good(Read, "apple_1", {go("apple_1"), {PickUp, {"apple_1"}}}, treated("apple_1", Predicate::Read));
  t.bad(Read, F::NotReadable, "mug_1", {go("mug_1"), {PickUp, {"mug_1"}}});
  t.bad(Read, F::NotHolding, "apple_1", {go("apple_1")});
}

}  // namespace

std::vector<ActionRow> action_rows() {
  Table table;
  moving(table);
  taking_and_placing(table);
  doors_and_power(table);
  contents(table);
  treatments(table);
  extension(table);
  return table.rows;
}

}  // namespace unietp::testing
