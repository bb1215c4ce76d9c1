#pragma once

#include <algorithm>
#include <array>
#include <tuple>

#include "symbolic/perform.h"
#include "tests/generator/naive_scene.h"

namespace unietp {

inline constexpr std::array kOtherRooms = {"hall", "attic"};  // that no specification names

/// One attempt.
class NaiveDraw {
  using Id = symbolic::Id;
  using Goal = symbolic::Goal;
  using PlaceKind = symbolic::PlaceKind;
  using KindId = symbolic::KindId;
  static constexpr Id kNobody = symbolic::kNobody;
  static constexpr int kRepairs = 1500;

 public:
  NaiveDraw(const NaiveScenes& scenes, Rng& rng) : scenes_(scenes), rng_(rng) {
    auto& setting = scene_.setting;
    setting.rules = &scenes.rules_;
    setting.with_nearest = scenes.with_nearest_;
    for (const auto& type : scenes.room_types_) setting.objects.rooms.push_back({type + "_1", type});
    for (std::size_t k = 0; k < scenes.categories_.size(); ++k) {
      const bool movable = scenes.rules_.kind(KindId(k)).movable;
      const int least = std::max(scenes.demanded_[k], 1);
      const auto drawn = least + static_cast<int>(rng_.below(movable ? 4 : 2));
      const auto number = std::max(scenes.demanded_[k], std::min(drawn, scenes.limits_[k]));
      for (int n = 0; n < number; ++n) add(KindId(k), n);
    }
    furnish_rooms();
    for (std::size_t i = 0; i < scene_.start.things.size(); ++i) move(Id::thing(i));
    for (const auto& [id, room] : for_rooms_) {
      scene_.start[id].where = PlaceKind::Floor;
      scene_.start[id].at = Id::room(room);
    }
    scene_.start.room = random_room();
  }

  bool repair() {
    std::vector<Goal> constraints;
    read(constraints);
    for (int i = 0; i < kRepairs; ++i) {
      come_to_rest();
      const auto broken = std::find_if(constraints.begin(), constraints.end(), [&](const Goal& goal) {
        return !holds(goal, goal.root(), scene_.setting, scene_.start, symbolic::Progress(goal));
      });
      if (broken == constraints.end()) return true;
      const auto& constraint = scenes_.constraints_[static_cast<std::size_t>(broken - constraints.begin())];
      if (constraint.atoms.empty()) return false;  // too many or too few of something
      if (redraw(constraint)) read(constraints);
    }
    return false;
  }

  NaiveScene take() {
    add_pieces(scene_.setting, scene_.start);
    return std::move(scene_);
  }

 private:
  const symbolic::Kind& kind(Id id) const { return scene_.setting.kind_of(id); }
  const symbolic::Kind& kind_numbered(KindId number) const { return scenes_.rules_.kind(number); }
  Id random_room() { return Id::room(rng_.below(scenes_.room_types_.size())); }

  void read(std::vector<Goal>& constraints) {
    constraints.clear();
    for (const auto& one : scenes_.constraints_) constraints.emplace_back(*one.formula, scene_.setting, scene_.start);
  }

  /// What is done to things where they are, without anybody's doing, has been done.
  void come_to_rest() {
    for (std::size_t i = 0; i < scene_.start.things.size(); ++i) {
      const auto& thing = scene_.start.things[i];
      const bool lies = thing.where == PlaceKind::On || thing.where == PlaceKind::Inside;
      if (lies) run_processes(scene_.setting, scene_.start, thing.at, false);
    }
  }

  void add(KindId kind_number, int n) {
    const auto& about = scenes_.rules_.kind(kind_number);
    symbolic::ObjectEntry role;
    role.id = about.category + "_" + std::to_string(n + 1);
    role.kind = kind_number;
    role.spot_m = rng_.unit() * 30;
    dress(role, about);
    scene_.setting.objects.things.push_back(role);
    scene_.start.things.push_back(symbolic::default_thing(about));
    const auto id = Id::thing(scene_.start.things.size() - 1);
    scene_.start[id].at = random_room();
    for (const auto* group : about.groups) draw_state(id, *group);
    if (about.coverable) draw_coat(id);
  }

  /// Furniture that the goal does not speak of in each room, and so much of it that all of a kind that the goal speaks
  /// of could be put down there.
  void furnish_rooms() {
    for (std::size_t k = scenes_.named_; k < scenes_.categories_.size(); ++k) {
      if (scenes_.rules_.kind(KindId(k)).movable) continue;
      for (std::size_t r = 0; r + kOtherRooms.size() < scenes_.room_types_.size(); ++r) {
        add(KindId(k), 10 + static_cast<int>(r));
        for_rooms_.emplace_back(Id::thing(scene_.start.things.size() - 1), r);
      }
    }
    for (std::size_t k = 0; k < scenes_.named_; ++k) make_room_for(KindId(k));
  }

  void make_room_for(KindId movable) {
    if (!scenes_.rules_.kind(movable).movable) return;
    int number = 0, room = 0;
    std::optional<KindId> spacious;
    const auto space = [&](KindId place) { return scenes_.rules_.capacity(movable, Predicate::On, place); };
    for (const auto& role : scene_.setting.objects.things) {
      number += role.kind == movable ? 1 : 0;
      if (role.kind.index() < scenes_.named_ || kind_numbered(role.kind).movable) continue;
      room += space(role.kind);
      if (space(role.kind) > 0 && (!spacious || space(role.kind) > space(*spacious))) spacious = role.kind;
    }
    for (int n = 20; spacious && room < number; ++n, room += space(*spacious)) add(*spacious, n);
  }

