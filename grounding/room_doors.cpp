#include "grounding/room_doors.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

namespace unietp {
namespace {

constexpr double kMoreOpenings = 0.3;  // chance of one that is not needed
constexpr double kOfItsOwn = 0.5;      // chance that a second bathroom belongs to a bedroom
constexpr int kBedroomsToABathroom = 3, kMostBathrooms = 3;

using TypePair = std::pair<std::string_view, std::string_view>;

/// Rooms that one walks through, by which pairs are joined first.
constexpr std::array<TypePair, 4> kWalkedThrough{{{"corridor", "living_room"},
                                                  {"living_room", "dining_room"},
                                                  {"corridor", "dining_room"},
                                                  {"living_room", "living_room"}}};
/// A room at the end, and where its door leads; the first that there is.
constexpr std::array<TypePair, 7> kAtTheEnd{{{"kitchen", "dining_room"},
                                             {"kitchen", "living_room"},
                                             {"bedroom", "corridor"},
                                             {"bedroom", "living_room"},
                                             {"office", "corridor"},
                                             {"office", "living_room"},
                                             {"office", "dining_room"}}};
/// What may have one opening more.
constexpr std::array<TypePair, 6> kMore{{{"kitchen", "dining_room"},
                                         {"kitchen", "living_room"},
                                         {"kitchen", "corridor"},
                                         {"living_room", "dining_room"},
                                         {"corridor", "dining_room"},
                                         {"corridor", "living_room"}}};

class OpeningChoice {
 public:
  OpeningChoice(const std::vector<std::string>& types, std::vector<SharedWall> walls, Rng& rng)
      : types_(types), walls_(std::move(walls)), taken_(walls_.size(), false), rng_(rng) {}

  bool join_what_one_walks_through() {
    std::vector<std::size_t> group(types_.size());
    std::iota(group.begin(), group.end(), 0);
    for (const TypePair& pair : kWalkedThrough) {
      for (std::size_t i = 0; i < walls_.size(); ++i) {
        const SharedWall& wall = walls_[i];
        if (!is(wall, pair) || group[wall.a] == group[wall.b]) continue;
        std::replace(group.begin(), group.end(), std::size_t(group[wall.b]), std::size_t(group[wall.a]));
        taken_[i] = true;
      }
    }
    std::set<std::size_t> groups;
    for (std::size_t room = 0; room < types_.size(); ++room) {
      if (types_[room] == "corridor" || types_[room] == "living_room" || types_[room] == "dining_room")
        groups.insert(group[room]);
    }
    return groups.size() == 1;
  }

  bool add_rooms_at_the_end() {
    for (std::size_t room = 0; room < types_.size(); ++room) {
      if (types_[room] != "kitchen" && types_[room] != "bedroom" && types_[room] != "office") continue;
      const bool found = std::any_of(kAtTheEnd.begin(), kAtTheEnd.end(), [&](const TypePair& pair) {
        return pair.first == types_[room] && take(room, pair.second);
      });
      if (!found) return false;
    }
    return true;
  }

  bool add_bathrooms() {
    const bool corridor = std::find(types_.begin(), types_.end(), "corridor") != types_.end();
    bool shared = !corridor;  // one that everybody can go to
    for (std::size_t room = 0; room < types_.size(); ++room) {
      if (types_[room] != "bathroom") continue;
      const bool own = shared && (!corridor || rng_.chance(kOfItsOwn));
      if (!(own && take_bedroom(room)) && !take(room, "corridor") && !(shared && take_bedroom(room))) return false;
      shared = true;
    }
    return true;
  }

  void add_more() {
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      const bool suits =
          std::any_of(kMore.begin(), kMore.end(), [&](const TypePair& pair) { return is(walls_[i], pair); });
      if (suits && !taken_[i] && rng_.chance(kMoreOpenings)) taken_[i] = true;
    }
  }

  std::vector<SharedWall> chosen() const {
    std::vector<SharedWall> openings;
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      if (taken_[i]) openings.push_back(walls_[i]);
    }
    return openings;
  }

 private:
  bool is(const SharedWall& wall, const TypePair& pair) const {
    const TypePair types{types_[wall.a], types_[wall.b]};
    return types == pair || types == TypePair{pair.second, pair.first};
  }

  /// An opening to a room of the type; false where no wall is shared with one.
  bool take(std::size_t room, std::string_view type) {
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      const auto other = beyond(walls_[i], room);
      if (!other || types_[*other] != type) continue;
      taken_[i] = true;
      return true;
    }
    return false;
  }

  /// The same to a bedroom that has no bathroom yet.
  bool take_bedroom(std::size_t bathroom) {
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      const auto other = beyond(walls_[i], bathroom);
      if (!other || types_[*other] != "bedroom" || !with_bathroom_.insert(*other).second) continue;
      taken_[i] = true;
      return true;
    }
    return false;
  }

  static std::optional<std::size_t> beyond(const SharedWall& wall, std::size_t room) {
    if (wall.a == room) return wall.b;
    return wall.b == room ? std::optional(wall.a) : std::nullopt;
  }

  const std::vector<std::string>& types_;
  std::vector<SharedWall> walls_;
  std::vector<bool> taken_;
  std::set<std::size_t> with_bathroom_;
  Rng& rng_;
};

}  // namespace

std::optional<std::vector<SharedWall>> choose_openings(const std::vector<std::string>& room_types,
                                                       std::vector<SharedWall> walls, Rng& rng) {
  rng.shuffle(walls);
  OpeningChoice choice(room_types, std::move(walls), rng);
  if (!choice.join_what_one_walks_through() || !choice.add_rooms_at_the_end() || !choice.add_bathrooms())
    return std::nullopt;
  choice.add_more();
  return choice.chosen();
}

bool bathrooms_suit(int bathrooms, int bedrooms) {
  const int least = (bedrooms + kBedroomsToABathroom - 1) / kBedroomsToABathroom;
  return bathrooms >= least && bathrooms <= std::min(bedrooms, kMostBathrooms);
}

}  // namespace unietp
