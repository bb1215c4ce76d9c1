#include "expert/search_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "core/text.h"

namespace unietp {
namespace {

// What is left of a chance after so many looks, each from another angle.
constexpr std::array kLeftOfFurniture{1.0, 0.12, 0.08, 0.05, 0.02, 0.0};
constexpr std::array kLeftOfRoom{1.0, 0.75, 0.5, 0.25, 0.0, 0.0};
constexpr double kGlimpsed = 0.4;  // of what is on something that was in view from elsewhere, or in what was opened so
constexpr double kElsewhere = 0.02;  // of the chance of a place that the goal does not name, where it names others
constexpr double kOddRoom = 0.1;     // of the chance in a room that the knowledge base does not name
constexpr double kOdd = 1e-4;        // chance of a place where such things are not known to be
constexpr double kOnFloor = 1e-3;    // of a room
constexpr double kLiesAbout = 0.1;   // times how usual it is that such a thing is on the floor
constexpr double kOnUnseen = 0.5;    // chance of a room whose furniture is not known, where such things usually are
constexpr double kAnother = 0.3;     // of the chance that there is such furniture, where some is known
constexpr double kLeaving = 2.5;     // steps that leaving a room counts for, since it will hardly be all looked at
constexpr double kInPicture = 0.5;   // quarter turns to the edge of the picture
constexpr double kLeast = 1e-9;
constexpr double kBeside_m = 3;
constexpr double kQuarter_deg = 90;  // from one view of a room to the next
constexpr double kPerMeter = 0.05;   // steps that a meter of way counts for

double left_after(const std::array<double, 6>& left, int looks) {
  return left[std::min<std::size_t>(static_cast<std::size_t>(looks), left.size() - 1)];
}

}  // namespace

SearchOrder::SearchOrder(const Scene& known_scene, const Knowledge& knowledge, const Household* usual,
                         std::set<std::string> shut, const Profile& profile)
    : knowledge_(knowledge),
      usual_(usual),
      shut_(std::move(shut)),
      views_(known_scene, profile),
      turns_(std::max(1.0, std::round(kQuarter_deg / profile.turn_deg))),
      knows_furniture_(!known_scene.nodes.empty()) {
  for (const Node& node : known_scene.nodes) add(furniture(node, known_scene));
  for (const Room& room : known_scene.rooms) {
    Place place{room.id, "", room.type};
    place.room = static_cast<std::size_t>(&room - known_scene.rooms.data());
    for (const Vec2& corner : room.polygon) place.position += corner / static_cast<double>(room.polygon.size());
    add(std::move(place));
  }
}

SearchOrder::Place SearchOrder::furniture(const Node& node, const Scene& known_scene) {
  Place place{node.id, node.category};
  place.position = node.pose.position.head<2>();
  if (const Room* room = room_at(known_scene, place.position)) place.room_type = room->type;
  return place;
}

void SearchOrder::add(Place place) {
  if (!place.category.empty()) ++of_category_[place.category];
  place_of_[place.id] = places_.size();
  places_.push_back(std::move(place));
}

SearchOrder::Place* SearchOrder::find(const std::string& id) {
  const auto found = place_of_.find(id);
  return found == place_of_.end() ? nullptr : &places_[found->second];
}

double SearchOrder::suits(const std::string& category, const std::string& room_type) const {
  const Category* known = knowledge_.find(category);
  return known == nullptr || known->rooms.empty() || holds(known->rooms, room_type) ? 1 : kOddRoom;
}

SearchOrder::Chance SearchOrder::chance_unseen(const SearchTarget& target, const Place& room) const {
  double best = 0;
  const Category* category = knowledge_.find(target.category);
  const auto offer = [&](const std::string& furniture) {
    const auto known = of_category_.find(furniture);
    best = std::max(best, suits(furniture, room.room_type) * (known == of_category_.end() ? 1 : kAnother));
  };
  if (category != nullptr && !category->movable) {
    offer(target.category);
  } else if (target.floor) {
    best = 1;
  } else if (!target.places.empty() || !target.near.empty()) {
    for (const std::string& furniture : target.places) offer(furniture);
    for (const std::string& furniture : target.near) offer(furniture);
  } else {
    best = kOnUnseen * (usual_ == nullptr ? suits(target.category, room.room_type)
                                          : usual_->in_room(target.category, room.room_type));
  }
  const bool fits = target.rooms.empty() || holds(target.rooms, room.room_type);
  return {best * (fits ? 1 : kElsewhere), 0};
}

SearchOrder::Chance SearchOrder::chance(const SearchTarget& target, const Place& place) const {
  if (place.category.empty() && !knows_furniture_) return chance_unseen(target, place);
  const bool fits = target.rooms.empty() || holds(target.rooms, place.room_type);
  const double suits = usual_ == nullptr ? 1 : usual_->in_room(target.category, place.room_type);
  if (place.category.empty()) {
    if (target.floor) return {fits ? 1.0 : 0.0, 0};
    const double lies = usual_ == nullptr ? 0 : kLiesAbout * usual_->on_floor(target.category);
    return {(kOnFloor + lies) * (fits ? 1 : kElsewhere) * (target.places.empty() ? suits : kElsewhere), 0};
  }
  const auto number = static_cast<double>(of_category_.find(place.category)->second);
  const auto of = [&](Predicate relation) {
    const Placement* known = knowledge_.placement(target.category, relation, place.category);
    if (usual_ != nullptr) {
      if (const auto* there = usual_->place(target.category, relation, place.category)) return there->weight * suits;
      return known == nullptr ? 0.0 : kOdd;
    }
    if (known == nullptr) return 0.0;
    const Category* category = knowledge_.find(target.category);
    return known->likelihood * (category->rooms.empty() || holds(category->rooms, place.room_type) ? 1 : kOddRoom);
  };
  Chance chance{of(Predicate::On) / number, of(Predicate::Inside) / number};
  if (holds(target.near, place.category)) chance.on += 1;
  double factor = fits ? 1 : kElsewhere;
  if (target.floor) factor *= kElsewhere;
  if (holds(target.places, place.category)) {
    chance.on += 1;
    chance.inside += 1;
  } else if (!target.places.empty()) {
    factor *= kElsewhere;
  }
  return {chance.on * factor, chance.inside * factor};
}

const SearchOrder::Chances& SearchOrder::chances(const SearchTarget& target) const {
  const auto known =
      std::find_if(chances_.begin(), chances_.end(), [&](const Chances& chances) { return chances.target == target; });
  if (known != chances_.end()) return *known;
  Chances& made = chances_.emplace_back(Chances{target, {}});
  for (const Place& place : places_) made.at.push_back(chance(target, place));
  return made;
}

SearchOrder::Chance SearchOrder::chance(const Chances& chances, std::size_t place, const Belief& belief) const {
  if (places_[place].category == chances.target.category && !belief.has_seen(places_[place].id)) return {1, 0};
  return chances.at[place];
}

bool SearchOrder::is_shut(const Place& place, const Belief& belief) {
  const Node* node = belief.find(place.id);
  return node != nullptr && node->openable && !node->states.has(Predicate::Open);
}

double SearchOrder::left_on(const Place& place, int looks) const {
  if (place.given_up) return 0;
  if (place.category.empty() && !knows_furniture_) return views_.unseen(place.room);
  if (place.category.empty()) return left_after(kLeftOfRoom, looks);
  return looks == 0 && place.glimpsed ? kGlimpsed : left_after(kLeftOfFurniture, looks);
}

double SearchOrder::left_inside(const Place& place, bool shut, int looks) const {
  if (place.given_up) return 0;
  if (shut && (place.stays_shut || shut_.contains(place.category))) return 0;
  return looks == 0 && place.peeked_into ? kGlimpsed : left_after(kLeftOfFurniture, looks);
}

double SearchOrder::turns_to_see(const Place& place, const Scene& believed) const {
  if (knows_furniture_ || place.category.empty()) return 0;
  const Agent& agent = believed.agent;
  const Room* room = room_at(believed, agent.position);
  if (room == nullptr || room->type != place.room_type) return 1 + turns_;
  const Vec2 ahead(std::cos(agent.yaw), std::sin(agent.yaw)), way = place.position - agent.position;
  const double aside = std::abs(std::atan2(ahead.x() * way.y() - ahead.y() * way.x(), ahead.dot(way)));
  return std::max(0.0, turns_ * (aside / (std::numbers::pi / 2) - kInPicture));
}

std::string names_of(const std::vector<SearchTarget>& targets) {
  std::vector<std::string> names;
  for (const SearchTarget& target : targets) names.push_back(target.category);
  return join(names, ", ");
}

std::optional<SearchOrder::Look> SearchOrder::next(const std::vector<SearchTarget>& targets, const Belief& belief,
                                                   std::string_view at, const InReach& in_reach) const {
  const Agent& agent = belief.scene().agent;
  std::optional<Look> best;
  double most = kLeast;
  const auto offer = [&](const Place& place, double gain, double cost, bool opens, bool from_here = false) {
    if (gain / cost <= most) return;
    most = gain / cost;
    best = Look{place.id, opens, place.looks, place.category.empty(), from_here};
  };
  std::vector<const Chances*> sought;
  for (const SearchTarget& target : targets) sought.push_back(&chances(target));
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    Chance all;
    for (const Chances* target : sought) {
      const Chance one = chance(*target, i, belief);
      all.on += one.on;
      all.inside += one.inside;
    }
    if (all.on + all.inside <= kLeast || place.given_up) continue;
    if (place.category.empty() && !knows_furniture_) {
      const auto view = views_.best(place.room, agent);
      if (!view) continue;
      const bool leaves = view->goes && room_at(belief.scene(), agent.position) != &belief.scene().rooms[place.room];
      const double far = view->goes ? kPerMeter * (place.position - agent.position).norm() : 0;
      offer(place, all.on * view->shows, view->steps() + far + (leaves ? kLeaving : 0), false);
      if (best && best->id == place.id) best->view = *view;
      continue;
    }
    const bool shut = is_shut(place, belief);
    const bool here = place.id == at && place.looks == 1;
    const double way =
        here ? 0 : 1 + kPerMeter * (place.position - agent.position).norm() + turns_to_see(place, belief.scene());
    const double on = all.on * (left_on(place, place.looks) - left_on(place, place.looks + 1));
    const double inside_now = shut ? 0
                                   : all.inside * (left_inside(place, false, place.looks_inside) -
                                                   left_inside(place, false, place.looks_inside + 1));
    const double turned = place.looks == 0 ? 0 : place.category.empty() ? turns_ : 1;
    offer(place, on + inside_now, way + turned, false);
    if (!shut) continue;
    const double left = left_inside(place, true, place.looks_inside);
    if (left <= 0) continue;
    const double opened = all.inside * (left - left_inside(place, false, place.looks_inside + 1));
    offer(place, (place.looks == 0 ? on : 0) + opened, way + 1, true);
    const double peeked = all.inside * (left - kGlimpsed);
    if (peeked > most && in_reach(place.id)) offer(place, peeked, 1, true, true);
  }
  return best;
}

