#include "generator/consistency.h"
#include "generator/goal_parts.h"
#include "generator/start_sampler.h"
#include "logic/evaluate.h"
#include "symbolic/reach.h"

namespace unietp {
namespace {

/// "(hot Mug)": the truth with categories in the places of objects.
std::string text_of(const symbolic::Atom& atom, const symbolic::Setting& setting) {
  std::string text = "(" + std::string(info(atom.predicate).name);
  for (const symbolic::Id id : {atom.first, atom.second}) {
    if (id == symbolic::kNobody) continue;
    text += " ";
    if (id == symbolic::kAgent) {
      text += "agent";
    } else {
      text += id.is_room() ? setting.objects.room(id).type : setting.kind_of(id).category;
    }
  }
  if (atom.symbol) text += " " + setting.rules->symbols()[atom.symbol->index()];
  return text + ")";
}

std::optional<GateRefusal> unreachable(const Specification& specification, const SymbolicStart& start) {
  const symbolic::Goal goal(specification.goal, start.setting, start.world);
  const symbolic::Reach reach(start.setting, start.world);
  const auto found = symbolic::out_of_reach(goal, reach, start.setting, start.world);
  if (!found) return std::nullopt;
  const auto text = text_of(found->atom, start.setting);
  const std::string simulator(name_of(specification.simulator));
  return GateRefusal{Gate::Reachable, text,
                     "no action that " + simulator + " offers, with what the start has, makes " + text +
                         (found->wanted ? " true" : " false"),
                     "other categories, a tool that the template's init demands, or fewer simulators for the template"};
}

std::optional<GateRefusal> already_true(const Specification& specification, const std::vector<Formula>& parts,
                                        const SymbolicStart& start) {
  const auto trace = symbolic::trace_of(start.setting, {start.world});
  const auto remedy = "start constraints that make it false, in the template's init";
  if (holds(specification.goal, trace)) {
    return GateRefusal{Gate::FalseAtStart, to_text(specification.goal),
                       "the goal already holds in a start that meets init", remedy};
  }
  for (const auto& part : parts) {
    if (!holds(part, trace)) continue;
    return GateRefusal{Gate::FalseAtStart, to_text(part),
                       "a part of the goal already holds in a start that meets init: " + to_text(part), remedy};
  }
  return std::nullopt;
}

}  // namespace

std::optional<GateRefusal> bad_start(const Specification& specification, const Knowledge& knowledge, int samples) {
  const StartSampler sampler(specification, knowledge);
  const auto parts = goal_parts(specification.goal);
  for (int i = 0; i < samples; ++i) {
    const auto start = sampler.sample(Rng(0).fork("start", static_cast<std::uint64_t>(i)));
    if (!start) {
      std::string all;
      for (const auto& constraint : specification.init) all += (all.empty() ? "" : " ") + to_text(constraint);
      return GateRefusal{Gate::Start, all, "no start was found that meets all of init",
                         "start constraints that can hold together"};
    }
    if (auto refusal = already_true(specification, parts, *start)) return refusal;
    if (i > 0) continue;
    if (auto refusal = unreachable(specification, *start)) return refusal;
  }
  return std::nullopt;
}

}  // namespace unietp
