#include "expert/mode_run.h"

#include <algorithm>

#include "expert/execution.h"
#include "expert/exploration.h"

namespace unietp {
namespace {

/// What came of doing actions one after the other, whether they succeed or not.
struct Run {
  ModeEpisode episode;
  std::vector<Action> done;  // those that succeeded
  std::vector<Delta> changes;

  void go_on(const Action& action) {
    if (!do_in(episode, action).success) return;
    done.push_back(action);
    changes.push_back(episode.world().changes());
  }
};

class Shortener {
 public:
  Shortener(const Formula& goal, const Scene& start, const ModeEpisode& episode)
      : goal_(goal), start_(start), episode_(episode) {}

  bool holds_after(const Run& run) const { return goal_holds(goal_, start_, run.changes); }

  /// Leaves out runs of this length wherever the goal holds without them; true when some went.
  bool shorten(std::vector<Action>& actions, std::size_t length) const {
    bool shorter = false;
    Run so_far{episode_, {}, {}};
    for (std::size_t i = 0; i + length < actions.size();) {  // the last is `stop`
      Run without = so_far;
      for (std::size_t k = i + length; k < actions.size(); ++k) without.go_on(actions[k]);
      if (holds_after(without)) {
        actions = std::move(without.done);
        shorter = true;
        continue;
      }
      so_far.go_on(actions[i]);
      ++i;
    }
    return shorter;
  }

 private:
  const Formula& goal_;
  const Scene& start_;
  const ModeEpisode& episode_;
};

}  // namespace

std::optional<Command> clearly_said(const ModeEpisode& episode, const Action& action) {
  auto command = episode.said(action);
  if (!command) return std::nullopt;
  const bool clear = std::all_of(command->args.begin(), command->args.end(), [](const Argument& argument) {
    return !argument.box || shows_clearly(*argument.box);
  });
  return clear ? command : std::nullopt;
}

Outcome do_in(ModeEpisode& episode, const Action& action) {
  const auto command = clearly_said(episode, action);
  if (!command) return {false, Failure::NotInView, to_text(action) + " cannot be said from here"};
  return episode.step(*command);
}

Demonstration record_in(ModeEpisode episode, const std::vector<Action>& actions) {
  Demonstration demonstration;
  demonstration.mode = episode.mode();
  for (const Action& action : actions) {
    const auto command = clearly_said(episode, action);
    if (!command) continue;
    DemonstrationStep step;
    step.visible = episode.visible();
    step.action = action;
    step.command = *command;
    step.outcome = episode.step(*command);
    if (step.outcome.success) step.changes = episode.world().changes();
    demonstration.steps.push_back(std::move(step));
  }
  return demonstration;
}

std::optional<std::vector<Action>> shortened(const Formula& goal, const Scene& start, const ModeEpisode& episode,
                                             std::vector<Action> actions) {
  constexpr std::size_t kLongestRun = 3;
  const Shortener shortener(goal, start, episode);
  Run all{episode, {}, {}};
  for (const Action& action : actions) all.go_on(action);
  if (!shortener.holds_after(all)) return std::nullopt;
  actions = std::move(all.done);
  // A shorter plan may make a step needless that was needed before.
  for (std::size_t length = 1; length <= kLongestRun;) length = shortener.shorten(actions, length) ? 1 : length + 1;
  return actions;
}

}  // namespace unietp
