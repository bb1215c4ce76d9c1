#include "simulation/mode_episode.h"

#include <algorithm>
#include <cctype>

namespace unietp {
namespace {

Outcome refusal(Failure failure, std::string feedback) { return {false, failure, std::move(feedback)}; }

/// "coffee_machine_2" as "the coffee machine".
std::string described(std::string_view id) {
  std::string name(id.substr(0, id.find_last_not_of("0123456789") + 1));
  if (!name.empty() && name.back() == '_') name.pop_back();
  std::replace(name.begin(), name.end(), '_', ' ');
  return "the " + name;
}

/// The sentence with the ids of the world's objects described.
std::string without_ids(const std::string& sentence, const World& world) {
  const auto in_id = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::string text;
  for (std::size_t at = 0; at < sentence.size();) {
    std::size_t end = at;
    while (end < sentence.size() && in_id(sentence[end])) ++end;
    const std::string word = sentence.substr(at, std::max<std::size_t>(end - at, 1));
    text += world.find(word) != nullptr ? described(word) : word;
    at += word.size();
  }
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
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
  return std::any_of(looked_at_.rbegin(), looked_at_.rend(),
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

std::optional<Outcome> ModeEpisode::refused(const ActionInfo& about, const std::string& id) const {
  const Node* node = mode_ == Mode::M2 ? world_.find(id) : nullptr;
  if (node == nullptr || !node->movable || world_.holds(id)) return std::nullopt;
  if (about.type == ActionType::GoTo) {
    if (world_.shows(id)) return std::nullopt;
    return refusal(Failure::NotInView, id + " is not in view; go to a room, to furniture, or to what you see.");
  }
  if (world_.shows(id) || was_seen(id)) return std::nullopt;
  return refusal(Failure::NotSeenYet, "You have not seen " + id + " yet.");
}

std::variant<Action, Outcome> ModeEpisode::action_of(const Command& command) const {
  const auto type = action_named(command.action);
  if (!type) return refusal(Failure::InvalidAction, "There is no action \"" + command.action + "\".");
  const ActionInfo& about = info(*type);
  if (!offers(about, mode_)) {
    return refusal(Failure::NotOffered,
                   std::string(name_of(mode_)) + " does not offer " + std::string(about.name) + ".");
  }
  Action action{*type, {}};
  for (const Argument& argument : command.args) {
    if (mode_ != Mode::M3 && argument.box) {
      return refusal(Failure::InvalidArgument,
                     "In " + std::string(name_of(mode_)) + " objects are named by id, not by a box.");
    }
    if (mode_ == Mode::M3 && !argument.box) {
      const bool room = about.argument == ActionArgument::ObjectOrRoom && world_.find_room(argument.id);
      if (!room) return refusal(Failure::InvalidArgument, "In M3 objects are named by boxes in the picture.");
    }
    if (!argument.box) {
      if (auto no = refused(about, argument.id)) return *no;
      action.args.push_back(argument.id);
      continue;
    }
    const VisibleObject* object = best_match(*argument.box);
    if (object == nullptr) return refusal(Failure::NoObjectThere, "There is no object at the given box.");
    action.args.push_back(object->id);
  }
  return action;  // too few or too many arguments are for the world to refuse
}

Outcome ModeEpisode::told(Outcome outcome) const {
  if (mode_ == Mode::M3) outcome.feedback = without_ids(outcome.feedback, world_);
  return outcome;
}

Outcome ModeEpisode::step(const Command& command) {
  if (over()) return refusal(Failure::InvalidAction, "The episode has ended.");
  if (mode_ == Mode::M2 && (looked_at_.empty() || looked_at_.back() != world_.moment()))
    looked_at_.push_back(world_.moment());
  const auto action = action_of(command);
  const auto* denied = std::get_if<Outcome>(&action);
  const Outcome outcome = denied != nullptr ? *denied : world_.step(std::get<Action>(action));
  ++steps_;
  if (!outcome.success) ++failures_;
  return told(outcome);
}

std::optional<Command> ModeEpisode::said(const Action& action) const {
  Command command = by_ids(action);
  if (mode_ == Mode::M3) {
    for (Argument& argument : command.args) {
      if (info(action.type).argument == ActionArgument::ObjectOrRoom && world_.find_room(argument.id)) continue;
      const VisibleObject* object = in_view(argument.id);
      if (object == nullptr || best_match(object->box) != object) return std::nullopt;
      argument = {"", object->box};
    }
  }
  if (std::holds_alternative<Outcome>(action_of(command))) return std::nullopt;
  return command;
}

}  // namespace unietp
