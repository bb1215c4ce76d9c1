#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "scene/scene.h"
#include "sense/start_states.h"
#include "sense/use_states.h"
#include "sense/usual_places.h"

namespace unietp {

/// How things are in a lived-in home of one simulator: where those of a category usually are, and in which states.
/// A value; read only after making.
class Household {
 public:
  /// A kind of place for things of a category.
  struct Place {
    Predicate relation = Predicate::On;  // or Inside
    std::string receptacle;              // category
    double weight = 0;                   // relative to the category's other places
    bool usual = true;                   // false: tolerable
  };

  Household(const Knowledge& knowledge, const CommonSense& sense, StartStates states, UseStates uses = {});

  /// Of a movable category, by receptacle, then relation; empty when nothing is known.
  const std::vector<Place>& places_of(std::string_view category) const;
  /// One of these; nullptr when things of the category are not kept there.
  const Place* place(std::string_view category, Predicate relation, std::string_view receptacle) const;
  /// How well a type of room suits a category: the square of the score that CommonSense gives to being there, so 1
  /// where such things usually are, 0.09 where they are at times and below 0.015 where nobody looks for them
  /// (`kNoRoom`). 1 for what has no kind.
  double in_room(std::string_view category, std::string_view room) const;
  static constexpr double kNoRoom = 0.0144;
  /// Whether such a room is one where things of the category usually are: wine is not asked for on a bathroom's
  /// counter.
  bool is_usual_in(std::string_view category, std::string_view room) const;
  /// Whether homes of the simulator have things of the category in rooms of a type: real homes do, as was noted, or the
  /// knowledge base calls it a usual room. True for what nothing is known of.
  bool is_found_in(std::string_view category, std::string_view room) const;
  void note_room(const std::string& category, const std::string& room) { found_in_[category].insert(room); }
  /// Whether things of the category are kept on or in a receptacle that stands in such a room. What stands about is in
  /// any room that suits it at times; into places of PlaceUse::PutAway it goes only in rooms where it usually is, and
  /// so it does into those of PlaceUse::OwnRooms.
  bool keeps(std::string_view category, std::string_view receptacle, std::string_view room) const;
  /// Whether things are put away on or in such a receptacle (PlaceUse::PutAway), and whether they go into it to be
  /// washed or thrown away (PlaceUse::DirtyOrNot).
  bool puts_away(std::string_view receptacle) const { return put_away_.contains(receptacle); }
  bool washes(std::string_view receptacle) const { return washing_.contains(receptacle); }
  /// Whether tasks put things on or into such a receptacle though nobody keeps them there (PlaceUse::Passing).
  bool passes(std::string_view receptacle) const { return passing_.contains(receptacle); }
  /// Whether homes have several things of the category alike (Kind::several): spoons, apples, books.
  bool has_several(std::string_view category) const;
  /// Whether the category is of a kind, or of a narrower one.
  bool is_a(std::string_view category, std::string_view kind) const { return kinds_.is_a(kind_of(category), kind); }
  /// Whether each thing of the category belongs to somebody (Kind::personal).
  bool is_personal(std::string_view category) const;
  /// Whether the name of a category is a generic word that could mean a thing of the other: "fruit" an apple.
  bool may_mean(std::string_view name, const std::string& other) const;
  /// How usual it is that things of a movable category are on the floor, from 0 to 1: 0 unless CommonSense calls it
  /// usual, but toys are left there at times.
  double on_floor(std::string_view category) const;
  /// The share of things of the category that are in a state at a place; a little when nobody spoke of it. `receptacle`
  /// "": wherever it is.
  double share(std::string_view category, Predicate relation, std::string_view receptacle, const State& state) const;
  /// True for two categories that a rule of safety keeps apart: cleaning agents and food. Kinds of food are not kept
  /// apart here: a fridge has a shelf for each.
  bool clash(std::string_view a, std::string_view b) const;
  /// Whether things are kept in such a receptacle (PlaceUse::Storage), a box or a bag.
  bool stores(std::string_view receptacle) const { return storing_.contains(receptacle); }
  /// True for two categories that nobody keeps in one such place: soap and bread in a cabinet, but not on a counter.
  bool stored_apart(std::string_view a, std::string_view b, Predicate relation, std::string_view receptacle) const;
  /// All states that are spoken of there.
  std::vector<LikelyState> states_of(std::string_view category, Predicate relation, std::string_view receptacle) const;

  /// The states in which people find things of the category that they use so (UseStates::of).
  std::vector<Predicate> states_in_use(std::string_view category, const Role& use) const;
  /// Being on or in such a receptacle as a role; "" when it has no kind.
  Role role_at(Predicate relation, std::string_view receptacle) const;
  /// Of a category; "" when it has none.
  std::string_view kind_of(std::string_view category) const;

 private:
  Kinds kinds_;
  StartStates states_;
  UseStates uses_;
  /// The rules of safety that keep a category apart from another: as the first that they name, or as the second.
  struct Rules {
    std::vector<std::size_t> first, second;
  };
  std::map<std::string, Rules, std::less<>> apart_;  // by category; of those that a rule speaks of
  std::map<std::string, CommonSense::StoredApart, std::less<>> stored_apart_;  // by category
  std::map<std::string, std::string, std::less<>> kind_;                       // by category
  std::set<std::string, std::less<>> put_away_;                                // receptacles of PlaceUse::PutAway
  std::set<std::string, std::less<>> own_rooms_;                               // receptacles of PlaceUse::OwnRooms
  std::set<std::string, std::less<>> washing_;                                 // receptacles of PlaceUse::DirtyOrNot
  std::set<std::string, std::less<>> passing_;                                 // receptacles of PlaceUse::Passing
  std::set<std::string, std::less<>> storing_;  // receptacles of PlaceUse::Storage, boxes and bags
  std::map<std::string, std::vector<Place>, std::less<>> places_;
  // By kind, or by category where a rule names it; then by type of room.
  std::map<std::string, std::map<std::string, double, std::less<>>, std::less<>> rooms_;
  std::map<std::string, std::set<std::string>, std::less<>>
      covered_by_name_;                                  // by a category with a generic name: others
  std::map<std::string, double, std::less<>> on_floor_;  // by kind, or by category
  std::map<std::string, std::set<std::string, std::less<>>, std::less<>> found_in_;  // rooms of a movable category
};

/// The household of a simulator from the tables of data/sense. Errors: the first of those tables.
Result<Household> read_household(const std::filesystem::path& sense, const Knowledge& knowledge);

}  // namespace unietp
