#include "expert/ways_to_rid.h"

#include <algorithm>

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

WaysToRid::WaysToRid(const World& world, const Knowledge& knowledge, const Wish& wish)
    : world_(world), spots_(kMostSpots, [world, room = wish.room](const Spot& spot) -> std::optional<Rank> {
        const std::string id = world.nodes()[spot.place].id;
        if (!world.closed_around(id).empty() || (!room.empty() && world.room_of(id) != room)) return std::nullopt;
        const double walk = world.walking_distance(id);
        if (walk >= Situation::kFar_m) return std::nullopt;
        return Rank(spot.spoken_of, !spot.usual, !world.in_reach(id), walk, id, spot.action);
      }) {
  for (const std::string_view category : world.places().categories()) add_all_of(category, knowledge, wish);
}

void WaysToRid::add_all_of(std::string_view category, const Knowledge& knowledge, const Wish& wish) {
  const Node* thing = world_.find(wish.thing);
  const Room* within = wish.room.empty() ? nullptr : world_.find_room(wish.room);
  const bool spoken_of = std::find(wish.spoken_of->begin(), wish.spoken_of->end(), category) != wish.spoken_of->end();
  const bool takes = knowledge.has(category, "receptacle");
  const auto usual = [&](const char* relation) {
    return thing != nullptr && knowledge.placement(thing->category, relation, category) != nullptr;
  };
  const bool on = usual("on"), inside = within != nullptr && usual("inside");
  if (!takes && !on && !inside) return;
  for (const std::size_t place : world_.places().of(category)) {
    const Node& piece = world_.nodes()[place];
    if (piece.movable || piece.id == wish.except) continue;
    if (within != nullptr && !contains(within->polygon, piece.pose.position.head<2>())) continue;
    const double least = least_walk(world_, piece);
    const auto add = [&](ActionType action, bool is_usual) {
      if (!takes && !is_usual) return;
      spots_.add({place, action, spoken_of, is_usual}, Rank(spoken_of, !is_usual, least > 0, least, "", action));
    };
    add(ActionType::PlaceOn, on);
    const bool open = !piece.openable || piece.states.has(Predicate::Open);
    if (within != nullptr && open) add(ActionType::PlaceIn, inside);
  }
}

std::optional<Action> WaysToRid::next() {
  const auto spot = spots_.next();
  if (!spot) return std::nullopt;
  return Action{spot->action, {world_.nodes()[spot->place].id}};
}

}  // namespace unietp
