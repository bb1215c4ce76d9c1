#include "exports/behavior_abilities.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <set>

#include "akb/row_reader.h"
#include "core/files.h"
#include "scene/trace.h"

namespace unietp {
namespace {

constexpr double kAbsoluteZero_C = -273.15, kHottest_C = 10'000, kFastest_per_s = 100;
// OmniGibson 1.1.1: object_states/temperature.py, heated.py and burnt.py.
constexpr double kRoom_C = 23, kLoss_per_s = 0.02, kHot_C = 40, kBurnt_C = 200;
constexpr double kCool_C = 10;  // as python/adapters/act_behavior.py reads temperatures; OmniGibson has no such state

struct StateAbility {
  Predicate state;
  std::string_view ability;  // that gives a thing the state, or the one that it is the opposite of
};
constexpr std::array kOfStates{
    StateAbility{Predicate::Open, "openable"},      StateAbility{Predicate::Closed, "openable"},
    StateAbility{Predicate::PowerOn, "toggleable"}, StateAbility{Predicate::PowerOff, "toggleable"},
    StateAbility{Predicate::Hot, "heatable"},       StateAbility{Predicate::Cooked, "cookable"},
    StateAbility{Predicate::Raw, "cookable"},       StateAbility{Predicate::Frozen, "freezable"},
    StateAbility{Predicate::Thawed, "freezable"},   StateAbility{Predicate::Folded, "cloth"},
    StateAbility{Predicate::Unfolded, "cloth"},     StateAbility{Predicate::Filled, "fillable"},
    StateAbility{Predicate::Empty, "fillable"},     StateAbility{Predicate::Soaked, "saturable"},
    StateAbility{Predicate::Dry, "saturable"}};

/// What an action needs of what it names, and of what the hand holds; "" for nothing.
struct ActionAbility {
  std::string_view action, of_target, of_held;
};
constexpr std::array kOfActions{
    ActionAbility{"open", "openable", ""},         ActionAbility{"close", "openable", ""},
    ActionAbility{"turn_on", "toggleable", ""},    ActionAbility{"turn_off", "toggleable", ""},
    ActionAbility{"slice", "sliceable", "slicer"}, ActionAbility{"soak_with", "gives_water", "takes_water"}};

/// What a temperature has to pass to become a state.
struct ThermalState {
  Predicate state;
  double limit_C;
};

std::string celsius(double value) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.0f", value);
  return std::string(text.data()) + " °C";
}

class Asking {
 public:
  Asking(const BddlSynsets& synsets, const BehaviorAbilities& abilities) : synsets_(synsets), abilities_(abilities) {}

  /// Whether a category is known to lack an ability.
  bool lacks(const Node* node, std::string_view ability) const {
    const auto* const its = node == nullptr || ability.empty() ? nullptr : all_of(node->category);
    return its != nullptr && !its->contains(ability);
  }

  std::string of_goal(const LtlfGoal& goal, const Scene& start) const {
    for (const LtlfProposition& one : goal.propositions) {
      const auto* const row = std::find_if(kOfStates.begin(), kOfStates.end(),
                                           [&](const StateAbility& state) { return state.state == one.meaning; });
      if (one.presence || row == kOfStates.end()) continue;
      const Node* const node = find_node(start, one.arguments.front());
      if (lacks(node, row->ability)) return "OmniGibson has no `" + one.predicate + "` of " + said(*node, row->ability);
    }
    return "";
  }

  /// `now`: before the step.
  std::string of_step(const StepRecord& step, const Scene& now) const {
    const std::string& action = step.command.action;
    const Node* const target = step.command.args.empty() ? nullptr : find_node(now, step.command.args.back().id);
    const Node* const held = now.agent.held.empty() ? nullptr : find_node(now, now.agent.held.front());
    const auto* const row = std::find_if(kOfActions.begin(), kOfActions.end(),
                                         [&](const ActionAbility& one) { return one.action == action; });
    if (row != kOfActions.end()) {
      if (lacks(target, row->of_target)) return refused(action, *target, row->of_target);
      if (lacks(held, row->of_held)) return refused(action, *held, row->of_held);
    }
    if (action == "wipe" && target != nullptr && target->states.has(Predicate::Dirty) && lacks(held, "wipes_stains"))
      return refused(action, *held, "wipes_stains");
    if (action == "cook_with" || action == "heat_with" || action == "burn_with" || action == "cool_with")
      return of_temperatures(step, now, target);
    return "";
  }

