#include "grounding/room_doors.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

#include "akb/row_reader.h"
#include "akb/table_words.h"

namespace unietp {
namespace {

constexpr double kMoreOpenings = 0.3;  // chance of one that is not needed
constexpr double kOfItsOwn = 0.5;      // chance that a second bathroom belongs to a bedroom
constexpr int kBedroomsToABathroom = 3, kMostBathrooms = 3;

const std::vector<std::string> kColumns{"use", "room", "other", "source"};
const std::vector<std::string> kUses{"walked_through", "at_the_end", "another"};

class OpeningChoice {
 public:
  OpeningChoice(const std::vector<std::string>& types, std::vector<SharedWall> walls, const RoomDoors& doors, Rng& rng)
      : types_(types), doors_(doors), walls_(std::move(walls)), taken_(walls_.size(), false), rng_(rng) {}

  bool join_what_one_walks_through() {
    std::vector<std::size_t> group(types_.size());
    std::iota(group.begin(), group.end(), 0);
    for (const auto& pair : doors_.walked_through) {
      for (std::size_t i = 0; i < walls_.size(); ++i) {
        const SharedWall& wall = walls_[i];
        if (!is(wall, pair) || group[wall.a] == group[wall.b]) continue;
        std::replace(group.begin(), group.end(), std::size_t(group[wall.b]), std::size_t(group[wall.a]));
        taken_[i] = true;
      }
    }
    std::set<std::size_t> groups;
    for (std::size_t room = 0; room < types_.size(); ++room) {
      const bool walked_through =
          std::any_of(doors_.walked_through.begin(), doors_.walked_through.end(),
                      [&](const auto& pair) { return pair.first == types_[room] || pair.second == types_[room]; });
      if (walked_through) groups.insert(group[room]);
    }
    return groups.size() == 1;
  }

  bool add_rooms_at_the_end() {
    for (std::size_t room = 0; room < types_.size(); ++room) {
      bool at_the_end = false, joined = false;
      for (const auto& [type, other] : doors_.at_the_end) {
        if (type != types_[room]) continue;
        at_the_end = true;
        joined = joined || take(room, other);
      }
      if (at_the_end && !joined) return false;
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
      const bool suits = std::any_of(doors_.another.begin(), doors_.another.end(),
                                     [&](const auto& pair) { return is(walls_[i], pair); });
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
  bool is(const SharedWall& wall, const std::pair<std::string, std::string>& pair) const {
    const std::string &a = types_[wall.a], &b = types_[wall.b];
    return (a == pair.first && b == pair.second) || (a == pair.second && b == pair.first);
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
  const RoomDoors& doors_;
  std::vector<SharedWall> walls_;
  std::vector<bool> taken_;
  std::set<std::size_t> with_bathroom_;
  Rng& rng_;
};

}  // namespace

RoomDoors read_room_doors(std::string_view where, std::string_view text, std::vector<Error>& errors) {
  RoomDoors doors;
  const std::map<std::string, RoomDoors::Pairs*> pairs{
      {kUses[0], &doors.walked_through}, {kUses[1], &doors.at_the_end}, {kUses[2], &doors.another}};
  RowReader row(std::string(where), text, kColumns, errors);
  for (const CsvRow& cells : row.rows()) {
    row.at(cells);
    const std::string use = row.one_of("use", kUses, "use");
    std::string room = row.one_of("room", room_types(), "room type");
    std::string other = row.one_of("other", room_types(), "room type");
    row.required("source");
    if (row.sound()) pairs.at(use)->emplace_back(std::move(room), std::move(other));
  }
  return doors;
}

std::optional<std::vector<SharedWall>> choose_openings(const std::vector<std::string>& room_types,
                                                       std::vector<SharedWall> walls, const RoomDoors& doors,
                                                       Rng& rng) {
  rng.shuffle(walls);
  OpeningChoice choice(room_types, std::move(walls), doors, rng);
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
