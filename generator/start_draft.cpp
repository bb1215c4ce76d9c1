#include "generator/start_draft.h"

#include <algorithm>

#include "symbolic/perform.h"

namespace unietp {
namespace {

using symbolic::kNobody;
using symbolic::PlaceKind;

constexpr double kHoused = 0.6;   // share of objects on or in something, not on a floor
constexpr double kCovered = 0.3;  // of what can be covered
constexpr double kStray = 0.1;    // of the changes are blind, to leave dead ends

}  // namespace

StartDraft::StartDraft(const StartDemands& demands, Rng& rng) : demands_(demands), rng_(rng) {
  start_.setting.rules = &demands.rules;
  start_.setting.with_nearest = demands.with_nearest;
  for (const auto& type : demands.rooms) start_.setting.objects.rooms.push_back({type + "_1", type});
  start_.setting.objects.rooms.push_back({"elsewhere_1", "elsewhere"});
  world().room = Id::room(demands.rooms.size());
  add_things();
  read_constraints();
  find_broken();
}

void StartDraft::add_things() {
  auto& objects = start_.setting.objects;
  const auto& rules = demands_.rules;
  for (const auto& amount : demands_.amounts) {
    const auto& kind = rules.kind(amount.kind);
    const auto extra = static_cast<int>(rng_.below(static_cast<std::uint64_t>(amount.most - amount.least) + 1));
    for (int i = 0; i < amount.least + extra; ++i) {
      symbolic::ObjectEntry role;
      role.id = kind.category + "_" + std::to_string(i + 1);
      role.kind = amount.kind;
      role.spot_m = rng_.unit() * kHomeLength_m;
      objects.things.push_back(std::move(role));
      world().things.emplace_back();
      const auto id = Id::thing(world().things.size() - 1);
      draw_states(id);
      world()[id].at = random_room();
    }
  }
  for (std::size_t i = 0; i < world().things.size(); ++i) {
    if (rng_.chance(kHoused)) move_anywhere(Id::thing(i));
  }
}

void StartDraft::draw_states(Id id) {
  const auto& rules = demands_.rules;
  const auto& kind = setting().kind_of(id);
  auto& role = start_.setting.objects.object(id);
  if (!kind.colors.empty()) role.color = rng_.pick(kind.colors);
  if (!kind.materials.empty()) role.material = rng_.pick(kind.materials);
  role.size = rng_.chance(0.5) ? "small" : "large";
  auto& thing = world()[id];
  const auto any_symbol = [&] { return symbolic::SubstanceId(rng_.below(rules.symbols().size())); };
  for (const auto* group : kind.groups) thing.set(rng_.pick(group->predicates));
  thing.coats.clear();
  if (kind.coverable && rng_.chance(kCovered)) thing.coats.insert(any_symbol());
  thing.filling = thing.has(Predicate::Filled) ? any_symbol() : symbolic::SubstanceId();
}

void StartDraft::read_constraints() {
  for (const auto& aim : demands_.aims) constraints_.emplace_back(*aim.formula, setting(), start_.world);
}

void StartDraft::read_attributes() {
  if (!attributes_changed_) return;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const auto& aim = demands_.aims[i];
    if (aim.of_attributes) constraints_[i] = symbolic::Goal(*aim.formula, setting(), start_.world);
  }
  attributes_changed_ = false;
}

void StartDraft::find_broken() {
  broken_.clear();
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const auto& goal = constraints_[i];
    if (!symbolic::holds(goal, goal.root(), setting(), start_.world, symbolic::Progress(goal))) broken_.push_back(i);
  }
}

symbolic::Id StartDraft::random_room() { return Id::room(rng_.below(setting().objects.rooms.size())); }

bool StartDraft::can_be_put(Id thing, Predicate relation, Id place) const {
  const auto& world = start_.world;
  return place != thing && !symbolic::rests_on(world, place, thing) &&
         symbolic::has_room(setting(), world, thing, relation, place);
}

void StartDraft::put(Id thing, PlaceKind where, Id at) {
  auto& changed = world()[thing];
  changed.where = where;
  changed.at = at;
  changed.beside = kNobody;
  for (auto& other : world().things) {
    if (other.beside == thing) other.beside = kNobody;
  }
}

