#include "evaluation/evaluate.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include "core/pause.h"
#include "core/share_work.h"
#include "evaluation/episode_run.h"

namespace unietp {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kGiveUpAfter = 10;  // episodes that errored while none ended

/// What the threads of a run share.
class EvaluationRun {
 public:
  EvaluationRun(const EpisodePlan& plan, const TaskSource& tasks, const std::map<Mode, Settings>& settings,
                EpisodeLog& log, const EvaluationOptions& options)
      : plan_(plan), tasks_(tasks), settings_(settings), log_(log), options_(options) {
    EvaluationProgress& progress = report_.progress;
    progress.episodes = static_cast<int>(plan.episodes.size());
    for (const PlannedEpisode& planned : plan.episodes) {
      const auto ended = log.ended(planned.key);
      if (!ended || ended->errored) continue;
      ++progress.finished;
      progress.succeeded += ended->success ? 1 : 0;
    }
    progress.cost = log.cost();
  }

  void work(Policy& policy, EpisodeWatcher* watcher, const SharedSimulator& simulator) {
    while (const auto planned = next()) {
      const auto done = play(*planned, policy, watcher, simulator);
      if (!done) end(done.error());
    }
  }
  Result<EvaluationReport> report() && {
    if (error_) return *error_;
    report_.interrupted = stopped();
    return std::move(report_);
  }

 private:
  bool stopped() const { return options_.stop != nullptr && *options_.stop; }

  void end(const Error& error) {
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = error;
  }
  void give_up(const std::string& why) {
    const std::scoped_lock lock(mutex_);
    if (report_.given_up.empty()) report_.given_up = why;
  }

  const PlannedEpisode* next() {
    const std::scoped_lock lock(mutex_);
    while (next_ < plan_.episodes.size() && !error_ && report_.given_up.empty() && !stopped()) {
      const PlannedEpisode& planned = plan_.episodes[next_++];
      const auto ended = log_.ended(planned.key);
      if (!ended || ended->errored) return &planned;
    }
    return nullptr;
  }

  Result<Done> play(const PlannedEpisode& planned, Policy& policy, EpisodeWatcher* watcher,
                    const SharedSimulator& simulator) {
    const auto task = tasks_.task(planned.position);
    if (!task) return task.error();
    NoReply last;
    double wait_s = options_.first_wait_s;
    for (int attempt = 1;; ++attempt) {
      const auto begin = Clock::now();
      auto environment = Environment::make(*task, settings_.at(planned.key.mode), simulator);
      if (!environment) return environment.error();
      const double made_s = std::chrono::duration<double>(Clock::now() - begin).count();
      auto played = play_episode(planned, *environment, policy, watcher);
      if (auto* episode = std::get_if<PlayedEpisode>(&played)) {
        episode->timing.environment_s += made_s;
        if (watcher != nullptr) {
          if (auto done = watcher->end(episode->record, *environment); !done) return done;
        }
        return take(*episode);
      }
      last = std::get<NoReply>(std::move(played));
      if (last.hopeless) give_up(last.message);
      if (last.hopeless || last.stopped) return Done{};
      if (attempt >= options_.policy_attempts) break;
      const auto pause = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait_s));
      if (!pause_until(Clock::now() + pause, options_.stop)) return Done{};
      wait_s *= 2;
    }
    auto environment = Environment::make(*task, settings_.at(planned.key.mode));
    if (!environment) return environment.error();
    last.attempts = options_.policy_attempts;
    return take(unplayed(planned, *environment, last));
  }

  Result<Done> take(const PlayedEpisode& episode) {
    if (auto done = log_.add(episode.record, episode.timing); !done) return done;
    const std::scoped_lock lock(mutex_);
    EvaluationProgress& progress = report_.progress;
    if (episode.record.end == EpisodeOutcome::Errored) {
      ++progress.errored;
      if (progress.finished_now == 0 && progress.errored >= kGiveUpAfter && report_.given_up.empty())
        report_.given_up = "none of " + std::to_string(progress.errored) +
                           " episodes got its replies: " + episode.record.error->message;
    } else {
      ++progress.finished;
      ++progress.finished_now;
      progress.succeeded += episode.record.success ? 1 : 0;
    }
    progress.cost = log_.cost();
    progress.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    if (options_.progress) options_.progress(progress);
    return Done{};
  }

  const EpisodePlan& plan_;
  const TaskSource& tasks_;
  const std::map<Mode, Settings>& settings_;
  EpisodeLog& log_;
  const EvaluationOptions& options_;
  const Clock::time_point begin_ = Clock::now();
  std::mutex mutex_;  // of what follows
  std::size_t next_ = 0;
  EvaluationReport report_;
  std::optional<Error> error_;
};

template <class Value, class Name>
Result<Done> check_known(const std::string& option, const std::vector<std::string>& asked,
                         const std::vector<Value>& listing, const Name& name) {
  for (const std::string& one : asked) {
    const bool known =
        std::any_of(listing.begin(), listing.end(), [&](const Value& task) { return name(task) == one; });
    if (!known) return Error{Error::Kind::Usage, option, {}, "the data set has no task of " + one};
  }
  return Done{};
}

bool asks_for(const std::vector<std::string>& asked, const std::string& value) {
  return asked.empty() || std::find(asked.begin(), asked.end(), value) != asked.end();
}

}  // namespace

Result<EpisodePlan> plan_episodes(const TaskSource& tasks, const EpisodeSelection& selection, bool demonstrated) {
  const auto& listing = tasks.listing();
  auto known = check_known("--splits", selection.splits, listing, [](const TaskListing& task) { return task.split; });
  if (known)
    known = check_known("--simulators", selection.simulators, listing,
                        [](const TaskListing& task) { return task.simulator; });
  if (!known) return known.error();
  for (const std::string& id : selection.tasks) {
    if (!tasks.find(id)) return Error{Error::Kind::Usage, "--tasks", {}, "the data set has no task " + id};
  }
  EpisodePlan plan;
  int taken = 0;
  for (std::size_t position = 0; position < listing.size(); ++position) {
    const TaskListing& task = listing[position];
    if (!asks_for(selection.splits, task.split) || !asks_for(selection.simulators, task.simulator) ||
        !asks_for(selection.tasks, task.id))
      continue;
    if (selection.limit > 0 && taken == selection.limit) break;
    ++taken;
    for (const Mode mode : selection.modes) {
      const bool shown = std::find(task.modes.begin(), task.modes.end(), mode) != task.modes.end();
      plan.without_demonstration += shown ? 0 : 1;
      if (demonstrated && !shown) continue;
      for (int repeat = 1; repeat <= selection.repeats; ++repeat)
        plan.episodes.push_back({{task.id, mode, repeat}, position});
    }
  }
  if (!demonstrated) plan.without_demonstration = 0;
  if (plan.episodes.empty())
    return Error{Error::Kind::Usage, "selection", {}, "no task of the data set is left to evaluate on"};
  return plan;
}

Result<EvaluationReport> evaluate(const EpisodePlan& plan, const TaskSource& tasks,
                                  const std::map<Mode, Settings>& settings, const PolicyMaker& policy, EpisodeLog& log,
                                  const EvaluationOptions& options) {
  EvaluationRun run(plan, tasks, settings, log, options);
  run_on_threads(std::max(1, options.at_once), [&] {
    const auto own = policy();
    const auto watcher = options.watcher ? options.watcher() : nullptr;
    run.work(*own, watcher.get(), options.simulator ? options.simulator() : nullptr);
  });
  return std::move(run).report();
}

}  // namespace unietp
