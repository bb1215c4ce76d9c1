#include "exports/own_scene.h"

#include <algorithm>
#include <array>

#include "exports/ai2thor_words.h"
#include "interchange/own_ids.h"
#include "scene/action.h"
#include "scene/trace.h"

namespace unietp {
namespace {

/// What every program of python/adapters translates, and what does not change.
constexpr std::array kToldByAll{Predicate::Open,    Predicate::Closed,   Predicate::On,   Predicate::Inside,
                                Predicate::OnFloor, Predicate::InRoom,   Predicate::Held, Predicate::SliceOf,
                                Predicate::Color,   Predicate::Material, Predicate::Size};
/// What act_virtualhome.py tells besides.
constexpr std::array kToldByVirtualhome{Predicate::PowerOn, Predicate::PowerOff, Predicate::Clean, Predicate::Dirty};
/// What act_behavior.py tells besides.
constexpr std::array kToldByBehavior{Predicate::PowerOn, Predicate::PowerOff, Predicate::Clean,  Predicate::Dirty,
                                     Predicate::Soaked,  Predicate::Dry,      Predicate::Hot,    Predicate::Cool,
                                     Predicate::Cooked,  Predicate::Raw,      Predicate::Burnt,  Predicate::Frozen,
                                     Predicate::Thawed,  Predicate::Filled,   Predicate::Empty,  Predicate::Covered,
                                     Predicate::Folded,  Predicate::Unfolded, Predicate::Sliced, Predicate::Whole,
                                     Predicate::Attached};

/// Those for which OmniGibson 1.1.1 has no symbolic primitive, so that act_behavior.py sets what they lead to.
constexpr std::array kWithoutPrimitive{ActionType::WashWith, ActionType::FillWith, ActionType::PourTo,
                                       ActionType::SpreadTo, ActionType::Fold,     ActionType::Unfold};
/// What act_habitat.py does of the actions of M1.
constexpr std::array kOfHabitat{ActionType::GoTo,    ActionType::TurnTo,  ActionType::PickUp,
                                ActionType::PlaceOn, ActionType::PlaceIn, ActionType::Drop,
                                ActionType::Open,    ActionType::Close,   ActionType::Stop};

template <class List, class Value>
bool has(const List& list, Value one) {
  return std::find(list.begin(), list.end(), one) != list.end();
}

bool is_told(Simulator simulator, Predicate one) {
  if (has(kToldByAll, one)) return true;
  switch (simulator) {
    case Simulator::Ai2thor:
      return thor_state(one) != nullptr;
    case Simulator::Virtualhome:
      return has(kToldByVirtualhome, one);
    case Simulator::Behavior:
      return has(kToldByBehavior, one);
    case Simulator::Habitat:
      return false;  // which has no other states
  }
  return false;
}

std::string without_action(const FinishedTask& task) {
  const Simulator simulator = task.start.simulator;
  for (const StepRecord& step : task.shown.at(Mode::M1).steps) {
    const auto type = action_named(step.command.action);
    if (!type || !step.success) continue;
    if (simulator == Simulator::Behavior && has(kWithoutPrimitive, *type))
      return "OmniGibson has no primitive for " + step.command.action;
    if (simulator == Simulator::Habitat && !has(kOfHabitat, *type)) return "Habitat has no " + step.command.action;
  }
  return "";
}

}  // namespace

bool listed_in_ai2thor(const Knowledge& knowledge, const std::string& thing, const std::string& place) {
  const std::string_view part = place == "ShelvingUnit" ? "Shelf" : thor_holding_part(place);
  for (const std::string_view holder : {std::string_view(place), part}) {
    for (const Predicate relation : {Predicate::On, Predicate::Inside}) {
      const Placement* const row = holder.empty() ? nullptr : knowledge.placement(thing, relation, holder);
      if (row != nullptr && row->source.source.starts_with("metadata:")) return true;
    }
  }
  return false;
}

bool in_own_scene(const Scene& start) {
  return std::any_of(start.nodes.begin(), start.nodes.end(),
                     [&](const Node& node) { return own_id_of(node, start.simulator).has_value(); });
}

std::string unlisted_in_ai2thor(const FinishedTask& task, const Knowledge& knowledge) {
  if (task.start.simulator != Simulator::Ai2thor || !in_own_scene(task.start)) return "";
  for (const Edge& edge : task.record.changes.edges_added) {
    if (edge.relation != Predicate::On && edge.relation != Predicate::Inside) continue;
    const Node* const thing = find_node(task.start, edge.from);
    const Node* const place = find_node(task.start, edge.to);
    if (thing == nullptr || place == nullptr || listed_in_ai2thor(knowledge, thing->category, place->category))
      continue;
    return "no table of AI2-THOR's has " + thing->category + " on or in " + place->category;
  }
  return "";
}

std::optional<Predicate> untold_in(Simulator simulator, const Formula& goal) {
  if (goal.op == Formula::Op::Atom && !is_told(simulator, goal.predicate)) return goal.predicate;
  for (const Formula& child : goal.children) {
    if (const auto untold = untold_in(simulator, child)) return untold;
  }
  return std::nullopt;
}

std::string beyond_own_simulator(const FinishedTask& task) {
  if (!in_own_scene(task.start)) return "";
  const Simulator simulator = task.start.simulator;
  if (simulator == Simulator::Virtualhome || simulator == Simulator::Habitat) {
    if (const auto untold = untold_in(simulator, task.record.goal_tree))
      return std::string(simulator == Simulator::Habitat ? "Habitat" : "VirtualHome's graph") + " does not tell " +
             std::string(info(*untold).name);
  }
  return without_action(task);
}

}  // namespace unietp
