#include "expert/execution_tree.h"

#include <algorithm>
#include <utility>

#include "logic/evaluate.h"
#include "simulation/relations.h"

namespace unietp {

Result<ExecutionTree> ExecutionTree::of(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                        const Profile& profile) {
  return of(goal, start, knowledge, profile, {.physics = physics_of(start)});
}

Result<ExecutionTree> ExecutionTree::of(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                        const Profile& profile, KnownStart known) {
  if (!known.places) known.places = NodeIndex(start.nodes);
  NodeIndex places = *known.places;
  auto read = std::exchange(known.read, std::nullopt);
  auto world = World::create(start, knowledge, profile, std::move(known));
  if (!world) return world.error();
  return ExecutionTree(goal, start, knowledge, profile, std::move(places), std::move(read), std::move(*world));
}

ExecutionTree::ExecutionTree(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                             const Profile& profile, NodeIndex places, std::optional<ReadScene> read, World world)
    : goal_(&goal),
      start_(&start),
      knowledge_(&knowledge),
      profile_(&profile),
      places_(std::move(places)),
      world_(std::move(world)),
      compares_later_(reads_later_comparisons(goal)) {
  compared_.add(goal);
  if (read) {
    reader_ = std::move(read->reader);
    facts_.emplace_back(compared(std::move(read->facts), start));
  } else {
    facts_.emplace_back(this->read(start));
  }
  at_start_ = reader_.entities();
}

ExecutionTree ExecutionTree::with_goal(const Formula& goal) const {
  ExecutionTree other = *this;
  other.goal_ = &goal;
  other.trace_ = {};
  other.judged_.clear();
  return other;
}

Facts ExecutionTree::read(const Scene& scene) { return compared(reader_.read(scene), scene); }

Facts ExecutionTree::compared(Facts facts, const Scene& scene) const {
  return compared_.none() ? std::move(facts) : with_comparisons(facts, scene, reader_, compared_);
}

ActionResult ExecutionTree::step(World& world, const Action& action) {
  const MomentId before = world.moment();
  ActionResult result = world.step(action);
  read(before, world);
  return result;
}

void ExecutionTree::read(MomentId before, const World& world) {
  const auto& passed = world.passed();
  if (passed.empty()) return read(before, world, world.changes());
  for (const PassedMoment& one : passed) {
    read(before, world.at(one.moment), one.changes);
    before = one.moment;
  }
}

void ExecutionTree::read(MomentId before, const World& now, const Delta& changes) {
  const std::size_t place = now.moment().index();
  if (place >= facts_.size()) facts_.resize(place + 1);
  if (!facts_[place])
    facts_[place] = compares_later_ ? read(now.scene()) : reader_.read(*facts_[before.index()], changes);
}

bool ExecutionTree::reaches_goal(std::vector<MomentId> moments) {
  // No operator of the logic tells a state that lasts from one that does not.
  moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
  const auto differ = std::mismatch(judged_.begin(), judged_.end(), moments.begin(), moments.end());
  trace_.states.resize(static_cast<std::size_t>(differ.first - judged_.begin()));
  for (auto moment = differ.second; moment != moments.end(); ++moment)
    trace_.states.push_back(*facts_[moment->index()]);
  trace_.entities.follow(entities());
  judged_ = std::move(moments);
  return holds(*goal_, trace_);
}

}  // namespace unietp
