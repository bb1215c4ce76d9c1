#include "expert/put_down_options.h"

#include <algorithm>
#include <array>
#include <utility>

#include "expert/situation.h"

namespace unietp {
namespace {

constexpr std::size_t kMostSpots = 12;
constexpr double kBesides = 2.5;  // reaches between a piece's sphere and where walks to it are counted to end

/// No walk to a piece is shorter.
double least_walk(const World& world, const Node& piece) {
  const double away = (piece.pose.position.head<2>() - world.agent().position).norm();
  return std::max(0.0, away - piece.size.norm() / 2 - kBesides * world.profile().reach_m);
}

}  // namespace

PutDownOptions::PutDownOptions(const World& world, const Knowledge& knowledge, Request request)
    : world_(world),
      knowledge_(&knowledge),
      request_(std::move(request)),
      spots_(kMostSpots, [world, room = request_.room](const Spot& spot) -> std::optional<Rank> {
        const std::string id = world.nodes()[spot.place].id;
        if (!world.closed_around(id).empty() || (!room.empty() && world.room_of(id) != room)) return std::nullopt;
        const double walk = world.walking_distance(id);
        if (walk >= Situation::kFar_m) return std::nullopt;
        return Rank(!world.in_reach(id), walk, id, spot.action);
      }) {}

std::optional<Action> PutDownOptions::next() {
  constexpr std::array<Class, 4> kBestFirst{{{false, true}, {false, false}, {true, true}, {true, false}}};
  auto spot = spots_.next();
  while (!spot && classes_ < kBestFirst.size()) {
    add_all_of(kBestFirst[classes_++]);
    spot = spots_.next();
  }
  if (!spot) return std::nullopt;
  return Action{spot->action, {world_.nodes()[spot->place].id}};
}

void PutDownOptions::add_all_of(Class wanted) {
  for (const std::string_view category : world_.places().categories()) {
    const auto& spoken_of = request_.spoken_of;
    const bool is_spoken_of = std::find(spoken_of.begin(), spoken_of.end(), category) != spoken_of.end();
    if (is_spoken_of == wanted.spoken_of) add_all_of(category, wanted.usual);
  }
}

void PutDownOptions::add_all_of(std::string_view category, bool usual) {
  const Node* thing = world_.find(request_.thing);
  const Room* within = request_.room.empty() ? nullptr : world_.find_room(request_.room);
  const auto is_one = [&](Predicate relation) {
    const bool is_usual = thing != nullptr && knowledge_->placement(thing->category, relation, category) != nullptr;
    return is_usual == usual && (is_usual || knowledge_->has(category, "receptacle"));
  };
  const bool on = is_one(Predicate::On), inside = within != nullptr && is_one(Predicate::Inside);
  if (!on && !inside) return;
  for (const std::size_t place : world_.places().of(category)) {
    const Node& piece = world_.nodes()[place];
    if (piece.movable || piece.id == request_.except) continue;
    if (within != nullptr && !contains(within->polygon, piece.pose.position.head<2>())) continue;
    const double least = least_walk(world_, piece);
    const auto add = [&](ActionType action) { spots_.add({place, action}, Rank(least > 0, least, "", action)); };
    if (on) add(ActionType::PlaceOn);
    if (inside && (!piece.openable || piece.states.has(Predicate::Open))) add(ActionType::PlaceIn);
  }
}

}  // namespace unietp
