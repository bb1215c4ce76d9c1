#include "simulation/mode_episode.h"

#include <algorithm>

namespace unietp {
namespace {

FailureDetail refusal(FailureCause cause, FailureReference object = {}, FailureReference other = {}) {
  return {cause, std::move(object), std::move(other), {}};
}

/// Whether the command itself is wrong, whatever the state of the world.
bool is_invalid(FailureCause cause) {
  using enum FailureCause;
  return cause == MalformedAnswer || cause == UnknownAction || cause == ActionNotOffered || cause == TakesNoArgument ||
         cause == TakesOneArgument || cause == NoSuchObject || cause == NoSuchObjectOrRoom || cause == NamedByBox ||
         cause == NamedById;
}

bool tells_all_ids(const ModeRules& rules) { return rules.furniture && rules.movables; }
bool asks_what_was_seen(const ModeRules& rules) { return rules.boxes && !tells_all_ids(rules); }

}  // namespace

bool ModeEpisode::over() const {
  return world_.stopped() || steps_ >= rules_.limits.steps || failures_ >= rules_.limits.failures;
}

const std::vector<VisibleObject>& ModeEpisode::visible() const {
  return rules_.boxes ? world_.visible() : world_.pictured();
}

bool ModeEpisode::was_seen(std::string_view id) const {
  return seen_.contains(id) || std::any_of(moments_seen_.rbegin(), moments_seen_.rend(),
                                           [&](MomentId moment) { return world_.at(moment).shows(id); });
}

const std::string* ModeEpisode::best_match(const PixelBox& box) const {
  if (const std::string* object = world_.object_of_box(box))
    return object;  // none overlaps more, nor as much before it
  const std::string* best = nullptr;
  double most = kLeastOverlap;
  for (const VisibleObject& object : world_.pictured()) {
    const double overlap = overlap_of(box, object.box);
    if (overlap <= most) continue;
    most = overlap;
    best = &object.id;
  }
  return best;
}

/// Whether the agent has been told the id: of a list, of a view, or because it holds the object.
bool ModeEpisode::knows(const std::string& id) const {
  if (tells_all_ids(rules_)) return true;
  if (world_.holds(id) || world_.find_room(id) != nullptr) return true;
  const Node* node = world_.find(id);
  if (node != nullptr && (node->movable ? rules_.movables : rules_.furniture)) return true;
  return rules_.boxes && (world_.shows(id) || was_seen(id));
}

/// Whether `go_to` may take the agent to an object of which it knows the id.
bool ModeEpisode::may_go_to(const std::string& id) const {
  if (rules_.teleport == Teleport::Anything && knows(id)) return true;
  if (world_.holds(id)) return true;  // which the world refuses
  const Node* node = world_.find(id);
  if (node == nullptr) return false;
  if (rules_.teleport >= Teleport::Furniture && !node->movable && knows(id)) return true;
  return rules_.reach == Naming::Id && rules_.boxes && world_.shows(id);
}

std::optional<FailureDetail> ModeEpisode::refusal_of(const ActionInfo& about, const std::string& id) const {
  const bool goes = about.argument == ActionArgument::ObjectOrRoom;
  if (goes && world_.find_room(id) != nullptr) {
    if (rules_.teleport != Teleport::Nothing) return std::nullopt;
    return refusal(FailureCause::NoTeleport);
  }
  const bool by_id = naming_of(about, rules_) == Naming::Id || (goes && rules_.teleport >= Teleport::Furniture);
  if (!by_id) return refusal(FailureCause::NamedById, in_words(name_of(rules_.mode)));
  if (goes) {
    if (may_go_to(id)) return std::nullopt;
    return refusal(FailureCause::NotInView);
  }
  if (knows(id)) return std::nullopt;
  return refusal(FailureCause::NotSeenYet);
}

std::variant<Action, FailureDetail> ModeEpisode::action_of(const Command& command) const {
  const auto type = action_named(command.action);
  if (!type) return refusal(FailureCause::UnknownAction, unknown_name('"' + command.action + '"'));
  const ActionInfo& about = info(*type);
  if (!offers(about, rules_)) {
    return refusal(FailureCause::ActionNotOffered, in_words(name_of(rules_.mode)), in_words(about.name));
  }
  Action action{*type, {}};
  if (command.args.size() != (about.argument == ActionArgument::None ? 0U : 1U)) {
    action.args.resize(command.args.size());
    return action;  // which the world refuses
  }
  for (const Argument& argument : command.args) {
    if (!argument.box) {
      if (auto why = refusal_of(about, argument.id)) return std::move(*why);
      action.args.push_back(argument.id);
      continue;
    }
    if (naming_of(about, rules_) != Naming::Box)
      return refusal(FailureCause::NamedByBox, in_words(name_of(rules_.mode)));
    const std::string* id = best_match(*argument.box);
    if (id == nullptr) return refusal(FailureCause::NoObjectAtBox);
    action.args.push_back(*id);
  }
  return action;
}

bool ModeEpisode::may_name(const FailureReference& other) const {
  const Node* node = other.id.empty() ? nullptr : world_.find(other.id);
  if (node == nullptr || world_.holds(other.id) || (node->movable ? rules_.movables : rules_.furniture)) return true;
  return world_.pictured_from(world_.agent(), other.id).has_value();
}

Outcome ModeEpisode::count(ActionResult result) {
  if (!result.success && !may_name(result.detail.other)) result.detail.other = in_words("something");
  const bool counts = result.success || !rules_.invalid_is_free || !is_invalid(result.detail.cause);
  if (counts) ++steps_;
  if (counts && !result.success) ++failures_;
  return outcome_of(result, tells_all_ids(rules_));
}

Outcome ModeEpisode::step(const Command& command) {
  if (over()) return outcome_of(failed(FailureCause::EpisodeEnded), false);
  if (asks_what_was_seen(rules_) && (moments_seen_.empty() || moments_seen_.back() != world_.moment()))
    moments_seen_.push_back(world_.moment());
  auto action = action_of(command);
  if (const auto* refusal = std::get_if<FailureDetail>(&action)) return count(failed(*refusal));
  last_action_ = std::move(std::get<Action>(action));
  return count(world_.step(last_action_));
}

Outcome ModeEpisode::refuse(std::string_view expected) {
  if (over()) return outcome_of(failed(FailureCause::EpisodeEnded), false);
  return count(failed(FailureCause::MalformedAnswer, in_words(expected)));
}

std::optional<Command> ModeEpisode::command_for(const Action& action) const {
  const ActionInfo& about = info(action.type);
  Command command = by_ids(action);
  for (Argument& argument : command.args) {
    if (naming_of(about, rules_) != Naming::Box || !refusal_of(about, argument.id)) continue;
    const auto& box = world_.unique_box(argument.id);
    if (!box) return std::nullopt;
    argument = {"", *box};
  }
  if (std::holds_alternative<FailureDetail>(action_of(command))) return std::nullopt;
  return command;
}

void ModeEpisode::forget() {
  for (const MomentId moment : moments_seen_) {
    for (const VisibleObject& object : world_.at(moment).visible()) seen_.insert(object.id);
  }
  moments_seen_.clear();
  world_.forget();
}

ModeEpisode::ModeEpisode(World world, const ModeEpisode& other)
    : world_(std::move(world)),
      rules_(other.rules_),
      seen_(other.seen_),
      last_action_(other.last_action_),
      steps_(other.steps_),
      failures_(other.failures_) {}

ModeEpisode ModeEpisode::apart() const {
  ModeEpisode copy(world_.apart(), *this);
  for (const MomentId moment : moments_seen_) {
    for (const VisibleObject& object : world_.at(moment).visible()) copy.seen_.insert(object.id);
  }
  return copy;
}

}  // namespace unietp
