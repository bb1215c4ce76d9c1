#include "grounding/household.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace unietp {
namespace {

constexpr double kInPassing = 0.15;  // of the weight of a place that things only pass through

constexpr double kUsualRoom = 0.25;      // least value of in_room() of a room where such things usually are
constexpr double kTolerable = 0.03;      // weight of all tolerable places of a category together; the usual ones have 1
constexpr double kUnspokenScore = 0.02;  // share of a state that nobody spoke of

/// Whether a rule says that nobody finds such a thing there before a task: food is in an oven only while it is cooked.
bool is_never_found(const CommonSense& sense, const Thing& thing, const Role& place) {
  return sense.found(thing, place).grade == Grade::Senseless;
}

/// Whether two lists of rules have one in common.
bool have_one_in_common(const std::vector<std::size_t>& some, const std::vector<std::size_t>& more) {
  return std::find_first_of(some.begin(), some.end(), more.begin(), more.end()) != some.end();
}

}  // namespace

Household::Household(const Knowledge& knowledge, const CommonSense& sense, StartStates states, UseStates uses)
    : kinds_(sense.kinds()), states_(std::move(states)), uses_(std::move(uses)) {
  auto apart = sense.kept_apart();
  std::erase_if(
      apart, [this](const auto& pair) { return kinds_.is_a(pair.first, "food") && kinds_.is_a(pair.second, "food"); });
  const UsualPlaces usual(knowledge, sense);
  std::set<std::string> room_types;
  for (const Category& category : knowledge.categories())
    room_types.insert(category.rooms.begin(), category.rooms.end());
  const auto thing_of = [&](const Category& category) {
    return Thing{std::string(kind_of(category.name)), category.display, category.materials};
  };
  for (const Category& category : knowledge.categories()) {
    if (const auto* fact = sense.kind_of(knowledge.simulator(), category.name)) {
      kind_[category.name] = fact->kind;
      for (std::size_t rule = 0; rule < apart.size(); ++rule) {
        if (kinds_.is_a(fact->kind, apart[rule].first)) apart_[category.name].first.push_back(rule);
        if (kinds_.is_a(fact->kind, apart[rule].second)) apart_[category.name].second.push_back(rule);
      }
      if (sense.used_for(fact->kind, PlaceUse::PutAway)) put_away_.insert(category.name);
      if (sense.used_for(fact->kind, PlaceUse::OwnRooms)) own_rooms_.insert(category.name);
      if (sense.used_for(fact->kind, PlaceUse::DirtyOrNot)) washing_.insert(category.name);
      if (sense.used_for(fact->kind, PlaceUse::Passing)) passing_.insert(category.name);
      if (sense.used_for(fact->kind, PlaceUse::Storage) || kinds_.is_a(fact->kind, "storage_box") ||
          kinds_.is_a(fact->kind, "bag"))
        storing_.insert(category.name);
      if (category.movable) stored_apart_[category.name] = sense.stored_apart(thing_of(category));
    }
    if (!category.movable) continue;
    found_in_[category.name].insert(category.rooms.begin(), category.rooms.end());
    const auto suit = [&](const std::string& key, const Thing& thing) {
      auto& suits = rooms_[key];
      for (const auto& type : room_types) {
        const auto graded = sense.grade(thing, "in_room:" + type);
        suits[type] = graded.grade == Grade::Senseless ? 0 : graded.score * graded.score;
      }
    };
    const auto lies = [&](const std::string& key, const Thing& thing) {
      const Sense lying = sense.grade(thing, "on:floor");
      const bool toy = kinds_.is_a(thing.kind, "toy") && !kinds_.is_a(thing.kind, "game");
      on_floor_[key] = lying.grade == Grade::Usual || (toy && lying.grade != Grade::Senseless) ? lying.score : 0;
    };
    if (!kind_of(category.name).empty() && sense.has_rule_on_name(category.display)) {
      suit(category.name, thing_of(category));
      lies(category.name, thing_of(category));
    }
    if (const auto kind = kind_of(category.name); !kind.empty() && !rooms_.contains(kind)) {
      suit(std::string(kind), {std::string(kind), {}, {}});
      lies(std::string(kind), {std::string(kind), {}, {}});
    }
    const auto& all = usual.of(category.name);
    if (all.empty()) continue;
    auto& places = places_[category.name];
    for (const UsualPlace& place : all) {
      const auto& receptacle = place.placement->receptacle;
      const auto* at = sense.kind_of(knowledge.simulator(), receptacle);
      const Thing thing = thing_of(category);
      if (at != nullptr && is_never_found(sense, thing, role_of(place.placement->relation, at->kind, kinds_))) continue;
      const double time = at != nullptr && sense.used_for(at->kind, PlaceUse::Passing) ? kInPassing : 1;
      const bool is_usual = place.grade == Grade::Usual;
      const double weight = place.weight * (is_usual ? 1 : kTolerable) * time;
      places.push_back({place.placement->relation, receptacle, weight, is_usual});
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return std::tie(a.receptacle, a.relation) < std::tie(b.receptacle, b.relation);
    });
  }
  for (const Category& category : knowledge.categories()) {
    // Few names are generic, and comparing all categories with all would take a second.
    if (!sense.has_rule_on_name(category.display)) continue;
    const Thing name = thing_of(category);
    for (const Category& other : knowledge.categories())
      if (other.movable == category.movable && sense.may_mean(name, thing_of(other)))
        covered_by_name_[category.name].insert(other.name);
  }
}

