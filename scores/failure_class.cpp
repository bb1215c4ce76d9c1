#include "scores/failure_class.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "environment/answer.h"
#include "scene/action.h"
#include "scores/goal_objects.h"

namespace unietp {
namespace {

constexpr std::array<std::string_view, 8> kGroups{"errored",     "output",    "stop",         "limit",
                                                  "exploration", "grounding", "precondition", "goal"};

/// An action of the whole episode with its reply.
struct Acted {
  const EpisodeStep* step;
  const ReplayedAction* action;
};

/// The rules, one function a group; each gives the kind that fits, if one does.
class Rules {
 public:
  Rules(const EpisodeRecord& record, const ReplayedEpisode& replayed, const EnvironmentTask& task)
      : record_(record), replayed_(replayed), objects_(goal_objects(task)) {
    for (std::size_t i = 0; i < replayed.steps.size(); ++i) {
      for (const ReplayedAction& action : replayed.steps[i].actions) actions_.push_back({&record.steps[i], &action});
    }
    failed_ = std::count_if(actions_.begin(), actions_.end(), [](const Acted& d) { return !d.action->record.success; });
  }

  std::vector<FailureClass> all() const {
    std::vector<FailureClass> found;
    if (record_.end == EpisodeOutcome::Errored)
      return {{FailureGroup::Errored, record_.error ? std::string(name_of(record_.error->kind)) : "unknown"}};
    if (replayed_.success) return found;
    const auto add = [&](FailureGroup group, std::vector<std::string> kinds) {
      for (std::string& kind : kinds) found.push_back({group, std::move(kind)});
    };
    add(FailureGroup::Output, output());
    add(FailureGroup::Stop, stop());
    add(FailureGroup::Limit, limit());
    add(FailureGroup::Exploration, exploration());
    add(FailureGroup::Grounding, grounding());
    add(FailureGroup::Precondition, precondition());
    add(FailureGroup::Goal, goal());
    return found;
  }

 private:
  bool at_limit() const { return record_.end != EpisodeOutcome::Stop; }

  /// At least half of the actions, or of those failed that ended the episode, are no actions at all.
  std::vector<std::string> output() const {
    std::array<std::ptrdiff_t, 4> faults{};
    std::ptrdiff_t all = 0;
    for (const Acted& done : actions_) {
      if (const auto fault = output_fault(*done.step, done.action->record)) {
        ++faults[static_cast<std::size_t>(*fault)];
        ++all;
      }
    }
    const auto of = record_.end == EpisodeOutcome::Failures ? failed_ : static_cast<std::ptrdiff_t>(actions_.size());
    if (all == 0 || 2 * all < of) return {};
    const auto most = std::max_element(faults.begin(), faults.end()) - faults.begin();
    return {std::string(name_of(static_cast<OutputFault>(most)))};
  }

  std::vector<std::string> stop() const {
    const bool was_reached =
        std::any_of(actions_.begin(), actions_.end(), [](const Acted& done) { return done.action->reached; });
    return was_reached ? std::vector<std::string>{"missed"} : std::vector<std::string>();
  }

  /// The same one to four actions, three times or more, at the end.
  bool loops() const {
    constexpr std::size_t kLongest = 4, kTimes = 3, kLeast = 6;
    const auto same = [](const Acted& a, const Acted& b) {
      return a.action->record.command == b.action->record.command &&
             a.action->record.success == b.action->record.success;
    };
    for (std::size_t length = 1; length <= kLongest; ++length) {
      const std::size_t needed = std::max(kLeast, length * kTimes);
      if (actions_.size() < needed) continue;
      bool repeats = true;
      for (std::size_t i = actions_.size() - needed; i + length < actions_.size(); ++i)
        repeats = repeats && same(actions_[i], actions_[i + length]);
      if (repeats) return true;
    }
    return false;
  }

  /// How often the most frequent kind of failure came. Faults of the output count as kinds when `with_output`.
  std::pair<std::string, std::ptrdiff_t> usual_failure(bool with_output) const {
    std::map<std::string, std::ptrdiff_t> counts;
    for (const Acted& done : actions_) {
      if (done.action->record.success) continue;
      const auto fault = output_fault(*done.step, done.action->record);
      if (!fault) ++counts[done.action->record.failure];
      if (fault && with_output) ++counts["output: " + std::string(name_of(*fault))];
    }
    std::pair<std::string, std::ptrdiff_t> most{"", 0};
    for (const auto& [failure, count] : counts) {
      if (count > most.second) most = {failure, count};
    }
    return most;
  }

  std::vector<std::string> limit() const {
    if (!at_limit()) return {};
    std::vector<std::string> kinds;
    if (loops()) kinds.emplace_back("loop");
    if (record_.end == EpisodeOutcome::Failures) {
      if (2 * usual_failure(true).second < failed_) kinds.emplace_back("failures");
    } else if (!actions_.empty()) {
      // Still getting on: more of the goal is met than three quarters of the way.
      const double before = actions_[std::max<std::size_t>(actions_.size() * 3 / 4, 1) - 1].action->progress;
      if (replayed_.progress > before) kinds.emplace_back("steps");
    }
    return kinds;
  }

  /// Nothing that a quantifier of the goal ranges over was ever in a picture.
  std::vector<std::string> exploration() const {
    if (replayed_.targets_shown) return {};
    return {"target_not_shown"};
  }

