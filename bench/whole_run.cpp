// Whole runs as a user starts them: the benchmark in M1, M2 and M3, the training set in M1 and M2, and the proof of
// both. Each in a process of its own, so that its clock, its processor time and its peak memory are its own. Before
// them the whole path of a task in M1 on one core, in reference works: its ratio to the first whole path ever measured.
//
//   build/release/bench/whole_run                 # 536 and 9,000 tasks, two threads
//   build/release/bench/whole_run --count 200     # a sample: 200 tasks of each
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include "bench/reference_work.h"
#include "dataset/configuration_json.h"
#include "rewording/check_text.h"
#include "run/run.h"
#include "validator/validate.h"

namespace {

using namespace unietp;
namespace fs = std::filesystem;

/// Tasks in the time of one reference work, M1 alone, run of 200, on the version that first had the whole path
/// (docs/evidence.md).
constexpr double kFirstTasksAReference = 1.7;

struct Options {
  int count = 0;  // 0: the full sets
  int threads = 2;
  fs::path folder;
};

struct Cost {
  double clock_s = 0, processor_s = 0, peak_mb = 0;
  bool sound = false;
};

/// Runs the work in a process of its own; true of it: nothing was wrong.
Cost measured(const std::string& what, const std::function<bool()>& work) {
  std::printf("%s\n", what.c_str());
  std::fflush(stdout);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    const bool sound = work();
    std::fflush(stdout);
    ::_exit(sound ? 0 : 1);
  }
  Cost cost;
  int status = 0;
  rusage usage{};
  if (child < 0 || ::wait4(child, &status, 0, &usage) != child) return cost;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  cost.clock_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  cost.processor_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  cost.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024;
  cost.sound = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  std::printf("  %.1f s by the clock, %.1f s of processor time, at most %.0f MB%s\n", cost.clock_s, cost.processor_s,
              cost.peak_mb, cost.sound ? "" : "  NOT SOUND");
  return cost;
}

DataFolders committed() { return {UNIETP_SOURCE_DIR, fs::temp_directory_path() / "unietp-bench-cache"}; }

/// Prints the error; returns false.
bool print_error(const Error& error) {
  std::printf("  %s\n", format(error).c_str());
  return false;
}

/// Makes a data set and prints its yield and the share of each stage in what all threads spent.
bool make(const RunConfiguration& configuration, const fs::path& out, int threads) {
  const auto reading = load_resources(committed());
  if (!reading.errors.empty()) return print_error(reading.errors.front());
  StageCosts costs;
  RunOptions options;
  options.out = out;
  options.licenses = committed().licenses();
  options.threads = threads;
  options.costs = &costs;
  const double start = processor_seconds();
  const auto report = run_generation(configuration, reading.resources, options);
  if (!report) return print_error(report.error());
  const double seconds = processor_seconds() - start;
  std::printf("  %d of %d tasks from %d candidates (yield %.0f %%), %.1f tasks a second of processor time\n",
              report->tasks, report->asked, report->candidates, 100.0 * report->tasks / report->candidates,
              report->tasks / seconds);
  if (threads == 1) {
    const double ours = report->tasks / seconds * reference_seconds();
    std::printf("  %.1f tasks a reference work: %.1f times the first whole path\n", ours, ours / kFirstTasksAReference);
  }
  double all = 0;
  for (const double stage : costs.seconds) all += stage;
  std::printf("  shares:");
  for (std::size_t i = 0; i < kStageCount; ++i)
    std::printf(" %s %.1f %%", std::string(name_of(static_cast<Stage>(i))).c_str(), 100 * costs.seconds[i] / all);
  std::printf("\n");
  return report->tasks == report->asked;
}

bool prove(const fs::path& folder, const std::vector<fs::path>& against, int threads) {
  const auto reading = load_backends(committed());
  if (!reading.errors.empty()) return print_error(reading.errors.front());
  const auto digest = knowledge_digest(committed());
  if (!digest) return print_error(digest.error());
  std::vector<ValidationBackend> backends;
  for (const auto& backend : reading.backends) backends.push_back({&backend.knowledge, &backend.profile});
  ValidationOptions options;
  options.threads = threads;
  options.against = against;
  options.check_text = [&reading](const StatedGoal& stated) {
    return check_text(stated, reading.backends[static_cast<std::size_t>(stated.simulator)]);
  };
  const auto report = validate_dataset(folder, backends, *digest, options);
  std::printf("  %d of %d proven, %d demonstrations, %d steps, %d altered plans\n", report.counts.proven,
              report.counts.tasks, report.counts.demonstrations, report.counts.steps, report.counts.altered_plans);
  for (const Problem& problem : report.problems) (void)print_error(problem.error);
  return report.sound();
}

int run(const Options& options) {
  auto benchmark = read_configuration(committed().runs() / "benchmark.json");
  auto training = read_configuration(committed().runs() / "training.json");
  if (!benchmark || !training) return print_error(benchmark ? training.error() : benchmark.error()) ? 0 : 2;
  if (options.count > 0) {
    benchmark->quotas = {};
    benchmark->count = training->count = options.count;
  }
  RunConfiguration path;
  path.count = 200;
  const fs::path made = options.folder / "benchmark", trained = options.folder / "training";
  const auto one =
      measured("whole path of 200 tasks in M1, one thread", [&] { return make(path, options.folder / "path", 1); });
  const auto first = measured("benchmark in M1, M2 and M3", [&] { return make(*benchmark, made, options.threads); });
  const auto second = measured("training in M1 and M2", [&] { return make(*training, trained, options.threads); });
  const auto third = measured("proof of the benchmark", [&] { return prove(made, {}, options.threads); });
  const auto fourth =
      measured("proof of the training set against it", [&] { return prove(trained, {made}, options.threads); });
  std::printf("proofs together: %.1f s by the clock, %.1f s of processor time\n", third.clock_s + fourth.clock_s,
              third.processor_s + fourth.processor_s);
  const bool sound = one.sound && first.sound && second.sound && third.sound && fourth.sound;
  return sound ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Measures whole runs: benchmark, training and the proof of both");
  app.add_option("--count", options.count, "Tasks of each set, for a sample (default: the full sets)")
      ->check(CLI::Range(1, 1'000'000));
  app.add_option("--threads", options.threads, "Threads of each run (default: 2)")->check(CLI::Range(1, 1024));
  CLI11_PARSE(app, argc, argv);
  options.folder = fs::temp_directory_path() / ("unietp-whole-run-" + std::to_string(::getpid()));
  const int exit = run(options);
  std::error_code ignored;
  fs::remove_all(options.folder, ignored);
  return exit;
}