std::vector<std::string> SearchOrder::beside(const std::string& id) const {
  const auto found = place_of_.find(id);
  if (found == place_of_.end()) return {};
  const Place& middle = places_[found->second];
  std::vector<std::pair<double, std::string>> near;
  for (const Place& place : places_) {
    const double away = (place.position - middle.position).norm();
    if (place.id == id || place.category.empty() || place.given_up || away > kBeside_m) continue;
    near.emplace_back(away, place.id);
  }
  std::sort(near.begin(), near.end());
  std::vector<std::string> ids;
  for (auto& [away, other] : near) ids.push_back(std::move(other));
  return ids;
}

std::vector<Action> SearchOrder::way_to(const Look& look, std::string_view at) const {
  if (look.from_here) return {};
  const Action go{ActionType::GoTo, {look.id}};
  const bool here = at == look.id;
  if (look.room && !knows_furniture_) {
    const ActionType turn = look.view.turns > 0 ? ActionType::TurnLeft : ActionType::TurnRight;
    std::vector<Action> way(static_cast<std::size_t>(std::abs(look.view.turns)), {turn, {}});
    if (look.view.goes) way.insert(way.begin(), go);
    return way;
  }
  if (look.room && look.before > 0) {
    std::vector<Action> way(static_cast<std::size_t>(turns_), {ActionType::TurnLeft, {}});
    if (!here) way.insert(way.begin(), go);
    return way;
  }
  if (look.before == 1 && !look.opens)
    return here ? std::vector<Action>{{ActionType::LookDown, {}}} : std::vector{go, {ActionType::LookDown, {}}};
  if (look.before == 2 && !look.opens) return {go, {ActionType::LookUp, {}}};
  if (look.before >= 3 && !look.opens) {
    const auto others = beside(look.id);
    const auto other = static_cast<std::size_t>(look.before - 3);
    if (other < others.size()) return {{ActionType::GoTo, {others[other]}}, {ActionType::TurnTo, {look.id}}};
  }
  if (here) return {};
  return {go};
}