  std::vector<std::string> grounding() const {
    bool instance = false, right = false, other = false;
    std::ptrdiff_t missed = 0;
    for (const Acted& done : actions_) {
      const auto type = action_named(done.action->record.command.action);
      if (done.action->record.failure == name_of(Failure::NoObjectThere)) ++missed;
      if (!type || !done.action->record.success || done.action->object.empty()) continue;
      const bool takes = *type == ActionType::PickUp;
      const ActionClass group = info(*type).group;
      if (group != ActionClass::Manipulation && group != ActionClass::Composite) continue;
      const std::string& id = done.action->object;
      bool is_referent = false, is_alike = false;
      for (const GoalObjects& objects : objects_) {
        is_referent = is_referent || objects.referents.contains(id);
        is_alike = is_alike || objects.alike.contains(id);
      }
      instance = instance || (is_alike && !is_referent);
      right = right || (is_referent && *type != ActionType::PlaceOn && *type != ActionType::PlaceIn);
      other = other || (takes && !is_referent && !is_alike);
    }
    std::vector<std::string> kinds;
    if (instance) kinds.emplace_back("wrong_instance");
    if (other && !right) kinds.emplace_back("wrong_category");
    if (missed > 0 && 2 * missed >= failed_) kinds.emplace_back("box");
    return kinds;
  }

  /// The same need was not met three times or more, and in half of what failed.
  std::vector<std::string> precondition() const {
    const auto [failure, count] = usual_failure(false);
    if (count < 3 || 2 * count < failed_ || failure == name_of(Failure::NoObjectThere)) return {};
    return {failure};
  }

  std::vector<std::string> goal() const {
    std::vector<std::string> kinds;
    const auto add = [&](const std::string& kind) {
      if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
    };
    const std::vector<bool>& end = actions_.empty() ? replayed_.parts_at_start : actions_.back().action->parts;
    bool some = false, undone = false, count = false;
    for (std::size_t i = 0; i < replayed_.parts.size(); ++i) {
      const ScoredPartKind kind = replayed_.parts[i].kind;
      const auto was = [&](const Acted& done) { return done.action->parts[i]; };
      const bool was_met = std::any_of(actions_.begin(), actions_.end(), was);
      some = some || (end[i] && !replayed_.parts_at_start[i]);
      if (end[i]) continue;
      if (kind == ScoredPartKind::Order && replayed_.parts_lost[i]) add("order_lost");
      if (kind == ScoredPartKind::Constraint && replayed_.parts_lost[i]) add("constraint_broken");
      count = count || (kind == ScoredPartKind::Count && replayed_.progress > replayed_.start_progress);
      undone = undone || (kind != ScoredPartKind::Constraint && was_met) || replayed_.parts_at_start[i];
    }
    if (count) add("count");
    if (undone) add("side_effect");
    if (some || replayed_.progress > replayed_.start_progress) add("partial");
    if (kinds.empty()) add("untouched");
    return kinds;
  }

  const EpisodeRecord& record_;
  const ReplayedEpisode& replayed_;
  std::vector<GoalObjects> objects_;
  std::vector<Acted> actions_;
  std::ptrdiff_t failed_ = 0;
};

}  // namespace

std::string_view name_of(FailureGroup group) { return kGroups[static_cast<std::size_t>(group)]; }

std::string to_text(const FailureClass& failure) { return std::string(name_of(failure.group)) + ": " + failure.kind; }

std::optional<FailureClass> failure_class_of(std::string_view text) {
  for (std::size_t i = 0; i < kGroups.size(); ++i) {
    const std::string start = std::string(kGroups[i]) + ": ";
    if (text.starts_with(start) && text.size() > start.size())
      return FailureClass{static_cast<FailureGroup>(i), std::string(text.substr(start.size()))};
  }
  return std::nullopt;
}

std::string_view name_of(OutputFault fault) {
  static constexpr std::array<std::string_view, 4> kNames{"no_json", "unknown_action", "bad_argument", "truncated"};
  return kNames[static_cast<std::size_t>(fault)];
}

std::optional<OutputFault> output_fault(const EpisodeStep& step, const EpisodeAction& action) {
  if (!step.unreadable.empty()) {
    if (step.finish == "length") return OutputFault::Truncated;
    if (step.unreadable == kExpectedAction) return OutputFault::UnknownAction;
    const bool has_none = step.unreadable == kExpectedJson || step.unreadable == kExpectedOneObject;
    return has_none ? OutputFault::NoJson : OutputFault::BadArgument;
  }
  if (action.failure == name_of(Failure::InvalidAction) || action.failure == name_of(Failure::NotOffered))
    return OutputFault::UnknownAction;
  if (action.failure == name_of(Failure::InvalidArgument)) return OutputFault::BadArgument;
  return std::nullopt;
}

std::vector<FailureClass> failure_classes(const EpisodeRecord& record, const ReplayedEpisode& replayed,
                                          const EnvironmentTask& task) {
  return Rules(record, replayed, task).all();
}

FailureClass premature_stop() { return {FailureGroup::Stop, "premature"}; }

int successful_actions(const ReplayedEpisode& replayed) {
  int good = 0;
  for (const ReplayedStep& step : replayed.steps) {
    for (const ReplayedAction& action : step.actions) good += action.record.success ? 1 : 0;
  }
  return good;
}

bool too_early(int successful_actions, std::optional<int> shortest) {
  return shortest ? 2 * successful_actions < *shortest : successful_actions <= 1;
}

bool missed_stop(const EpisodeRecord& record, const ReplayedEpisode& replayed) {
  if (record.end == EpisodeOutcome::Stop || record.end == EpisodeOutcome::Errored) return false;
  return std::any_of(replayed.steps.begin(), replayed.steps.end(), [](const ReplayedStep& step) {
    return std::any_of(step.actions.begin(), step.actions.end(), [](const ReplayedAction& a) { return a.reached; });
  });
}

}  // namespace unietp
