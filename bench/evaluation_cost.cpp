// What an evaluation costs beside the environment that it runs in, with a policy that answers at once: the stored
// demonstrations of a data set, read beforehand. For each mode, on one core: processor time of the environment alone
// (tasks read, episodes begun, replies executed), of playing the same episodes with everything recorded and scored, and
// of the whole evaluation with its results, each in a process of its own, by turns, and the least of three: a machine
// that others use takes more. Pictures of the report are left out. Then the peak memory of one repeat and of four.
//
//   build/release/bench/evaluation_cost out/benchmark
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/staged_folder.h"
#include "evaluation/evaluate.h"
#include "procedural/simulator_data.h"
#include "resources/resources.h"
#include "scores/write_results.h"

namespace {

using namespace unietp;
namespace fs = std::filesystem;

struct Cost {
  double processor_s = 0, peak_mb = 0;
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <class T>
T sound(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", format(result.error()).c_str());
  std::exit(2);
}

constexpr int kRounds = 3;

/// Seconds that `work` says it took, and the peak of memory, in a process of its own.
Cost measured(const std::function<double()>& work) {
  int ends[2];
  if (::pipe(ends) != 0) std::exit(2);
  const pid_t child = ::fork();
  if (child == 0) {
    const double seconds = work();
    const auto written = ::write(ends[1], &seconds, sizeof seconds);
    ::_exit(written == sizeof seconds ? 0 : 1);
  }
  ::close(ends[1]);
  Cost cost;
  rusage usage{};
  const auto got = ::read(ends[0], &cost.processor_s, sizeof cost.processor_s);
  ::close(ends[0]);
  int status = 0;
  if (::wait4(child, &status, 0, &usage) != child || status != 0 || got != sizeof cost.processor_s) std::exit(2);
  cost.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024;
  return cost;
}

/// Of each work the least seconds and the least peak of memory.
std::vector<Cost> least(const std::vector<std::function<double()>>& works) {
  std::vector<Cost> costs;
  for (const auto& work : works) costs.push_back(measured(work));
  for (int round = 1; round < kRounds; ++round) {
    for (std::size_t i = 0; i < works.size(); ++i) {
      const Cost cost = measured(works[i]);
      costs[i].processor_s = std::min(costs[i].processor_s, cost.processor_s);
      costs[i].peak_mb = std::min(costs[i].peak_mb, cost.peak_mb);
    }
  }
  return costs;
}

/// The replies of each task, in order.
using Replies = std::map<std::size_t, std::vector<std::string>>;

/// Says what was prepared.
class Prepared : public Policy {
 public:
  explicit Prepared(const Replies& replies) : replies_(replies) {}
  std::optional<NoReply> begin(const PlannedEpisode& episode, const Environment&) override {
    next_ = replies_.at(episode.position).begin();
    return std::nullopt;
  }
  PolicyAnswer next(const Environment&) override {
    PolicyReply reply;
    reply.text = *next_++;
    return reply;
  }

 private:
  const Replies& replies_;
  std::vector<std::string>::const_iterator next_;
};

struct Bench {
  fs::path dataset, scratch;
  std::shared_ptr<const Resources> resources;

  TaskSource tasks() const { return sound(TaskSource::open(dataset, simulator_data(resources))); }

  EpisodePlan plan(const TaskSource& source, Mode mode, int repeats) const {
    EpisodeSelection selection;
    selection.modes = {mode};
    selection.repeats = repeats;
    return sound(plan_episodes(source, selection, true));
  }

  Replies replies(Mode mode) const {
    const TaskSource source = tasks();
    const auto policy = built_in_policies({BuiltInPolicy::Kind::Replay, 0}, source, 0)();
    Replies replies;
    for (const PlannedEpisode& planned : plan(source, mode, 1).episodes) {
      auto environment = sound(Environment::make(sound(source.task(planned.position)), settings_for(mode)));
      (void)policy->begin(planned, environment);
      while (!environment.over()) {
        replies[planned.position].push_back(std::get<PolicyReply>(policy->next(environment)).text);
        (void)environment.step(replies[planned.position].back());
      }
    }
    return replies;
  }

  double environment_alone(Mode mode, const Replies& replies) const {
    const double begin = processor_seconds();
    const TaskSource source = tasks();
    for (const PlannedEpisode& planned : plan(source, mode, 1).episodes) {
      auto environment = sound(Environment::make(sound(source.task(planned.position)), settings_for(mode)));
      for (const std::string& reply : replies.at(planned.position)) (void)environment.step(reply);
    }
    return processor_seconds() - begin;
  }

  double evaluation(Mode mode, const Replies& replies, int repeats, bool with_results) const {
    const fs::path folder = scratch / "run";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const double begin = processor_seconds();
    const TaskSource source = tasks();
    const JudgingData judging{source, {}};
    EvaluationSetup setup;
    setup.program_version = setup.program_build = "bench";
    setup.knowledge_digest = setup.dataset.digest = std::string(64, '0');
    setup.dataset.name = "bench";
    setup.agent = {AgentKind::Policy, "replay"};
    setup.selection.modes = {mode};
    setup.selection.repeats = repeats;
    setup.settings = {{mode, settings_for(mode)}};
    const EpisodePlan episodes = plan(source, mode, repeats);
    EpisodeLog log = sound(EpisodeLog::open(folder));
    const PolicyMaker policies = [&] { return std::make_unique<Prepared>(replies); };
    auto watched = sound(WatchedEpisodes::begin(folder, judging));
    EvaluationOptions options;
    options.watcher = watched.watchers();
    (void)sound(evaluate(episodes, source, setup.settings, policies, log, options));
    (void)sound(write_evaluation(folder, setup, episodes, log, 0));
    if (with_results) (void)sound(write_results(folder, {judging, 1, &watched}));
    return processor_seconds() - begin;
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "expected a data set with demonstrations\n");
    return 2;
  }
  const DataFolders committed{UNIETP_SOURCE_DIR, fs::temp_directory_path() / "unietp-bench-cache"};
  auto reading = load_resources(committed);
  if (!reading.errors.empty()) return 2;
  Bench bench{argv[1], fs::temp_directory_path() / ("unietp-evaluation-cost-" + std::to_string(::getpid())),
              std::make_shared<const Resources>(std::move(reading.resources))};
  std::printf("mode  environment  played         with results\n");
  std::fflush(stdout);
  const std::vector<Mode> modes = bench.tasks().modes();
  for (const Mode mode : modes) {
    const Replies replies = bench.replies(mode);
    const auto costs = least({[&] { return bench.environment_alone(mode, replies); },
                              [&] { return bench.evaluation(mode, replies, 1, false); },
                              [&] { return bench.evaluation(mode, replies, 1, true); }});
    const Cost &alone = costs[0], &played = costs[1], &whole = costs[2];
    std::printf("%s    %8.2f s  %6.2f s %+3.0f %%  %6.2f s %+3.0f %%\n", std::string(name_of(mode)).c_str(),
                alone.processor_s, played.processor_s, 100 * (played.processor_s / alone.processor_s - 1),
                whole.processor_s, 100 * (whole.processor_s / alone.processor_s - 1));
    std::fflush(stdout);
  }
  const Replies replies = bench.replies(Mode::M1);
  const auto one = measured([&] { return bench.evaluation(Mode::M1, replies, 1, true); });
  const auto four = measured([&] { return bench.evaluation(Mode::M1, replies, 4, true); });
  std::printf("peak memory in M1: %.0f MB with one repeat, %.0f MB with four\n", one.peak_mb, four.peak_mb);
  std::error_code ignored;
  fs::remove_all(bench.scratch, ignored);
  return 0;
}
