#include "environment/task.h"

#include <utility>

#include "grounding/grown_scene.h"
#include "simulation/relations.h"
#include "simulation/world.h"

namespace unietp {
namespace {

/// A start that the fast reading of a grown scene does not cover: what is held or attached is told by edges alone.
bool is_plain(const Scene& start) {
  const auto attached =
      start.edges.partition_point([](const Edge& edge) { return edge.relation < Predicate::Attached; });
  return start.agent.held.empty() && (attached == start.edges.end() || attached->relation != Predicate::Attached);
}

}  // namespace

Result<SharedTask> prepare_task(TaskText text, Scene start, const SimulatorData& data) {
  KnownStart known{.physics = physics_of(start)};
  return prepare_task(std::move(text), std::move(start), data, std::move(known));
}

Result<SharedTask> prepare_task(TaskText text, Scene start, const SimulatorData& data, const Home& home) {
  if (!is_plain(start) || !is_plain(home.scene)) return prepare_task(std::move(text), std::move(start), data);
  KnownStart known = known_start(home, start, read_grown(home, start));
  return prepare_task(std::move(text), std::move(start), data, std::move(known));
}

Result<SharedTask> prepare_task(TaskText text, Scene start, const SimulatorData& data, KnownStart known) {
  auto goal = parse_formula(text.id, text.goal_text, FormulaUse::Goal);
  if (!goal) return goal.error();
  known.physics.prepare();  // so that several threads may copy it
  if (!known.places) known.places = NodeIndex(start.nodes);
  if (!known.viewer) known.viewer = Viewer(start);
  auto read = std::exchange(known.read, std::nullopt);
  // Nobody should learn only in the middle of training that a task has no start.
  if (auto world = World::create(start, *data.knowledge, *data.profile, known); !world) return world.error();

  Compared compared;
  compared.add(*goal);
  FactReader reader;
  Facts facts;
  if (read) {
    reader = std::move(read->reader);
    facts = std::move(read->facts);
  } else {
    facts = reader.read(start);
  }
  if (!compared.none()) facts = with_comparisons(facts, start, reader, compared);
  reader.share();
  Monitor monitor(*goal);
  monitor.observe(reader.entities(), facts);
  const bool compares_later = reads_later_comparisons(*goal);
  return std::make_shared<const EnvironmentTask>(
      EnvironmentTask{std::move(text), start.simulator, std::move(*goal), data, std::move(start), std::move(known),
                      std::move(compared), compares_later, std::move(reader), std::move(facts), std::move(monitor)});
}

}  // namespace unietp