bool Household::may_mean(std::string_view name, const std::string& other) const {
  const auto found = covered_by_name_.find(name);
  return found != covered_by_name_.end() && found->second.contains(other);
}

const std::vector<Household::Place>& Household::places_of(std::string_view category) const {
  static const std::vector<Place> kNone;
  const auto found = places_.find(category);
  return found == places_.end() ? kNone : found->second;
}

const Household::Place* Household::place(std::string_view category, Predicate relation,
                                         std::string_view receptacle) const {
  const auto& all = places_of(category);
  const auto found =
      std::lower_bound(all.begin(), all.end(), std::tie(receptacle, relation), [](const Place& place, const auto& key) {
        return std::tuple(std::string_view(place.receptacle), place.relation) < key;
      });
  return found != all.end() && found->receptacle == receptacle && found->relation == relation ? &*found : nullptr;
}

double Household::in_room(std::string_view category, std::string_view room) const {
  auto kind = rooms_.find(category);
  if (kind == rooms_.end()) kind = rooms_.find(kind_of(category));
  if (kind == rooms_.end()) return 1;
  const auto suits = kind->second.find(room);
  return suits == kind->second.end() ? 1 : suits->second;
}

bool Household::is_usual_in(std::string_view category, std::string_view room) const {
  return in_room(category, room) >= kUsualRoom;
}

bool Household::is_found_in(std::string_view category, std::string_view room) const {
  const auto rooms = found_in_.find(category);
  return rooms == found_in_.end() || rooms->second.contains(room);
}

bool Household::keeps(std::string_view category, std::string_view receptacle, std::string_view room) const {
  const bool own_room = put_away_.contains(receptacle) || own_rooms_.contains(receptacle);
  return own_room ? is_usual_in(category, room) : in_room(category, room) >= kNoRoom;
}

bool Household::has_several(std::string_view category) const {
  const auto lineage = kinds_.lineage(kind_of(category));
  return std::any_of(lineage.begin(), lineage.end(), [](const Kind* kind) { return kind->several; });
}

bool Household::is_personal(std::string_view category) const {
  const auto lineage = kinds_.lineage(kind_of(category));
  return std::any_of(lineage.begin(), lineage.end(), [](const Kind* kind) { return kind->personal; });
}

double Household::on_floor(std::string_view category) const {
  auto found = on_floor_.find(category);
  if (found == on_floor_.end()) found = on_floor_.find(kind_of(category));
  return found == on_floor_.end() ? 0 : found->second;
}

std::string_view Household::kind_of(std::string_view category) const {
  const auto found = kind_.find(category);
  return found == kind_.end() ? std::string_view() : std::string_view(found->second);
}

bool Household::stored_apart(std::string_view a, std::string_view b, Predicate relation,
                             std::string_view receptacle) const {
  if (relation != Predicate::Inside || !storing_.contains(receptacle)) return false;
  const auto one = stored_apart_.find(a), other = stored_apart_.find(b);
  if (one == stored_apart_.end() || other == stored_apart_.end()) return false;
  return have_one_in_common(one->second.one, other->second.other) ||
         have_one_in_common(one->second.other, other->second.one);
}

bool Household::clash(std::string_view a, std::string_view b) const {
  const auto one = apart_.find(a), other = apart_.find(b);
  if (one == apart_.end() || other == apart_.end()) return false;
  return have_one_in_common(one->second.first, other->second.second) ||
         have_one_in_common(one->second.second, other->second.first);
}

std::vector<Predicate> Household::states_in_use(std::string_view category, const Role& use) const {
  return uses_.of(kind_of(category), use, kinds_);
}

Role Household::role_at(Predicate relation, std::string_view receptacle) const {
  const auto kind = kind_of(receptacle);
  return kind.empty() ? Role() : role_of(relation, std::string(kind), kinds_);
}

std::vector<LikelyState> Household::states_of(std::string_view category, Predicate relation,
                                              std::string_view receptacle) const {
  return states_.of(kind_of(category), role_at(relation, receptacle));
}

double Household::share(std::string_view category, Predicate relation, std::string_view receptacle,
                        const State& state) const {
  return states_.share(kind_of(category), role_at(relation, receptacle), state).value_or(kUnspokenScore);
}

Result<Household> read_household(const std::filesystem::path& sense, const Knowledge& knowledge) {
  std::vector<Error> errors;
  const auto common = read_common_sense(sense, errors);
  auto states = read_start_states(sense / "start_states.csv", common.kinds(), errors);
  auto uses = read_use_states(sense / "use_states.csv", common.kinds(), errors);
  if (!errors.empty()) return errors.front();
  return Household(knowledge, common, std::move(states), std::move(uses));
}

}  // namespace unietp
