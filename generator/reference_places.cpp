#include <algorithm>

#include "generator/reference.h"
#include "generator/refinement.h"
#include "logic/evaluate.h"
#include "sense/place_uses.h"
#include "templates/init_shape.h"

namespace unietp {
namespace {

constexpr std::size_t kMostLandmarks = 4;

std::string fresh_variable(const Specification& plain) {
  auto taken = bound_variables(plain.goal);
  for (const auto& start : plain.init) {
    for (auto& name : bound_variables(start)) taken.push_back(std::move(name));
  }
  std::string name = "p";
  for (int i = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++i)
    name = std::string("p").append(std::to_string(i));
  return name;
}

/// Where an object is found, before anything is done, belongs to the reference alone.
bool start_needs_place(const Specification& plain, const std::string& category) {
  return std::any_of(plain.init.begin(), plain.init.end(), [&](const Formula& start) {
    if (!concerns(start, category)) return false;
    const auto literals = start_literals(start);
    return std::any_of(literals.begin(), literals.end(),
                       [](const StartLiteral& l) { return l.positive && l.relation; });
  });
}

class Landmarks {
 public:
  Landmarks(const GoalVariable& variable, const Specification& plain, const Knowledge& knowledge,
            const SceneOffer& offer)
      : variable_(variable), knowledge_(knowledge), offer_(offer), other_(fresh_variable(plain)) {
    named_ = categories_of(plain.goal);
    for (const auto& [placeholder, category] : plain.binding) named_.push_back(category);
    for (const auto& start : plain.init) {
      for (auto& name : categories_of(start)) named_.push_back(std::move(name));
    }
  }

  /// Places where such a thing is likely to be, the likelier the sooner; and things that it stands beside.
  std::vector<Reference> by_relation(bool movable, Rng& rng) const {
    std::vector<Reference> found;
    for (const auto relation : {Predicate::On, Predicate::Inside, Predicate::NextTo}) {
      std::vector<const Placement*> rows;
      std::vector<double> weights;
      for (const auto* row : knowledge_.placements_of(variable_.category, relation)) {
        const auto* other = knowledge_.find(row->receptacle);
        if (other == nullptr || row->likelihood <= 0 || !usable(row->receptacle)) continue;
        // Nothing is told from others by being where it is only while it is heated or washed.
        if (relation == Predicate::Inside && offer_.uses != nullptr &&
            offer_.uses->has(other->kinds, PlaceUse::Passing))
          continue;
        // A landmark stays where it is: furniture, or what a thing of the task is set down beside.
        if (movable && other->movable != (relation == Predicate::NextTo)) continue;
        // "Next to the kettle" says which, "next to a plum" does not.
        if (other->movable && !offer_.now.states.empty() && number_of(offer_, row->receptacle) != 1) continue;
        rows.push_back(row);
        // "In the fridge" says where; "in one of the cupboards" hardly does.
        weights.push_back(row->likelihood / std::max(1, number_of(offer_, row->receptacle)));
      }
      for (std::size_t drawn = 0; drawn < kMostLandmarks && !rows.empty(); ++drawn) {
        const auto at = rng.weighted(weights);
        found.push_back(related(relation, rows[at]->receptacle, Referring::ByRelation));
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(at));
        weights.erase(weights.begin() + static_cast<std::ptrdiff_t>(at));
      }
    }
    return found;
  }

  std::vector<Reference> by_room(const Category& category) const {
    std::vector<Reference> found;
    const auto rooms = offer_.now.states.empty() ? category.rooms : single_rooms(offer_);
    for (const auto& room : rooms) {
      const bool usual = std::find(category.rooms.begin(), category.rooms.end(), room) != category.rooms.end();
      if ((category.movable && !usual) || is_named(room)) continue;
      found.push_back(related(Predicate::InRoom, room, Referring::ByRoom));
      found.back().start.push_back(only_one(room));
    }
    return found;
  }

  std::vector<Reference> by_nearness() const {
    std::vector<Reference> found;
    for (const auto& landmark : single_objects(offer_)) {
      const auto* category = knowledge_.find(landmark);
      if (category == nullptr || category->movable || !category->countable || is_named(landmark)) continue;
      if (!have_a_room_in_common(*category) || !is_near_in_a_room(landmark)) continue;
      found.push_back(related(Predicate::Nearest, landmark, Referring::ByNearness));
      found.back().start.push_back(only_one(landmark));
    }
    return found;
  }

 private:
  bool is_named(const std::string& category) const {
    return category == variable_.category || std::find(named_.begin(), named_.end(), category) != named_.end();
  }
  bool usable(const std::string& category) const {
    return !is_named(category) && (offer_.now.states.empty() || number_of(offer_, category) > 0);
  }
  /// Whether such things and the landmark are usual in one type of room: nobody looks for clothes near an oven.
  bool have_a_room_in_common(const Category& landmark) const {
    const auto& rooms = knowledge_.find(variable_.category)->rooms;
    return std::any_of(rooms.begin(), rooms.end(), [&](const std::string& room) {
      return std::find(landmark.rooms.begin(), landmark.rooms.end(), room) != landmark.rooms.end();
    });
  }
  /// Whether the nearest of the things is in the landmark's room now, and not on or in it: what is near through a wall
  /// is not near to people, and what is on the counter is not said to be near it.
  bool is_near_in_a_room(const std::string& landmark) const {
    if (offer_.now.states.empty()) return true;
    const std::string room = other_ + "_room";
    Domain any_room;
    any_room.kind = Domain::Kind::Room;
    const Formula together = exists(
        room, any_room,
        conjunction({atom(Predicate::InRoom, {variable_.variable, room}), atom(Predicate::InRoom, {other_, room})}));
    const Formula near = exists(other_, of_category(landmark),
                                conjunction({atom(Predicate::Nearest, {variable_.variable, other_}), together,
                                             negation(atom(Predicate::On, {variable_.variable, other_})),
                                             negation(atom(Predicate::Inside, {variable_.variable, other_}))}));
    return holds_in(exists(variable_.variable, of_category(variable_.category), near), offer_.now, 0);
  }
  Reference related(Predicate relation, const std::string& other, Referring kind) const {
    return {kind, exists(other_, of_category(other), atom(relation, {variable_.variable, other_})), {}};
  }
  Formula only_one(const std::string& category) const {
    return counted({other_, category, Formula::Op::Exists, 1}, Comparison::Equal, 1, Formula{});
  }

  const GoalVariable& variable_;
  const Knowledge& knowledge_;
  const SceneOffer& offer_;
  std::string other_;
  std::vector<std::string> named_;
};

}  // namespace

std::vector<Reference> references_to_others(Referring kind, const GoalVariable& variable, const Specification& plain,
                                            const Knowledge& knowledge, const SceneOffer& offer, Rng rng) {
  const auto* category = knowledge.find(variable.category);
  if (category == nullptr || start_needs_place(plain, variable.category)) return {};
  const Landmarks landmarks(variable, plain, knowledge, offer);
  if (kind == Referring::ByRelation) return landmarks.by_relation(category->movable, rng);
  if (kind == Referring::ByRoom) return landmarks.by_room(*category);
  if (kind == Referring::ByNearness) return landmarks.by_nearness();
  return {};
}

}  // namespace unietp