void SearchOrder::looked_at(const std::string& id, const Belief& belief) {
  Place* place = find(id);
  if (place == nullptr) return;
  ++place->looks;
  if (!is_shut(*place, belief)) ++place->looks_inside;
}

void SearchOrder::arrived(const std::string& id, const Vec2& position) {
  const Place* place = find(id);
  if (place != nullptr && place->category.empty()) views_.arrived(place->room, position);
}

void SearchOrder::peeked_into(const std::string& id) {
  if (Place* place = find(id)) place->peeked_into = true;
}

void SearchOrder::glimpsed(const Node& node, const Scene& known_scene) {
  if (!node.movable && !place_of_.contains(node.id)) {
    add(furniture(node, known_scene));
    chances_.clear();
  }
  if (Place* place = find(node.id)) place->glimpsed = true;
}

void SearchOrder::give_up(const std::string& id) {
  if (Place* place = find(id)) place->given_up = true;
}

void SearchOrder::keep_shut(const std::string& id) {
  if (Place* place = find(id)) place->stays_shut = true;
}

double SearchOrder::unseen_share(const SearchTarget& target, const Belief& belief) const {
  double all = 0, unseen = 0;
  const Chances& sought = chances(target);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    const Chance before = chance(sought, i, belief);
    all += before.on + before.inside;
    unseen += before.on * left_on(place, place.looks) +
              before.inside * left_inside(place, is_shut(place, belief), place.looks_inside);
  }
  return all <= kLeast ? 0 : unseen / all;
}

}  // namespace unietp
