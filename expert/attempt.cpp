#include "expert/attempt.h"

#include <algorithm>

#include "simulation/feedback.h"

namespace unietp {

std::string blocker_of(const ActionResult& result) {
  return result.detail.cause == FailureCause::JointBlocked ? result.detail.other.id : "";
}

Attempt::Attempt(ExecutionTree& executions, const Situation& situation, const Alternative& alternative,
                 const ExpertOptions& options)
    : executions_(&executions),
      situation_(&situation),
      alternative_(&alternative),
      options_(options),
      world_(executions.world()),
      come_(alternative.moments.size(), false) {
  trace_.states.push_back(executions.facts(world_));
  trace_.entities = executions.entities();
  mark_moments();
}

std::optional<EntityIndex> Attempt::current(EntityIndex entity) const {
  if (!situation_->is_imagined(entity)) return entity;
  const ImaginedSlice& slice = situation_->slice(entity);
  const std::string& whole = situation_->entity(slice.whole).id;
  int ordinal = 0;
  const auto& nodes = world_.nodes();
  for (std::size_t i = situation_->start->nodes.size(); i < nodes.size(); ++i) {  // it came after all that was there
    const Node& node = nodes[i];
    if (node.slice_of != whole || ordinal++ != slice.ordinal) continue;
    for (EntityIndex index = situation_->first_imagined; index.index() < trace_.entities.size(); ++index) {
      if (trace_.entities[index].id == node.id) return index;
    }
  }
  return std::nullopt;
}

bool Attempt::holds(const Literal& literal) const {
  Literal now = literal;
  const auto subject = current(literal.subject), object = current(literal.object);
  if (!subject || !object) return !literal.positive;
  now.subject = *subject;
  now.object = *object;
  return holds_in(now, trace_.states.back());
}

const Node* Attempt::node(EntityIndex entity) const {
  const std::string id = id_of(entity);
  return id.empty() ? nullptr : world_.find(id);
}

std::string Attempt::id_of(EntityIndex entity) const {
  const auto index = entity == kNobody ? std::nullopt : current(entity);
  return index ? trace_.entities[*index].id : std::string();
}

bool Attempt::is_held(std::string_view id) const {
  const auto& held = world_.agent().held;
  return std::find(held.begin(), held.end(), id) != held.end();
}

void Attempt::give_up(Action action, RejectionReason reason, std::string text) {
  trouble_ = Trouble{reason, std::move(action), Failure::None, std::move(text)};
  exhausted_ = true;
}

bool Attempt::act(ActionType type, const std::string& argument) { return act(Action{type, {argument}}); }

bool Attempt::act(Action action) {
  if (exhausted_) return false;
  const auto last_before_stop = static_cast<std::size_t>(std::max(0, options_.max_steps - 1));
  if (actions_.size() >= last_before_stop) {
    give_up(std::move(action), RejectionReason::TooManySteps,
            "needs more than " + std::to_string(options_.max_steps) + " steps");
    return false;
  }
  const World back = world_;
  const std::size_t states_before = trace_.states.size();
  const std::vector<bool> come_before = come_;
  const ActionResult outcome = executions_->step(world_, action);
  if (outcome.success) {
    trace_.entities.follow(executions_->entities());
    if (passes_all()) {
      actions_.push_back(std::move(action));
      return true;
    }
    trace_.states.resize(states_before);
    come_ = come_before;
    world_ = back;
    trouble_ = Trouble{RejectionReason::ActionFailed, action, Failure::None,
                       to_text(action) + " would break what has to be kept"};
  } else {
    trouble_ = Trouble{RejectionReason::ActionFailed, action, outcome.failure,
                       to_text(action) + ": " + feedback_with_ids(outcome.detail), blocker_of(outcome)};
  }
  if (++failures_ > options_.max_failures) {
    give_up(std::move(action), RejectionReason::TooManyFailures, "the last of them " + trouble_->text);
  }
  return false;
}

/// Takes in one more moment; false when it breaks a truth to keep.
bool Attempt::passes(const Facts& facts) {
  trace_.states.push_back(facts);
  if (!keeps_hold()) return false;
  mark_moments();
  return true;
}

/// Takes in all moments that the last action led through.
bool Attempt::passes_all() {
  const auto& passed = world_.passed();
  if (passed.empty()) return passes(executions_->facts(world_));
  return std::all_of(passed.begin(), passed.end(),
                     [this](const PassedMoment& one) { return passes(executions_->facts(one.moment)); });
}

bool Attempt::keeps_hold() const {
  const auto comes_now = [this](std::size_t moment) {
    const auto& literals = alternative_->moments[moment].literals;
    return std::all_of(literals.begin(), literals.end(), [this](const Literal& literal) { return holds(literal); });
  };
  for (const MaintenanceGoal& keep : alternative_->maintained) {
    if (keep.until != MaintenanceGoal::kAlways) {
      if (come_[keep.until] || (!keep.inclusive && comes_now(keep.until))) continue;
    }
    Assignment assignment = keep.assignment;
    bool all_exist = true;
    for (auto& [name, entity] : assignment) {
      const auto index = current(entity);
      all_exist = all_exist && index;
      entity = index.value_or(entity);
    }
    if (all_exist && !holds_in(keep.formula, trace_, trace_.states.size() - 1, assignment)) return false;
  }
  return true;
}

void Attempt::mark_moments() {
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::size_t m = 0; m < come_.size(); ++m) {
      if (come_[m]) continue;
      const Moment& moment = alternative_->moments[m];
      const bool in_order =
          std::all_of(moment.after.begin(), moment.after.end(), [this](std::size_t earlier) { return come_[earlier]; });
      const bool here = std::all_of(moment.literals.begin(), moment.literals.end(),
                                    [this](const Literal& literal) { return holds(literal); });
      if (in_order && here) come_[m] = changed = true;
    }
  }
}

}  // namespace unietp
