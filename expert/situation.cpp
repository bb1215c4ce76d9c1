#include "expert/situation.h"

#include <algorithm>
#include <map>

namespace unietp {
namespace {

bool ranges_over_slices(const Formula& formula) {
  for (const auto& member : formula.domain.members) {
    if (member.slice) return true;
  }
  return std::any_of(formula.children.begin(), formula.children.end(), ranges_over_slices);
}

/// The first rule by which something in the scene cuts the category; nullptr when nothing does.
const Effect* slicing_of(const std::string& category, const Situation& situation) {
  for (const Effect* effect : situation.knowledge->effects_on(category, Treatment::Slices)) {
    if (!situation.places().of(effect->tool).empty()) return effect;
  }
  return nullptr;
}

void imagine_slices(Situation& situation) {
  Facts later = situation.facts();
  std::map<std::string, const Effect*> slicing;  // of each category; entities move when slices are added
  for (EntityIndex whole; whole < situation.first_imagined; ++whole) {
    const std::string& category = situation.entity(whole).category;
    const auto [known, fresh] = slicing.try_emplace(category, nullptr);
    if (fresh) known->second = slicing_of(category, situation);
    const Effect* effect = known->second;
    if (effect == nullptr) continue;
    const Node* node = situation.node(whole);
    if (node == nullptr || node->states.has(Predicate::Sliced)) continue;
    // The first piece keeps the whole's identity, so that a goal can still speak of it; the others are new.
    for (int ordinal = 0; ordinal < std::max(2, effect->amount) - 1; ++ordinal) {
      const auto slice = EntityIndex(situation.trace.entities.size());
      situation.trace.entities.push_back(Entity{
          Entity::Kind::Object, node->id + "/slice_" + std::to_string(ordinal + 1), effect->gives, node->category});
      situation.imagined.push_back({whole, ordinal});
      later.set_exists(slice);
      later.set(Predicate::SliceOf, slice, whole);
    }
  }
  situation.trace.states.push_back(std::move(later));
}

}  // namespace

bool has_operator(const Formula& formula, std::initializer_list<Formula::Op> operators) {
  return std::find(operators.begin(), operators.end(), formula.op) != operators.end() ||
         std::any_of(formula.children.begin(), formula.children.end(),
                     [operators](const Formula& part) { return has_operator(part, operators); });
}

Situation::Known& Situation::known(EntityIndex index) const {
  std::uint32_t& at = known_at_[index.index()];
  if (at == 0) {
    known_.emplace_back();
    at = static_cast<std::uint32_t>(known_.size());
  }
  return known_[at - 1];
}

const Node* Situation::node(EntityIndex index) const {
  if (is_imagined(index)) return node(slice(index).whole);
  auto& known = this->known(index).node;
  if (!known) {
    const auto place = places().find(entity(index).id);
    known = place ? &start->nodes[*place] : nullptr;
  }
  return *known;
}

EntityIndex Situation::shut_in(EntityIndex index) const {
  if (is_imagined(index)) return shut_in(slice(index).whole);
  auto& known = this->known(index).shut_in;
  if (!known) known = find(executions_->world().closed_around(entity(index).id)).value_or(kNobody);
  return *known;
}

double Situation::straight_m(EntityIndex index) const {
  if (is_imagined(index)) return straight_m(slice(index).whole);
  const Node* here = node(index);
  return here == nullptr ? 0.0 : std::min(executions_->world().straight_distance(*here), kFar_m);
}

double Situation::walk_m(EntityIndex index) const {
  if (is_imagined(index)) return walk_m(slice(index).whole);
  auto& known = this->known(index).walked_m;
  if (!known)
    known = node(index) == nullptr ? 0.0 : std::min(executions_->world().walking_distance(entity(index).id), kFar_m);
  return *known;
}

std::optional<EntityIndex> Situation::find(std::string_view id) const {
  const auto found = executions_->find(id);
  return found && *found < first_imagined ? found : std::nullopt;
}

Situation look_around(const ExecutionTree& executions, Mode mode) {
  Situation situation(executions);
  situation.start = &executions.start();
  situation.knowledge = &executions.knowledge();
  situation.profile = executions.profile();
  for (const ActionInfo& action : all_actions()) {
    if (!offers(action, mode)) situation.profile.actions[static_cast<std::size_t>(action.type)] = false;
  }
  situation.trace.states.push_back(executions.facts(executions.world()));
  situation.trace.entities = executions.entities_at_start();
  const std::size_t count = situation.trace.entities.size();
  situation.first_imagined = EntityIndex(count);
  situation.known_at_.resize(count);
  if (ranges_over_slices(executions.goal())) imagine_slices(situation);
  return situation;
}

}  // namespace unietp
