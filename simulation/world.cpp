#include "simulation/world.h"

#include <algorithm>
#include <limits>

#include "simulation/agent_moves.h"
#include "simulation/camera.h"
#include "simulation/known_start.h"
#include "simulation/moment_tree.h"
#include "simulation/solids.h"

namespace unietp {
namespace {

/// Lowest and highest cell of the rectangle around a node from which it may be in reach.
std::pair<NavigationGrid::Cell, NavigationGrid::Cell> cells_beside(const WorldState& state, const Node& node) {
  const Bounds bounds = bounds_of(node.pose, node.size);
  const Vec2 beside = Vec2::Constant(state.profile->reach_m);
  return {state.grid().cell_at(bounds.low.head<2>() - beside), state.grid().cell_at(bounds.high.head<2>() + beside)};
}

}  // namespace

World::World(std::shared_ptr<MomentTree> tree) : tree_(std::move(tree)) {}
World::World(const World& other)
    : tree_(other.tree_), moment_(other.moment_), changes_(other.changes_), passed_(other.passed_) {}
World::World(World&&) noexcept = default;
World& World::operator=(const World& other) {
  if (this != &other) *this = World(other);
  return *this;
}
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(Scene start, const Knowledge& knowledge, const Profile& profile) {
  KnownStart known{.physics = physics_of(start)};
  return create(std::move(start), knowledge, profile, std::move(known));
}

Result<World> World::create(Scene start, const Knowledge& knowledge, const Profile& profile, KnownStart known) {
  if (!known.places) known.places = NodeIndex(start.nodes);
  for (const std::string_view category : known.places->categories()) {
    if (knowledge.find(category) != nullptr) continue;
    const std::string& id = start.nodes[known.places->of(category).front()].id;
    return Error{Error::Kind::Schema,
                 start.id,
                 {},
                 "object " + id + " has category " + std::string(category) + ", which the knowledge base of " +
                     std::string(name_of(knowledge.simulator())) + " does not have"};
  }
  if (start.simulator != knowledge.simulator() || start.simulator != profile.simulator) {
    return Error{Error::Kind::Schema, start.id, {}, "scene, knowledge base and profile are of different simulators"};
  }
  if (room_at(start, start.agent.position) == nullptr) {
    return Error{Error::Kind::Schema, start.id, {}, "the agent is in no room"};
  }
  Viewer viewer = known.viewer ? *known.viewer : Viewer(start);
  auto state = WorldState::of(std::move(start), knowledge, profile, std::move(known));
  if (!state) return state.error();
  return World(std::make_shared<MomentTree>(std::move(*state), std::move(viewer)));
}

ActionResult World::step(const Action& action) {
  const MomentTree::Step& done = tree_->step(moment_, action);
  moment_ = done.next;
  changes_ = &done.changes;
  passed_ = &done.passed;
  if (shown_ != nullptr && !done.changes.empty()) pending_changes_.push_back(changes_);
  return done.result;
}

const Delta& World::changes() const {
  static const Delta kNone{};
  return changes_ == nullptr ? kNone : *changes_;
}

const std::vector<PassedMoment>& World::passed() const {
  static const std::vector<PassedMoment> kNone{};
  return passed_ == nullptr ? kNone : *passed_;
}

std::vector<Delta> World::changes_by_moment() const {
  if (passed().empty()) return {changes()};
  std::vector<Delta> changes;
  for (const PassedMoment& one : passed()) changes.push_back(one.changes);
  return changes;
}

const Scene& World::scene() const {
  if (shown_ == nullptr) shown_ = std::make_unique<Scene>(tree_->at(moment_).whole_scene());
  for (const Delta* change : pending_changes_) *shown_ = apply(std::move(*shown_), *change);
  pending_changes_.clear();
  return *shown_;
}

World World::at(MomentId moment) const {
  World other(tree_);
  other.moment_ = moment;
  return other;
}

void World::forget() {
  if (tree_.use_count() != 1) return;
  tree_->forget_all_but(moment_);
  moment_ = MomentId();
  changes_ = nullptr;
  passed_ = nullptr;
  shown_.reset();
  pending_changes_.clear();
}

World World::apart() const { return World(std::make_shared<MomentTree>(tree_->at(moment_), tree_->viewer())); }

const Profile& World::profile() const { return tree_->profile(); }
bool World::stopped() const { return tree_->stopped(moment_); }

const std::vector<VisibleObject>& World::visible() const { return tree_->visible(moment_, profile().sight_m); }
const std::vector<VisibleObject>& World::pictured() const { return tree_->visible(moment_, kEndless_m); }

bool World::shows(std::string_view id) const { return tree_->shows(moment_, id); }

const std::optional<PixelBox>& World::unique_box(std::string_view id) const { return tree_->unique_box(moment_, id); }
const std::string* World::object_of_box(const PixelBox& box) const { return tree_->object_of_box(moment_, box); }

Picture World::picture(const Profile& lens, Rays& rays) const {
  return picture_of(tree_->at(moment_).viewed(), lens, rays);
}

const Node* World::pictured_at(int x, int y, Rays& rays) const {
  const WorldState& state = tree_->at(moment_);
  const auto node = node_at(state.viewed(), *state.profile, x, y, rays);
  return node ? &state.node(*node) : nullptr;
}

std::optional<PixelBox> World::pictured_from(const Agent& eye, std::string_view id) const {
  const WorldState& state = tree_->at(moment_);
  const auto node = state.index_of(id);
  if (!node) return std::nullopt;
  // Cheap test first: most positions fail it.
  const Node& target = state.node(*node);
  if (!camera_of(eye, *state.profile).may_show(target.pose.position, sight_radius(target))) return std::nullopt;
  return tree_->viewer().box_of(state.viewed(), *node, eye, *state.profile);
}

std::optional<Agent> World::agent_after(const Agent& from, const Action& action) const {
  const WorldState& state = tree_->at(moment_);
  if (!state.profile->offers(action.type)) return std::nullopt;
  if (action.type == ActionType::GoTo) {
    Agent agent = from;
    if (const Room* room = unietp::find_room(state.scene(), action.args.front())) {
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

const SharedList<Node>& World::nodes() const { return tree_->at(moment_).scene().nodes; }
const NodeIndex& World::places() const { return tree_->at(moment_).places(); }

const Node* World::find(std::string_view id) const {
  const WorldState& state = tree_->at(moment_);
  const auto node = state.index_of(id);
  return node ? &state.node(*node) : nullptr;
}

const Agent& World::agent() const { return tree_->at(moment_).agent(); }
bool World::holds(std::string_view id) const { return tree_->at(moment_).held(id); }
const Room* World::find_room(std::string_view id) const { return unietp::find_room(tree_->at(moment_).scene(), id); }

bool World::linked(std::string_view from, Predicate relation, std::string_view to) const {
  const WorldState& state = tree_->at(moment_);
  const auto first = state.index_of(from), second = state.index_of(to);
  return first && second && state.linked(*first, relation, *second);
}

std::vector<std::string> World::linked_from(std::string_view from, Predicate relation) const {
  const WorldState& state = tree_->at(moment_);
  std::vector<std::string> ids;
  const auto node = state.index_of(from);
  if (!node) return ids;
  for (const Link& link : state.links(*node)) {
    if (link.relation == relation) ids.push_back(edge_of(state.scene(), *node, link).to);
  }
  return ids;
}

std::vector<std::string> World::resting_at(std::string_view id) const {
  const WorldState& state = tree_->at(moment_);
  std::vector<std::string> ids;
  const auto node = state.index_of(id);
  if (!node) return ids;
  for (const std::uint32_t rider : state.carried(*node)) ids.push_back(state.node(rider).id);
  return ids;
}

std::vector<std::size_t> World::places_near(const Bounds& bounds, double gap) const {
  const WorldState& state = tree_->at(moment_);
  std::vector<std::size_t> places;
  for (const BodyId body : state.physics().near(bounds, gap)) {
    if (body.is_node()) places.push_back(body.index());
  }
  return places;
}

std::string World::room_of(std::string_view id) const {
  const auto rooms = linked_from(id, Predicate::InRoom);
  return rooms.empty() ? "" : rooms.front();
}

std::optional<Vec2> World::standing_place_for(std::string_view id) const {
  const WorldState& state = tree_->at(moment_);
  const auto node = state.index_of(id);
  if (!node || state.held(id)) return std::nullopt;
  return state.standing_place(*node);
}

bool World::can_stand_at(std::string_view id) const {
  const WorldState& state = tree_->at(moment_);
  const auto node = state.index_of(id);
  return node && !state.closed_around(*node) && standing_place_for(id).has_value();
}

double World::walking_distance(std::string_view id) const {
  const WorldState& state = tree_->at(moment_);
  const auto node = state.index_of(id);
  if (!node) return std::numeric_limits<double>::infinity();
  if (state.held(id)) return 0;
  constexpr std::int32_t kMostSteps = 400;
  const auto [low, high] = cells_beside(state, state.node(*node));
  const std::int32_t fewest = state.steps_to(low, high, kMostSteps);
  if (fewest >= 0) return fewest * NavigationGrid::kCell_m;
  const CellSet& walk = state.walk();
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (walk.has(x, y)) return std::max(kMostSteps * NavigationGrid::kCell_m, straight_distance(state.node(*node)));
    }
  }
  return std::numeric_limits<double>::infinity();
}

double World::straight_distance(const Node& node) const {
  const WorldState& state = tree_->at(moment_);
  if (state.held(node.id)) return 0;
  const auto [low, high] = cells_beside(state, node);
  const NavigationGrid::Cell here = state.cell();
  const int aside = std::max({0, low.x - here.x, here.x - high.x}),
            ahead = std::max({0, low.y - here.y, here.y - high.y});
  return (aside + ahead) * NavigationGrid::kCell_m;
}

bool World::in_reach(std::string_view id) const {
  const WorldState& state = tree_->at(moment_);
  const auto node = state.index_of(id);
  return node && !state.held(id) && !access_failure(state, *node);
}

bool World::in_reach_from(const Vec2& place, std::string_view id) const {
  const WorldState& state = tree_->at(moment_);
  const auto node = state.index_of(id);
  return node && !state.held(id) && !access_failure(state, *node, place);
}

std::vector<Pose> World::free_spots(std::string_view id, bool inside) const {
  const auto& held = agent().held;
  return held.empty() ? std::vector<Pose>() : free_spots_for(held.front(), id, inside);
}

std::vector<Pose> World::free_spots_for(std::string_view thing, std::string_view id, bool inside) const {
  const WorldState& state = tree_->at(moment_);
  const auto what = state.index_of(thing), node = state.index_of(id);
  return what && node ? unietp::free_spots(state, *what, *node, inside) : std::vector<Pose>();
}

std::string World::closed_around(std::string_view id) const {
  const WorldState& state = tree_->at(moment_);
  const auto node = state.index_of(id);
  if (!node) return "";
  const auto container = state.closed_around(*node);
  return container ? state.node(*container).id : "";
}

}  // namespace unietp
