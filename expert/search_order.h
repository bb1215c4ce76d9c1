#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "expert/belief.h"
#include "expert/room_views.h"
#include "grounding/household.h"
#include "scene/action.h"
#include "simulation/profile.h"

namespace unietp {

/// Something to look for.
struct SearchTarget {
  std::string category;
  std::vector<std::string> places = {}, rooms = {};  // as in SearchNeed
  bool floor = false;
  std::vector<std::string> near = {};

  bool operator==(const SearchTarget&) const = default;
};

/// Their categories, for people.
std::string names_of(const std::vector<SearchTarget>& targets);

/// Where to look for things, in the order in which they are usually found there: by the knowledge of homes in general,
/// the furniture that is known from the start, and where the agent has looked already. A place that was looked at from
/// one side may still hold something, so the best ones are looked at again, more closely, before unlikely ones.
class SearchOrder {
 public:
  /// `usual`: where things are in a lived-in home; nullptr: as the knowledge base says. All must outlive it. `shut`:
  /// categories that are not opened. Where no furniture is known from the start, it is taken to be in the rooms where
  /// such furniture usually is.
  SearchOrder(const Scene& known_scene, const Knowledge& knowledge, const Household* usual, std::set<std::string> shut,
              const Profile& profile);

  /// A place to look: a piece of furniture or a room.
  struct Look {
    std::string id;
    bool opens = false;  // it is opened for that
    int before = 0;      // how often it was looked at: each time from another angle
    bool room = false;
    bool from_here = false;     // it is opened from where the agent stands
    RoomViews::Look view = {};  // of a room, where no furniture was known from the start
  };
  /// Whether the agent could open a piece of furniture from where it stands, with it in the picture.
  using InReach = std::function<bool(const std::string& id)>;
  /// The most promising one for its steps; nullopt when none is left. `at`: where the agent has gone last.
  std::optional<Look> next(const std::vector<SearchTarget>& targets, const Belief& belief, std::string_view at,
                           const InReach& in_reach) const;
  /// The steps to it, before anything is opened: to a place that was looked at before, to a view from another angle;
  /// none where the agent is as it should be.
  std::vector<Action> way_to(const Look& look, std::string_view at) const;
  /// It was opened from where the agent stood, which shows only some of what is inside.
  void peeked_into(const std::string& id);
  /// It was looked at once more.
  void looked_at(const std::string& id, const Belief& belief);
  /// The agent was there.
  void stood(const Agent& body) { views_.saw(body); }
  /// Going to a place led there.
  void arrived(const std::string& id, const Vec2& position);
  /// It was in view; furniture that was not known is known from then on.
  void glimpsed(const Node& node, const Scene& known_scene);
  /// It cannot be gone to.
  void give_up(const std::string& id);
  /// It cannot be opened.
  void keep_shut(const std::string& id);
  /// Of all chances to find such a thing, the share that lies where nobody has looked yet.
  double unseen_share(const SearchTarget& target, const Belief& belief) const;

 private:
  /// The furniture around a piece of furniture, the nearest first.
  std::vector<std::string> beside(const std::string& id) const;
  struct Place {
    std::string id, category;  // "" for a room
    std::string room_type = "";
    Vec2 position = Vec2::Zero();
    int looks = 0, looks_inside = 0;
    std::size_t room = 0;  // its position among the rooms, of a room
    bool glimpsed = false, peeked_into = false, given_up = false, stays_shut = false;
  };
  /// To find a thing on or in a place, before anybody looked.
  struct Chance {
    double on = 0, inside = 0;
  };
  Chance chance(const SearchTarget& target, const Place& place) const;
  /// In a room, on or in furniture that nobody has seen yet, or to find such furniture.
  Chance chance_unseen(const SearchTarget& target, const Place& room) const;
  /// How likely furniture of a category is in a type of room.
  double suits(const std::string& category, const std::string& room_type) const;
  /// Steps until furniture that is gone to only when it is in the picture is there; 0 where it is named by id.
  double turns_to_see(const Place& place, const Scene& believed) const;
  static Place furniture(const Node& node, const Scene& known_scene);
  void add(Place place);
  /// That chance at each of the places, which is worked out once for a target.
  struct Chances {
    SearchTarget target;
    std::vector<Chance> at;  // by place, but for those that are such a thing themselves
  };
  const Chances& chances(const SearchTarget& target) const;
  /// With what has been seen: a piece of furniture that is looked for itself.
  Chance chance(const Chances& chances, std::size_t place, const Belief& belief) const;
  double left_on(const Place& place, int looks) const;
  /// `shut`: it is closed now; what was seen in it before still counts.
  double left_inside(const Place& place, bool shut, int looks) const;
  static bool is_shut(const Place& place, const Belief& belief);
  Place* find(const std::string& id);

  const Knowledge& knowledge_;
  const Household* usual_;
  std::set<std::string> shut_;
  RoomViews views_;
  double turns_;                  // steps of a quarter turn
  bool knows_furniture_ = false;  // from the start
  std::vector<Place> places_;
  std::map<std::string, std::size_t, std::less<>> place_of_;
  std::map<std::string, int, std::less<>> of_category_;  // how many pieces
  mutable std::deque<Chances> chances_;                  // of all targets so far
};

}  // namespace unietp
