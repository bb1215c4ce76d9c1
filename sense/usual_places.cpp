#include "sense/usual_places.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/text.h"

namespace unietp {
namespace {

Thing thing_of(const Category& category, Simulator simulator, const CommonSense& sense) {
  const auto* kind = sense.kind_of(simulator, category.name);
  return {kind == nullptr ? std::string() : kind->kind, category.display, category.materials};
}

Thing thing_of(const std::string& category, const Knowledge& knowledge, const CommonSense& sense) {
  const auto* known = knowledge.find(category);
  return known == nullptr ? Thing{} : thing_of(*known, knowledge.simulator(), sense);
}

Sense graded(const Thing& thing, Predicate relation, const Thing& place, const CommonSense& sense) {
  if (thing.kind.empty() || place.kind.empty())
    return {Grade::Tolerable, 0, {"a category has no kind"}, std::string(kUnspoken)};
  const bool held = relation == Predicate::On || relation == Predicate::Inside;
  if (held && !sense.special_places().may_hold(place.words, thing.kind, sense.kinds()))
    return {Grade::Senseless, 0, {"rule special-place: the place is made for other things"}, "rule:special-place"};
  auto own = sense.grade(thing, role_of(relation, place.kind, sense.kinds()));
  return relation == Predicate::NextTo ? worse_of(std::move(own), sense.together(thing, place)) : own;
}

/// What the grades of a thing depend on, whatever the place: kind, name where a rule speaks of it, materials.
using Traits = std::tuple<std::string, std::string, std::vector<std::string>>;
struct Answer {
  Grade grade = Grade::Tolerable;
  double score = 0;
};
/// A category, with the answers of all that have its traits.
struct Asked {
  Thing thing;
  std::map<Role, Answer>* answers = nullptr;
};

bool before(const UsualPlace& a, const UsualPlace& b) {
  const auto key = [](const UsualPlace& p) { return std::tuple(p.grade != Grade::Usual, -p.weight); };
  if (key(a) != key(b)) return key(a) < key(b);
  return std::tie(a.placement->receptacle, a.placement->relation) <
         std::tie(b.placement->receptacle, b.placement->relation);
}

}  // namespace

Role role_of(Predicate relation, const std::string& kind, const Kinds& kinds) {
  if (relation == Predicate::On || relation == Predicate::Inside)
    return kinds.place_role(relation == Predicate::On ? "on" : "in", kind);
  return (relation == Predicate::NextTo ? "next_to:" : "under:") + kind;
}

Sense grade_placement(const Placement& placement, const Knowledge& knowledge, const CommonSense& sense) {
  return graded(thing_of(placement.object, knowledge, sense), placement.relation,
                thing_of(placement.receptacle, knowledge, sense), sense);
}

bool is_absurd(const CommonSense& sense, Simulator simulator, const Category& object, Predicate relation,
               const Category& receptacle) {
  constexpr std::string_view kOutside = "outside";
  const auto thing = thing_of(object, simulator, sense), place = thing_of(receptacle, simulator, sense);
  const bool held = relation == Predicate::On || relation == Predicate::Inside;
  if (held && object.movable && !sense.special_places().may_hold(place.words, thing.kind, sense.kinds())) return true;
  const bool case_of_its_kind =
      relation == Predicate::Inside && thing.kind == place.kind;  // a plaster, a first-aid kit
  if (case_of_its_kind) return false;
  const auto own = graded(thing, relation, place, sense);
  const bool nobody_judged = object.movable && thing.kind == kOutside && own.why == kUnspoken;
  return own.grade == Grade::Senseless && !nobody_judged;
}

UsualPlaces::UsualPlaces(const Knowledge& knowledge, const CommonSense& sense) {
  std::map<Traits, std::map<Role, Answer>> answers;
  std::map<std::string, Asked, std::less<>> things;
  for (const auto& category : knowledge.categories()) {
    Asked asked{thing_of(category, knowledge.simulator(), sense)};
    const auto name = sense.has_rule_on_name(asked.thing.words) ? asked.thing.words : std::string();
    asked.answers = &answers[{asked.thing.kind, name, asked.thing.materials}];
    things.emplace(category.name, std::move(asked));
  }
  for (const auto& placement : knowledge.placements()) {
    if (placement.relation != Predicate::On && placement.relation != Predicate::Inside) continue;
    const auto& [thing, known] = things.find(placement.object)->second;
    const auto& place = things.find(placement.receptacle)->second.thing;
    if (thing.kind.empty() || place.kind.empty()) continue;
    const auto role = role_of(placement.relation, place.kind, sense.kinds());
    const auto [answer, first] = known->try_emplace(role);
    if (first) {
      const auto graded = sense.grade(thing, role);
      answer->second = {graded.grade, graded.score};
    }
    const auto& [grade, score] = answer->second;
    if (grade == Grade::Senseless) continue;
    places_[placement.object].push_back({&placement, grade, score * std::sqrt(placement.likelihood)});
  }
  for (auto& [category, places] : places_) {
    std::map<Grade, double> sum;
    for (const auto& place : places) sum[place.grade] += place.weight;
    for (auto& place : places) place.weight /= sum[place.grade];
    std::sort(places.begin(), places.end(), before);
  }
}

const std::vector<UsualPlace>& UsualPlaces::of(std::string_view category) const {
  static const std::vector<UsualPlace> kNone;
  const auto found = places_.find(category);
  return found == places_.end() ? kNone : found->second;
}

std::vector<UsualPlace> UsualPlaces::best_of(std::string_view category) const {
  const auto& all = of(category);
  const auto tolerable =
      std::find_if(all.begin(), all.end(), [](const UsualPlace& p) { return p.grade != Grade::Usual; });
  return tolerable == all.begin() ? all : std::vector<UsualPlace>(all.begin(), tolerable);
}

}  // namespace unietp