  void dress(symbolic::ObjectEntry& role, const symbolic::Kind& about) {
    if (!about.colors.empty()) role.color = rng_.pick(about.colors);
    if (!about.materials.empty()) role.material = rng_.pick(about.materials);
    role.size = rng_.chance(0.5) ? "small" : "large";
  }

  void draw_state(Id id, const StateGroup& group) {
    auto& thing = scene_.start[id];
    thing.set(rng_.pick(group.predicates));
    thing.filling = symbolic::SubstanceId(rng_.below(scenes_.rules_.symbols().size()));
    if (!thing.has(Predicate::Filled)) thing.filling = {};
  }

  void draw_coat(Id id) {
    if (scenes_.coats_.empty()) return;
    auto& coats = scene_.start[id].coats;
    const bool covered = rng_.below(2) == 1;
    const auto coat = rng_.pick(scenes_.coats_);
    coats.clear();
    if (covered) coats.insert(coat);
  }

  void move(Id id) {
    auto& thing = scene_.start[id];
    for (auto& other : scene_.start.things) {
      if (other.beside == id) other.beside = kNobody;
    }
    thing.beside = kNobody;
    thing.under = false;
    thing.where = PlaceKind::Floor;
    thing.at = random_room();
    std::vector<std::pair<PlaceKind, Id>> places;
    for (std::size_t i = 0; i < scene_.start.things.size(); ++i) {
      const auto place = Id::thing(i);
      if (place == id || rests_on(scene_.start, place, id)) continue;
      if (may_stand(id, Predicate::On, place)) places.emplace_back(PlaceKind::On, place);
      if (may_stand(id, Predicate::Inside, place)) places.emplace_back(PlaceKind::Inside, place);
    }
    if (places.empty() || (may_stand_on_floor(id) && rng_.chance(0.15))) return;
    std::tie(thing.where, thing.at) = rng_.pick(places);
  }

  /// What cannot be carried stands where that can be put which the goal wants beside it.
  bool may_stand(Id id, Predicate relation, Id place) const {
    const auto own = scene_.setting.kind_number(id), host = scene_.setting.kind_number(place);
    return has_room(scene_.setting, scene_.start, id, relation, place) &&
           std::all_of(scenes_.visited_.begin(), scenes_.visited_.end(), [&](const auto& visit) {
             return visit.second != own || scenes_.rules_.capacity(visit.first, relation, host) > 0;
           });
  }

  bool may_stand_on_floor(Id id) const {
    const auto own = scene_.setting.kind_number(id);
    return scenes_.rules_.capabilities().has(ActionType::Drop) ||
           std::none_of(scenes_.visited_.begin(), scenes_.visited_.end(),
                        [&](const auto& visit) { return visit.second == own; });
  }

  void sit_beside(Id id, bool under) {
    move(id);
    const auto other = Id::thing(rng_.below(scene_.start.things.size()));
    auto& thing = scene_.start[id];
    const auto& host = scene_.start[other];
    const bool same = thing.where == host.where && thing.at == host.at;
    if (other == id || !same || (under && host.where != PlaceKind::Floor)) return;
    thing.beside = other;
    thing.under = under;
  }

  /// Draws something of one object anew; true when the constraints have to be read again.
  bool redraw(const NaiveScenes::Constraint& broken) {
    const auto& atom = rng_.pick(broken.atoms);
    if (atom.terms[0].kind == Term::Kind::Agent) {
      scene_.start.room = random_room();
      return false;
    }
    std::vector<Id> concerned;
    for (std::size_t i = 0; i < scene_.start.things.size(); ++i) {
      const auto id = Id::thing(i);
      const auto& kinds = broken.kinds;
      if (std::find(kinds.begin(), kinds.end(), scene_.setting.kind_number(id)) != kinds.end()) concerned.push_back(id);
    }
    if (concerned.empty()) return false;
    const Id id = rng_.pick(concerned);
    switch (atom.predicate) {
      case Predicate::Covered:
        draw_coat(id);
        return false;
      case Predicate::Color:
      case Predicate::Material:
      case Predicate::Size:
        dress(scene_.setting.objects.object(id), kind(id));
        return true;
      case Predicate::Nearest:
        move(id);
        scene_.setting.objects.object(root_of(scene_.start, id)).spot_m = rng_.unit() * 30;
        return false;
      case Predicate::NextTo:
      case Predicate::Under:
        sit_beside(id, atom.predicate == Predicate::Under);
        return false;
      case Predicate::On:
      case Predicate::Inside:
      case Predicate::InRoom:
      case Predicate::OnFloor:
        move(id);
        return false;
      default:
        if (rng_.chance(0.3)) move(id);  // it may be so because of where it is
        for (const auto* group : kind(id).groups) {
          const auto& states = group->predicates;
          if (std::find(states.begin(), states.end(), atom.predicate) != states.end()) draw_state(id, *group);
        }
        return false;
    }
  }

  const NaiveScenes& scenes_;
  Rng& rng_;
  NaiveScene scene_;
  std::vector<std::pair<Id, std::size_t>> for_rooms_;
};

}  // namespace unietp
