#include "simulation/world.h"

#include <algorithm>
#include <limits>

#include "simulation/agent_moves.h"
#include "simulation/camera.h"
#include "simulation/relations.h"
#include "simulation/solids.h"
#include "simulation/view.h"
#include "simulation/world_state.h"

namespace unietp {

struct World::Impl {
  WorldState state;
};

namespace {

Outcome wrong_arguments(const ActionInfo& action) {
  const char* wants = action.argument == ActionArgument::None ? "no argument" : "one argument";
  return failed(Failure::InvalidArgument, std::string(action.name) + " takes " + wants + ".");
}

/// Actions of the body and the hand, which name no object.
Outcome perform_alone(WorldState& state, ActionType type) {
  switch (type) {
    case ActionType::MoveForward:
    case ActionType::MoveBackward:
    case ActionType::MoveLeft:
    case ActionType::MoveRight:
    case ActionType::TurnLeft:
    case ActionType::TurnRight:
    case ActionType::LookUp:
    case ActionType::LookDown:
      return move_body(state, type);
    case ActionType::TurnBaseToLook:
      return succeeded();  // this body's head does not turn on its own, so it looks where the base points already
    case ActionType::ResetHead:
      return reset_head(state);
    case ActionType::MoveHandForward:
      return move_hand(state, 1, 0);
    case ActionType::MoveHandBackward:
      return move_hand(state, -1, 0);
    case ActionType::MoveHandLeft:
      return move_hand(state, 0, 1);
    case ActionType::MoveHandRight:
      return move_hand(state, 0, -1);
    case ActionType::RotateHand:
      return rotate_hand(state);
    case ActionType::Drop:
      return drop(state);
    case ActionType::StandUp:
      return stand_up(state);
    default:
      return failed(Failure::InvalidAction, std::string(info(type).name) + " needs an object.");
  }
}

/// A freezer may be known to freeze a thing without being known to cool it.
Outcome cool_with(WorldState& state, std::size_t tool) {
  const Outcome cooled = treat_with(state, tool, "cools");
  return cooled.failure == Failure::NoEffect ? treat_with(state, tool, "freezes") : cooled;
}

Outcome perform(WorldState& state, const Action& action) {
  const ActionInfo& about = info(action.type);
  if (!state.profile->offers(action.type)) {
    return failed(Failure::NotOffered,
                  std::string(name_of(state.scene.simulator)) + " does not offer " + std::string(about.name) + ".");
  }
  if (action.args.size() != (about.argument == ActionArgument::None ? 0u : 1u)) return wrong_arguments(about);
  if (action.type == ActionType::Stop) {
    state.stopped = true;
    return succeeded();
  }
  if (about.group == ActionClass::Movement || action.type == ActionType::GoTo) {
    if (auto seated = keeps_seat(state, action.type)) return *seated;
  }
  if (action.type == ActionType::GoTo) return go_to(state, action.args.front());
  if (about.argument == ActionArgument::None) return perform_alone(state, action.type);
  const auto node = state.index_of(action.args.front());
  if (!node) return failed(Failure::InvalidArgument, "There is no object " + action.args.front() + ".");
  switch (action.type) {
    case ActionType::TurnTo:
      return turn_to(state, *node);
    case ActionType::PickUp:
      return pick_up(state, *node);
    case ActionType::PlaceOn:
      return place(state, *node, false);
    case ActionType::PlaceIn:
      return place(state, *node, true);
    case ActionType::Open:
      return swing(state, *node, true);
    case ActionType::Close:
      return swing(state, *node, false);
    case ActionType::TurnOn:
      return switch_power(state, *node, true);
    case ActionType::TurnOff:
      return switch_power(state, *node, false);
    case ActionType::Slice:
      return slice(state, *node);
    case ActionType::PourTo:
      return pour_to(state, *node);
    case ActionType::UseUp:
      return use_up(state, *node);
    case ActionType::Wipe:
      return wipe(state, *node);
    case ActionType::SpreadTo:
      return spread_to(state, *node);
    case ActionType::SoakWith:
      return treat_with(state, *node, "soaks");
    case ActionType::HeatWith:
      return treat_with(state, *node, "heats");
    case ActionType::CoolWith:
      return cool_with(state, *node);
    case ActionType::WashWith:
      return treat_with(state, *node, "washes");
    case ActionType::CookWith:
      return treat_with(state, *node, "cooks");
    case ActionType::BurnWith:
      return treat_with(state, *node, "burns");
    case ActionType::FillWith:
      return treat_with(state, *node, "fills");
    case ActionType::SitOn:
      return take_seat(state, *node, Predicate::SatOn);
    case ActionType::LieOn:
      return take_seat(state, *node, Predicate::LainOn);
    case ActionType::PlugIn:
      return plug(state, *node, true);
    case ActionType::Unplug:
      return plug(state, *node, false);
    case ActionType::Fold:
      return fold(state, *node);
    case ActionType::Break:
      return break_apart(state, *node);
    default:
      return failed(Failure::InvalidAction, std::string(about.name) + " is no action on an object.");
  }
}

}  // namespace

World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
World::World(const World& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
World::World(World&&) noexcept = default;
World& World::operator=(const World& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(Scene start, const Knowledge& knowledge, const Profile& profile) {
  for (const Node& node : start.nodes) {
    if (knowledge.find(node.category) == nullptr) {
      return Error{Error::Kind::Schema,
                   start.id,
                   {},
                   "object " + node.id + " has category " + node.category + ", which the knowledge base of " +
                       std::string(name_of(knowledge.simulator())) + " does not have"};
    }
  }
  if (start.simulator != knowledge.simulator() || start.simulator != profile.simulator) {
    return Error{Error::Kind::Schema, start.id, {}, "scene, knowledge base and profile are of different simulators"};
  }
  if (room_at(start, start.agent.position) == nullptr) {
    return Error{Error::Kind::Schema, start.id, {}, "the agent stands in no room"};
  }
  auto impl = std::make_unique<Impl>();
  WorldState& state = impl->state;
  state.scene = std::move(start);
  state.knowledge = &knowledge;
  state.profile = &profile;
  state.physics = physics_of(state.scene);
  std::vector<std::size_t> in_hand;
  for (const std::string& id : state.scene.agent.held) {
    const auto i = state.index_of(id);
    if (!i) return Error{Error::Kind::Schema, state.scene.id, {}, "the agent holds " + id + ", which does not exist"};
    for (const std::size_t member : state.group_of(*i)) in_hand.push_back(member);
  }
  std::vector<Edge> carried;
  for (const Edge& edge : state.scene.edges) {
    const auto from = state.index_of(edge.from), to = state.index_of(edge.to);
    const auto is_in_hand = [&](const std::optional<std::size_t>& i) {
      return i && std::find(in_hand.begin(), in_hand.end(), *i) != in_hand.end();
    };
    const bool contact = edge.relation == Predicate::On || edge.relation == Predicate::Inside;
    if (contact && is_in_hand(from) && is_in_hand(to)) carried.push_back(edge);
  }
  for (const std::size_t i : in_hand) state.physics.remove(static_cast<BodyId>(i));
  std::vector<Edge> before = std::move(state.scene.edges);
  state.scene.edges = read_relations(state.scene, state.physics, carried);
  state.keep_attached(before);
  return World(std::move(impl));
}

Outcome World::step(const Action& action) {
  if (impl_->state.stopped) return failed(Failure::InvalidAction, "The episode has ended.");
  return perform(impl_->state, action);
}

const Scene& World::scene() const { return impl_->state.scene; }
const Profile& World::profile() const { return *impl_->state.profile; }
bool World::stopped() const { return impl_->state.stopped; }

std::vector<VisibleObject> World::visible() const {
  const WorldState& state = impl_->state;
  return state.viewer.view(state.scene, hidden_from_sight(state.scene), state.scene.agent, *state.profile,
                           state.profile->sight_m);
}

std::vector<VisibleObject> World::pictured() const {
  const WorldState& state = impl_->state;
  return state.viewer.view(state.scene, hidden_from_sight(state.scene), state.scene.agent, *state.profile, kEndless_m);
}

std::optional<PixelBox> World::pictured_from(const Agent& eye, std::string_view id) const {
  const WorldState& state = impl_->state;
  const auto node = state.index_of(id);
  if (!node) return std::nullopt;
  // Most places are turned down here, before anything is gathered.
  const Node& target = state.node(*node);
  if (!camera_of(eye, *state.profile).may_show(target.pose.position, sight_radius(target))) return std::nullopt;
  return state.viewer.box_of(state.scene, hidden_from_sight(state.scene), *node, eye, *state.profile);
}

std::optional<Agent> World::led_to(const Agent& from, const Action& action) const {
  const WorldState& state = impl_->state;
  if (!state.profile->offers(action.type)) return std::nullopt;
  if (action.type == ActionType::GoTo) {
    Agent agent = from;
    if (const Room* room = find_room(state.scene, action.args.front())) {
      const auto place = place_in_room(state, *room);
      if (!place) return std::nullopt;
      agent.position = *place;
      agent.pitch = 0;
      return agent;
    }
    const auto node = state.index_of(action.args.front());
    const auto place = node && !state.closed_around(*node) ? standing_place_for(action.args.front()) : std::nullopt;
    if (!place) return std::nullopt;
    agent.position = *place;
    return facing(agent, state.node(*node).pose.position, *state.profile);
  }
  const auto move = move_of(action.type);
  return move ? moved(from, *move, state.grid(), *state.profile) : std::nullopt;
}

std::optional<Vec2> World::standing_place_for(std::string_view id) const {
  const WorldState& state = impl_->state;
  const auto node = state.index_of(id);
  if (!node || state.held(id)) return std::nullopt;
  return standing_place(state.scene, state.physics, state.grid(), state.walk(), *state.profile, *node);
}

bool World::can_stand_at(std::string_view id) const {
  const WorldState& state = impl_->state;
  const auto node = state.index_of(id);
  return node && !state.closed_around(*node) && standing_place_for(id).has_value();
}

double World::walking_distance(std::string_view id) const {
  const WorldState& state = impl_->state;
  const auto node = state.index_of(id);
  double best = std::numeric_limits<double>::infinity();
  if (!node) return best;
  if (state.held(id)) return 0;
  const NavigationGrid& grid = state.grid();
  const auto& walk = state.walk();
  const Bounds bounds = bounds_of(state.node(*node).pose, state.node(*node).size);
  const double beside = state.profile->reach_m;
  const auto from = grid.cell_at(bounds.low.head<2>() - Vec2::Constant(beside));
  const auto to = grid.cell_at(bounds.high.head<2>() + Vec2::Constant(beside));
  for (int y = std::max(0, from.y); y <= std::min(grid.height() - 1, to.y); ++y) {
    for (int x = std::max(0, from.x); x <= std::min(grid.width() - 1, to.x); ++x) {
      const std::int32_t steps = walk[grid.index({x, y})];
      if (steps >= 0) best = std::min(best, steps * NavigationGrid::kCell_m);
    }
  }
  return best;
}

bool World::in_reach(std::string_view id) const {
  const auto node = impl_->state.index_of(id);
  return node && !impl_->state.held(id) && !out_of_hands_way(impl_->state, *node);
}

std::string World::closed_around(std::string_view id) const {
  const WorldState& state = impl_->state;
  const auto node = state.index_of(id);
  if (!node) return "";
  const auto container = state.closed_around(*node);
  return container ? state.node(*container).id : "";
}

}  // namespace unietp