 private:
  /// Those of a category; nullptr for one without a synset.
  const std::map<std::string, BehaviorAbility, std::less<>>* all_of(const std::string& category) const {
    static const std::map<std::string, BehaviorAbility, std::less<>> kNone;
    const auto synset = synsets_.find(category);
    if (synset == synsets_.end()) return nullptr;
    const auto its = abilities_.find(synset->second);
    return its == abilities_.end() ? &kNone : &its->second;
  }

  static std::string said(const Node& node, std::string_view ability) {
    return node.category + ", which is not `" + std::string(ability) + "` in BEHAVIOR";
  }
  static std::string refused(const std::string& action, const Node& node, std::string_view ability) {
    return "OmniGibson refuses " + action + " with " + said(node, ability);
  }

  /// A thing at a source, which loses heat to the room, ends where both are in balance.
  std::string of_temperatures(const StepRecord& step, const Scene& now, const Node* source) const {
    const auto* const its = source == nullptr ? nullptr : all_of(source->category);
    if (its == nullptr) return "";
    const bool cools = step.command.action == "cool_with";
    const auto found = its->find(cools ? "cold_source" : "heat_source");
    if (found == its->end()) return refused(step.command.action, *source, cools ? "cold_source" : "heat_source");
    const BehaviorAbility& by = found->second;
    const double end_C = (by.celsius * by.rate_per_s + kRoom_C * kLoss_per_s) / (by.rate_per_s + kLoss_per_s);
    for (const Node& after : step.changes.nodes) {
      const Node* const before = find_node(now, after.id);
      const auto* const can = all_of(after.category);
      if (before == nullptr || can == nullptr) continue;
      const auto cooks = can->find("cookable");
      const double cooked_C = cooks == can->end() ? kBurnt_C : cooks->second.celsius;
      for (const ThermalState& one :
           {ThermalState{Predicate::Hot, kHot_C}, ThermalState{Predicate::Cooked, cooked_C},
            ThermalState{Predicate::Burnt, kBurnt_C}, ThermalState{Predicate::Cool, kCool_C}}) {
        if (!after.states.has(one.state) || before->states.has(one.state)) continue;
        const bool reached = one.state == Predicate::Cool ? end_C <= one.limit_C : end_C >= one.limit_C;
        if (reached) continue;
        return after.category + " does not become " + std::string(info(one.state).name) + " with " + source->category +
               " in OmniGibson: at " + celsius(one.limit_C) + ", and it gets to " + celsius(end_C);
      }
    }
    return "";
  }

  const BddlSynsets& synsets_;
  const BehaviorAbilities& abilities_;
};

}  // namespace

Result<BehaviorAbilities> read_behavior_abilities(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  std::vector<Error> errors;
  RowReader row(file.string(), *text, {"synset", "ability", "celsius", "rate_per_s", "source"}, errors);
  BehaviorAbilities abilities;
  for (const CsvRow& one : row.rows()) {
    row.at(one);
    BehaviorAbility ability;
    if (!row.text("celsius").empty()) ability.celsius = row.number("celsius", kAbsoluteZero_C, kHottest_C, true);
    if (!row.text("rate_per_s").empty()) ability.rate_per_s = row.number("rate_per_s", 0, kFastest_per_s, false);
    (void)row.required("source");
    const std::string name = row.required("ability");
    if (!abilities[row.required("synset")].emplace(name, ability).second)
      row.fail("ability", "'" + name + "' stands twice");
  }
  if (!errors.empty()) return errors.front();
  return abilities;
}

std::string denied_by_omnigibson(const FinishedTask& task, const LtlfGoal& goal, const BddlSynsets& synsets,
                                 const BehaviorAbilities& abilities) {
  const Asking asking(synsets, abilities);
  if (auto why = asking.of_goal(goal, task.start); !why.empty()) return why;
  Scene now = task.start;
  for (const StepRecord& step : task.shown.at(Mode::M1).steps) {
    if (step.success) {
      if (auto why = asking.of_step(step, now); !why.empty()) return why;
    }
    now = apply(std::move(now), step.changes);
  }
  return "";
}

}  // namespace unietp
