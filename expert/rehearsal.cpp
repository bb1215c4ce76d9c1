#include "expert/rehearsal.h"

#include <algorithm>

#include "logic/evaluate.h"
#include "simulation/relations.h"

namespace unietp {

Result<Rehearsal> Rehearsal::of(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                const Profile& profile) {
  return of(goal, start, knowledge, profile, {physics_of(start), std::nullopt, std::nullopt});
}

Result<Rehearsal> Rehearsal::of(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                const Profile& profile, KnownStart known) {
  auto world = World::create(start, knowledge, profile, std::move(known));
  if (!world) return world.error();
  return Rehearsal(goal, start, knowledge, profile, std::move(*world));
}

Rehearsal::Rehearsal(const Formula& goal, const Scene& start, const Knowledge& knowledge, const Profile& profile,
                     World world)
    : goal_(&goal),
      start_(&start),
      knowledge_(&knowledge),
      profile_(&profile),
      world_(std::move(world)),
      compares_later_(reads_later_comparisons(goal)) {
  compared_.add(goal);
  facts_.emplace_back(read(start));
}

Facts Rehearsal::read(const Scene& scene) {
  Facts facts = reader_.read(scene);
  return compared_.none() ? facts : with_comparisons(facts, scene, reader_, compared_);
}

Outcome Rehearsal::step(World& world, const Action& action) {
  const std::uint32_t before = world.moment();
  Outcome outcome = world.step(action);
  read(before, world);
  return outcome;
}

void Rehearsal::read(std::uint32_t before, const World& world) {
  const std::uint32_t now = world.moment();
  if (now >= facts_.size()) facts_.resize(now + std::size_t{1});
  if (!facts_[now])
    facts_[now] = compares_later_ ? read(world.scene()) : reader_.read(*facts_[before], world.changes());
}

bool Rehearsal::reaches_goal(std::vector<std::uint32_t> moments) {
  // No operator of the logic tells a state that lasts from one that does not.
  moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
  const auto differ = std::mismatch(judged_.begin(), judged_.end(), moments.begin(), moments.end());
  trace_.states.resize(static_cast<std::size_t>(differ.first - judged_.begin()));
  for (auto moment = differ.second; moment != moments.end(); ++moment) trace_.states.push_back(*facts_[*moment]);
  trace_.entities.follow(entities());
  judged_ = std::move(moments);
  return holds(*goal_, trace_);
}

}  // namespace unietp
