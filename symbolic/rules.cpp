#include "symbolic/rules.h"

#include <algorithm>

#include "scene/simulator_info.h"

namespace unietp::symbolic {

Capabilities capabilities_of(Simulator simulator, ActionProfile profile) {
  Capabilities capabilities;
  capabilities.actions = actions_of(simulator, profile);
  capabilities.power_needs_plug = capabilities.has(ActionType::PlugIn);
  capabilities.attaching = profile == ActionProfile::Wide && info(simulator).attaches;
  return capabilities;
}

std::uint8_t needs_of(const Effect& row) {
  std::uint8_t needs = 0;
  for (const EffectNeed need : row.needs) needs |= bit_of(need);
  return needs;
}

Rules::Rules(const Knowledge& knowledge, const Capabilities& capabilities, const std::vector<std::string>& categories)
    : capabilities_(capabilities) {
  for (const auto& category : categories) add_kind(knowledge, category);
  const std::size_t given = kinds_.size();
  for (std::size_t i = 0; i < given; ++i) {
    if (!kinds_[i].sliceable) continue;
    for (const Effect* row : knowledge.effects_on(std::string(kinds_[i].category), Treatment::Slices)) {
      if (kind_named(row->tool)) add_kind(knowledge, row->gives.empty() ? row->target : row->gives);
    }
  }
  const std::size_t n = kinds_.size();
  capacity_.assign(n * n, {0, 0});
  reactions_.assign(n * n, {});
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto* on = knowledge.placement(kinds_[i].category, Predicate::On, kinds_[k].category);
      const auto* inside = knowledge.placement(kinds_[i].category, Predicate::Inside, kinds_[k].category);
      capacity_[i * n + k] = {on == nullptr ? 0 : on->capacity, inside == nullptr ? 0 : inside->capacity};
    }
  }
  read_reactions(knowledge, n, n);
}

void Rules::add_kind(const Knowledge& knowledge, const std::string& category) {
  const Category* known = knowledge.find(category);
  if (known == nullptr || kind_named(category)) return;
  Kind kind;
  kind.category = category;
  kind.movable = known->movable;
  kind.colors = known->colors;
  kind.materials = known->materials;
  const auto has = [&](std::string_view affordance) { return knowledge.has(category, affordance); };
  kind.pickupable = known->movable && has("pickupable");
  kind.openable = has("openable");
  kind.switchable = has("switchable");
  kind.sliceable = has("sliceable");
  kind.fillable = has("fillable");
  kind.coverable = has("coverable");
  kind.drain = has("drain");
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      kind.allowed[static_cast<std::size_t>(action.type)] =
          std::all_of(action.needs.begin(), action.needs.end(), [&](const ActionNeed& need) {
            if (need.kind == ActionNeed::Kind::Affordance) return has(need.affordance);
            return need.kind != ActionNeed::Kind::Varies || has(info(need.state).group);
          });
    }
  }
  kind.shuts_to_run = kind.openable && known->archetype == Archetype::Cabinet;
  for (const StateGroup& group : state_groups()) {
    if (has(group.affordance)) kind.groups.push_back(&group);
  }
  kinds_.push_back(std::move(kind));
}

void Rules::read_reactions(const Knowledge& knowledge, std::size_t tools, std::size_t targets) {
  for (std::size_t target = 0; target < targets; ++target) {
    for (std::size_t t = 0; t < kTreatments; ++t) {
      for (const Effect* row : knowledge.effects_on(kinds_[target].category, static_cast<Treatment>(t))) {
        const auto tool = kind_named(row->tool);
        if (!tool || tool->index() >= tools) continue;
        auto& known = reactions_[cell(*tool, KindId(target))];
        Reaction reaction;
        reaction.treatment = static_cast<Treatment>(t);
        reaction.needs = needs_of(*row);
        // As in simulation/, the first row of a tool, effect and target counts.
        if (!known.empty() && known.back().treatment == reaction.treatment) continue;
        if (reaction.treatment == Treatment::Slices) {
          reaction.piece = kind_named(row->gives.empty() ? row->target : row->gives);
          reaction.pieces = std::max(2, row->amount) - 1;  // the first piece is the whole itself
        } else if (!row->gives.empty()) {
          reaction.symbol = symbol_number(row->gives);
        }
        if ((reaction.needs & (kInside | kUnderTap)) != 0) make_room(KindId(target), 1, *tool);
        const bool attaching = reaction.treatment == Treatment::Attaches && capabilities_.attaching;
        if ((reaction.needs & kOn) != 0 || attaching) make_room(KindId(target), 0, *tool);
        known.push_back(reaction);
      }
    }
  }
}

void Rules::make_room(KindId thing, std::size_t relation, KindId place) {
  if (!kind(thing).movable) return;
  auto& fits = capacity_[cell(thing, place)][relation];
  fits = std::max(fits, 1);
}

std::size_t Rules::cell(KindId first, KindId second) const { return first.index() * kinds_.size() + second.index(); }

std::optional<KindId> Rules::kind_named(std::string_view category) const {
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i].category == category) return KindId(i);
  }
  return std::nullopt;
}

int Rules::capacity(KindId thing, Predicate relation, KindId place) const {
  return capacity_[cell(thing, place)][relation == Predicate::Inside ? 1 : 0];
}

const Reaction* Rules::reaction(KindId tool, Treatment treatment, KindId thing) const {
  for (const Reaction& reaction : reactions(tool, thing)) {
    if (reaction.treatment == treatment) return &reaction;
  }
  return nullptr;
}

const std::vector<Reaction>& Rules::reactions(KindId tool, KindId thing) const { return reactions_[cell(tool, thing)]; }

std::optional<SubstanceId> Rules::symbol_named(std::string_view symbol) const {
  const auto found = std::find(symbols_.begin(), symbols_.end(), symbol);
  if (found == symbols_.end()) return std::nullopt;
  return SubstanceId(static_cast<std::size_t>(found - symbols_.begin()));
}

SubstanceId Rules::symbol_number(const std::string& symbol) {
  if (const auto known = symbol_named(symbol)) return *known;
  symbols_.push_back(symbol);
  return SubstanceId(symbols_.size() - 1);
}

}  // namespace unietp::symbolic
