#include "simulation/mode_episode.h"

#include <algorithm>

namespace unietp {
namespace {

FailureDetail refusal(FailureCause cause, FailureReference object = {}, FailureReference other = {}) {
  return {cause, std::move(object), std::move(other), {}};
}

/// Views are sorted by id.
const VisibleObject* find_in(const std::vector<VisibleObject>& view, std::string_view id) {
  const auto found =
      std::lower_bound(view.begin(), view.end(), id,
                       [](const VisibleObject& object, std::string_view wanted) { return object.id < wanted; });
  return found == view.end() || found->id != id ? nullptr : &*found;
}

}  // namespace

bool ModeEpisode::over() const {
  const StepLimits limits = limits_of(mode_);
  return world_.stopped() || steps_ >= limits.steps || failures_ >= limits.failures;
}

const std::vector<VisibleObject>& ModeEpisode::visible() const {
  return mode_ == Mode::M3 ? world_.pictured() : world_.visible();
}

const VisibleObject* ModeEpisode::in_view(std::string_view id) const { return find_in(visible(), id); }

bool ModeEpisode::was_seen(std::string_view id) const {
  return std::any_of(moments_seen_.rbegin(), moments_seen_.rend(),
                     [&](MomentId moment) { return world_.at(moment).shows(id); });
}

const VisibleObject* ModeEpisode::best_match(const PixelBox& box) const {
  const VisibleObject* best = nullptr;
  double most = kLeastOverlap;
  for (const VisibleObject& object : visible()) {
    const double overlap = overlap_of(box, object.box);
    if (overlap <= most) continue;
    most = overlap;
    best = &object;
  }
  return best;
}

std::optional<FailureCause> ModeEpisode::refusal_cause(const ActionInfo& about, const std::string& id) const {
  const Node* node = mode_ == Mode::M2 ? world_.find(id) : nullptr;
  if (node == nullptr || !node->movable || world_.holds(id)) return std::nullopt;
  if (about.type == ActionType::GoTo) {
    if (world_.shows(id)) return std::nullopt;
    return FailureCause::NotInView;
  }
  if (world_.shows(id) || was_seen(id)) return std::nullopt;
  return FailureCause::NotSeenYet;
}

std::variant<Action, FailureDetail> ModeEpisode::action_of(const Command& command) const {
  const auto type = action_named(command.action);
  if (!type) return refusal(FailureCause::UnknownAction, unknown_name('"' + command.action + '"'));
  const ActionInfo& about = info(*type);
  if (!offers(about, mode_)) {
    return refusal(FailureCause::ActionNotOffered, in_words(name_of(mode_)), in_words(about.name));
  }
  Action action{*type, {}};
  for (const Argument& argument : command.args) {
    if (mode_ != Mode::M3 && argument.box) {
      return refusal(FailureCause::NamedByBox, in_words(name_of(mode_)));
    }
    if (mode_ == Mode::M3 && !argument.box) {
      const bool room = about.argument == ActionArgument::ObjectOrRoom && world_.find_room(argument.id);
      if (!room) return refusal(FailureCause::NamedById, in_words(name_of(mode_)));
    }
    if (!argument.box) {
      if (const auto cause = refusal_cause(about, argument.id)) return refusal(*cause);
      action.args.push_back(argument.id);
      continue;
    }
    const VisibleObject* object = best_match(*argument.box);
    if (object == nullptr) return refusal(FailureCause::NoObjectAtBox);
    action.args.push_back(object->id);
  }
  return action;  // the world checks the number of arguments
}

Outcome ModeEpisode::step(const Command& command) {
  if (over()) return outcome_in(mode_, failed(FailureCause::EpisodeEnded));
  if (mode_ == Mode::M2 && (moments_seen_.empty() || moments_seen_.back() != world_.moment()))
    moments_seen_.push_back(world_.moment());
  const auto action = action_of(command);
  const auto* refusal = std::get_if<FailureDetail>(&action);
  const ActionResult result = refusal != nullptr ? failed(*refusal) : world_.step(std::get<Action>(action));
  ++steps_;
  if (!result.success) ++failures_;
  return outcome_in(mode_, result);
}

std::optional<Command> ModeEpisode::command_for(const Action& action) const {
  Command command = by_ids(action);
  if (mode_ == Mode::M3) {
    for (Argument& argument : command.args) {
      if (info(action.type).argument == ActionArgument::ObjectOrRoom && world_.find_room(argument.id)) continue;
      const VisibleObject* object = in_view(argument.id);
      if (object == nullptr || best_match(object->box) != object) return std::nullopt;
      argument = {"", object->box};
    }
  }
  if (std::holds_alternative<FailureDetail>(action_of(command))) return std::nullopt;
  return command;
}

}  // namespace unietp
