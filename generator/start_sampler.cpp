#include "generator/start_sampler.h"

#include <algorithm>
#include <set>

#include "generator/domain_constraints.h"
#include "logic/evaluate.h"
#include "scene/states.h"
#include "templates/init_shape.h"

namespace unietp {
namespace {

constexpr int kWorlds = 6;     // fresh worlds before giving up
constexpr int kRepairs = 300;  // changes tried in one world
/// A change that breaks more than it mends is kept this often, to leave dead ends.
constexpr double kUphill = 0.05;

bool speaks_of(const Domain& domain, const std::string& category) {
  return std::any_of(domain.members.begin(), domain.members.end(),
                     [&](const Domain::Member& member) { return !member.slice && member.category == category; });
}

bool in_group(const StateGroup& group, Predicate predicate) {
  return std::find(group.predicates.begin(), group.predicates.end(), predicate) != group.predicates.end();
}

}  // namespace

StartSampler::StartSampler(const Specification& specification, const Knowledge& knowledge)
    : specification_(specification), knowledge_(knowledge) {
  std::set<std::string> names;
  for (auto& name : categories_of(specification.goal)) names.insert(std::move(name));
  for (const auto& start : specification.init) {
    for (auto& name : categories_of(start)) names.insert(std::move(name));
  }
  for (const auto& name : names) {
    if (knowledge.find(name) == nullptr) {
      rooms_.push_back(name);
      continue;
    }
    Kind kind{name, {}, 1, 2};
    for (std::size_t g = 0; g < state_groups().size(); ++g) {
      if (knowledge.has(name, state_groups()[g].affordance)) kind.groups.push_back(g);
    }
    int sum = 0;
    bool exact = false;
    for (const auto& start : specification.init) {
      if (!speaks_of(start.domain, name)) continue;
      const int demanded = demanded_count(start);
      kind.least = std::max(kind.least, demanded);
      sum += demanded;
      if (start.op == Formula::Op::Count && start.comparison == Comparison::Equal && start_literals(start).empty()) {
        exact = true;
      }
    }
    kind.most = exact ? kind.least : std::max(kind.least, sum) + 1;
    kinds_.push_back(std::move(kind));
  }
}

StartSampler::World StartSampler::random_world(Rng& rng) const {
  World world;
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    const auto& kind = kinds_[k];
    const auto extra = rng.below(static_cast<std::uint64_t>(kind.most - kind.least) + 1);
    const auto number = static_cast<std::uint64_t>(kind.least) + extra;
    for (std::uint64_t i = 0; i < number; ++i) {
      Object object{k, {}, std::nullopt, 0};
      for (const auto group : kind.groups) object.value.push_back(rng.below(state_groups()[group].predicates.size()));
      object.room = rng.below(rooms_.size() + 1);
      world.push_back(std::move(object));
    }
  }
  for (std::size_t i = 0; i < world.size(); ++i) {
    const auto places = places_for(world, i);
    if (!places.empty() && rng.chance(0.5)) world[i].place = rng.pick(places);
  }
  return world;
}

std::vector<StartSampler::Place> StartSampler::places_for(const World& world, std::size_t object) const {
  std::vector<Place> places;
  const auto& name = kinds_[world[object].kind].category;
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (i == object) continue;
    for (const auto relation : {Predicate::On, Predicate::Inside}) {
      if (knowledge_.placement(name, info(relation).name, kinds_[world[i].kind].category) != nullptr) {
        places.push_back({relation, i});
      }
    }
  }
  return places;
}

void StartSampler::randomise(World& world, std::size_t object, const Formula& aim, Rng& rng) const {
  auto& changed = world[object];
  const auto literals = start_literals(aim);
  if (literals.empty()) return;
  const auto& literal = rng.pick(literals);
  if (literal.relation) {
    const auto places = places_for(world, object);
    changed.place.reset();
    if (!places.empty() && rng.chance(literal.positive ? 0.9 : 0.5)) changed.place = rng.pick(places);
    changed.room = rng.below(rooms_.size() + 1);
    return;
  }
  const auto& groups = kinds_[changed.kind].groups;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto& group = state_groups()[groups[g]];
    if (in_group(group, literal.predicate)) changed.value[g] = rng.below(group.predicates.size());
  }
}

Trace StartSampler::trace_of(const World& world) const {
  Trace trace;
  Facts facts;
  const auto add = [&](Entity entity) {
    trace.entities.push_back(std::move(entity));
    const auto index = static_cast<EntityIndex>(trace.entities.size() - 1);
    facts.set_exists(index);
    return index;
  };
  for (std::size_t i = 0; i < world.size(); ++i) {
    const auto& category = kinds_[world[i].kind].category;
    add({Entity::Kind::Object, category + "_" + std::to_string(i), category, ""});
  }
  const auto first_room = static_cast<EntityIndex>(trace.entities.size());
  for (const auto& type : rooms_) add({Entity::Kind::Room, type + "_1", type, ""});
  add({Entity::Kind::Agent, "agent", "agent", ""});  // with empty hands and in none of these rooms
  for (std::size_t i = 0; i < world.size(); ++i) {
    const auto& object = world[i];
    const auto index = static_cast<EntityIndex>(i);
    const auto& groups = kinds_[object.kind].groups;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto predicate = state_groups()[groups[g]].predicates[object.value[g]];
      if (predicate == Predicate::Filled) {
        facts.set(predicate, index, std::string("water"));
      } else {
        facts.set(predicate, index);
      }
    }
    if (object.place) facts.set(object.place->relation, index, static_cast<EntityIndex>(object.place->receptacle));
    if (object.room < rooms_.size())
      facts.set(Predicate::InRoom, index, first_room + static_cast<EntityIndex>(object.room));
  }
  trace.states.push_back(std::move(facts));
  return trace;
}

std::vector<std::size_t> StartSampler::broken(const World& world) const {
  const auto trace = trace_of(world);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < specification_.init.size(); ++i) {
    if (!holds_in(specification_.init[i], trace, 0)) found.push_back(i);
  }
  return found;
}

std::optional<Trace> StartSampler::sample(Rng rng) const {
  for (int attempt = 0; attempt < kWorlds; ++attempt) {
    auto world = random_world(rng);
    auto problems = broken(world);
    for (int repair = 0; repair < kRepairs && !problems.empty(); ++repair) {
      const auto& aim = specification_.init[rng.pick(problems)];
      std::vector<std::size_t> concerned;
      for (std::size_t i = 0; i < world.size(); ++i) {
        if (speaks_of(aim.domain, kinds_[world[i].kind].category)) concerned.push_back(i);
      }
      if (concerned.empty()) break;
      auto changed = world;
      randomise(changed, rng.pick(concerned), aim, rng);
      auto left = broken(changed);
      if (left.size() > problems.size() && !rng.chance(kUphill)) continue;
      world = std::move(changed);
      problems = std::move(left);
    }
    if (problems.empty()) return trace_of(world);
  }
  return std::nullopt;
}

}  // namespace unietp