void StartDraft::move_anywhere(Id thing) {
  // Of furniture only small appliances stand on anything, and not all of them.
  if (!setting().kind_of(thing).movable && rng_.chance(0.5)) return put(thing, PlaceKind::Floor, random_room());
  std::vector<std::pair<PlaceKind, Id>> places;
  for (std::size_t i = 0; i < world().things.size(); ++i) {
    const auto place = Id::thing(i);
    if (can_be_put(thing, Predicate::On, place)) places.emplace_back(PlaceKind::On, place);
    if (can_be_put(thing, Predicate::Inside, place)) places.emplace_back(PlaceKind::Inside, place);
  }
  if (places.empty() || !rng_.chance(kHoused)) return put(thing, PlaceKind::Floor, random_room());
  const auto [where, at] = rng_.pick(places);
  put(thing, where, at);
}

std::vector<symbolic::Id> StartDraft::things_of(const Domain& domain) const {
  std::vector<Id> found;
  for (std::size_t i = 0; i < start_.world.things.size(); ++i) {
    const auto& category = setting().kind_of(Id::thing(i)).category;
    const bool is_of = domain.kind == Domain::Kind::Object ||
                       std::any_of(domain.members.begin(), domain.members.end(), [&](const Domain::Member& member) {
                         return !member.slice && member.category == category;
                       });
    if (is_of) found.push_back(Id::thing(i));
  }
  return found;
}

std::vector<symbolic::Id> StartDraft::rooms_of(const Domain& domain) const {
  std::vector<Id> found;
  for (std::size_t r = 0; r < setting().objects.rooms.size(); ++r) {
    const auto& type = setting().objects.rooms[r].type;
    const bool is_of = domain.kind == Domain::Kind::Room ||
                       std::any_of(domain.members.begin(), domain.members.end(),
                                   [&](const Domain::Member& member) { return member.category == type; });
    if (is_of) found.push_back(Id::room(r));
  }
  return found;
}

bool StartDraft::is_true(const StartLiteral& literal, Id thing) const {
  const auto& world = start_.world;
  if (literal.relation) {
    for (const auto& others : {things_of(literal.other), rooms_of(literal.other)}) {
      for (const Id other : others) {
        if (symbolic::holds(setting(), world, literal.predicate, thing, other, symbolic::kAnySymbol)) return true;
      }
    }
    return false;
  }
  const auto& role = setting().objects.object(thing);
  const auto is = [&](const std::string& own) {
    return own == literal.symbol || (literal.symbol == "any" && !own.empty());
  };
  if (literal.predicate == Predicate::Color) return is(role.color);
  if (literal.predicate == Predicate::Material) return is(role.material);
  if (literal.predicate == Predicate::Size) return is(role.size);
  const auto symbol = demands_.rules.symbol_named(literal.symbol);
  return symbolic::holds(setting(), world, literal.predicate, thing, kNobody, symbol);
}

bool StartDraft::satisfies(const StartDemands::Aim& aim, Id thing) const {
  return std::all_of(aim.literals.begin(), aim.literals.end(),
                     [&](const StartLiteral& literal) { return is_true(literal, thing) == literal.positive; });
}

bool StartDraft::improve() {
  if (broken_.empty()) return false;
  const auto& aim = demands_.aims[rng_.pick(broken_)];
  if (aim.of_agent) {
    world().room = random_room();
  } else if (!aim.shaped) {
    perturb(aim);
  } else if (aim.literals.empty()) {
    return false;  // a matter of how many there are
  } else {
    change(aim);
  }
  read_attributes();
  find_broken();
  return true;
}

/// Draws something of one object anew.
void StartDraft::perturb(const StartDemands::Aim& aim) {
  const auto concerned = things_of(aim.formula->domain);
  if (concerned.empty()) return;
  const Id thing = rng_.pick(concerned);
  if (rng_.chance(0.5)) return move_anywhere(thing);
  draw_states(thing);
  attributes_changed_ = true;
}

void StartDraft::change(const StartDemands::Aim& aim) {
  std::vector<Id> with, without;
  for (const Id thing : things_of(aim.formula->domain)) (satisfies(aim, thing) ? with : without).push_back(thing);
  const auto& formula = *aim.formula;
  const bool too_many = formula.op == Formula::Op::Count && formula.comparison == Comparison::Equal &&
                        static_cast<int>(with.size()) > formula.number;
  const auto& choice = too_many ? with : without;
  if (choice.empty()) return;
  const Id thing = rng_.pick(choice);
  if (rng_.chance(kStray)) return move_anywhere(thing);
  if (too_many) {
    const auto& literal = rng_.pick(aim.literals);
    return make(literal, thing, !literal.positive);
  }
  for (const auto& literal : aim.literals) {
    if (is_true(literal, thing) != literal.positive) make(literal, thing, literal.positive);
  }
}

SymbolicStart StartDraft::finished() && {
  symbolic::add_pieces(start_.setting, start_.world);
  return std::move(start_);
}

}  // namespace unietp
