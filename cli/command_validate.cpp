#include <cstdint>
#include <cstdio>
#include <memory>
#include <numeric>

#include <nlohmann/json.hpp>

#include "audit/audit.h"
#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/evaluation_results.h"
#include "cli/full_validation.h"
#include "cli/likeness_output.h"
#include "core/file_writer.h"
#include "core/in_quotes.h"
#include "record/manifest_record.h"
#include "record/recorded_words.h"
#include "resources/resources.h"
#include "scene/command.h"
#include "validator/validate.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

struct ValidateOptions {
  std::filesystem::path folder, dataset, plans;
  std::vector<std::filesystem::path> against;
  std::string shard;  // "2/8"; empty: all of it
  int threads = 1;
  bool json = false, kinds = false, accept_unchecked = false;
};

/// Number of problems of each kind, in the order of the kinds.
std::vector<std::pair<ProblemKind, std::int64_t>> counted(const ValidationReport& report) {
  std::vector<std::pair<ProblemKind, std::int64_t>> counts;
  for (const auto& about : all_problems()) {
    const auto count = report.found[static_cast<std::size_t>(about.kind)];
    if (count > 0) counts.emplace_back(about.kind, count);
  }
  return counts;
}

/// Problems that are counted but not in the list.
std::int64_t unlisted(const ValidationReport& report) {
  return std::accumulate(report.found.begin(), report.found.end(), std::int64_t{0}) -
         static_cast<std::int64_t>(report.problems.size());
}

Json counts_json(const ProofCounts& counts) {
  return {{"tasks", counts.tasks},
          {"proven", counts.proven},
          {"demonstrations", counts.demonstrations},
          {"steps", counts.steps},
          {"altered_plans", counts.altered_plans},
          {"constrained", counts.constrained},
          {"tempting", counts.tempting},
          {"texts", counts.texts},
          {"unchecked", counts.unchecked}};
}

Json audit_of(const AuditReport& audit) {
  auto leaks = Json::array();
  for (const AuditCell& cell : audit.cells) {
    if (cell.leaks())
      leaks.push_back({{"policy", cell.policy->name}, {"mode", name_of(cell.mode)}, {"group", cell.group}});
  }
  return {{"cells", audit.cells.size()}, {"training_tasks", audit.examples}, {"leaks", std::move(leaks)}};
}

void print_json(const ValidationReport& report, const std::optional<AuditReport>& audit, const std::string& shard) {
  auto problems = Json::array();
  for (const auto& problem : report.problems) {
    const auto& error = problem.error;
    problems.push_back({{"kind", name_of(problem.kind)},
                        {"task", problem.task},
                        {"where", error.where},
                        {"line", error.pos.line},
                        {"column", error.pos.column},
                        {"message", error.message}});
  }
  auto simulators = Json::object();
  for (const auto simulator : kSimulators)
    simulators[std::string(name_of(simulator))] = counts_json(report.by_simulator[static_cast<std::size_t>(simulator)]);
  auto kinds = Json::object();
  for (const auto& [kind, count] : counted(report)) kinds[std::string(name_of(kind))] = count;
  Json json{{"format", "unietp-validation/1"}};
  if (!shard.empty()) json["shard"] = shard;
  json.update(counts_json(report.counts));
  json["by_simulator"] = std::move(simulators);
  json["by_kind"] = std::move(kinds);
  json["likeness"] = Json::array();
  for (const auto& likeness : report.likeness) json["likeness"].push_back(likeness_json(likeness));
  if (audit) json["audit"] = audit_of(*audit);
  json["unlisted"] = unlisted(report);
  json["problems"] = std::move(problems);
  std::printf("%s\n", json.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

void print_row(std::string_view name, const ProofCounts& counts) {
  std::printf("%-12s %8d %8d %15d %8d %13d %8d\n", std::string(name).c_str(), counts.tasks, counts.proven,
              counts.demonstrations, counts.steps, counts.altered_plans, counts.texts);
}

void print_text(const ValidationReport& report, const std::optional<AuditReport>& audit, const std::string& shard) {
  for (const auto& problem : report.problems)
    std::printf("%s %s: %s\n", std::string(name_of(problem.kind)).c_str(),
                problem.task.empty() ? "data set" : for_terminal(problem.task).c_str(), format(problem.error).c_str());
  if (const auto more = unlisted(report); more > 0)
    std::printf("and %lld more problems of these kinds\n", static_cast<long long>(more));
  if (!report.problems.empty()) std::printf("\n");
  for (const auto& likeness : report.likeness) print_likeness(likeness);
  std::printf("%-12s %8s %8s %15s %8s %13s %8s\n", "", "tasks", "proven", "demonstrations", "steps", "altered plans",
              "texts");
  for (const auto simulator : kSimulators)
    print_row(name_of(simulator), report.by_simulator[static_cast<std::size_t>(simulator)]);
  print_row("all", report.counts);
  for (const auto& [kind, count] : counted(report))
    std::printf("%8lld %s\n", static_cast<long long>(count), std::string(name_of(kind)).c_str());
  if (audit) {
    for (const AuditCell& cell : audit->cells) {
      if (cell.leaks())
        std::printf("%s is better than chance in %s, %s\n", std::string(cell.policy->name).c_str(),
                    std::string(name_of(cell.mode)).c_str(), cell.group.c_str());
    }
    std::printf("%d of %zu cells of the audit are better than chance\n", audit->leaks(), audit->cells.size());
  }
  if (const ProofCounts& counts = report.counts; counts.constrained > 0)
    std::printf("%d of %d goals with constraints have a plan that forgets one and does the rest\n", counts.tempting,
                counts.constrained);
  std::printf("%d of %d proven", report.counts.proven, report.counts.tasks);
  if (report.counts.unchecked > 0)
    std::printf("; of %d the text failed the checks (person:unchecked), so that nothing proves its meaning",
                report.counts.unchecked);
  std::printf("%s\n", shard.empty() ? "" : (" in shard " + shard).c_str());
}

/// The table of docs/validate.md.
void print_kinds() {
  std::printf("| kind | what is wrong |\n|---|---|\n");
  for (const auto& about : all_problems())
    std::printf("| `%s` | %s |\n", std::string(about.name).c_str(), std::string(about.meaning).c_str());
}

/// Writes changed plans as they come; remembers the first failure.
class PlanFile {
 public:
  static Result<PlanFile> begin(const std::filesystem::path& path) {
    auto place = place_of(path);
    if (!place) return place.error();
    auto file = FileWriter::replace(std::move(*place));
    if (!file) return file.error();
    return PlanFile(std::move(*file));
  }
  void add(const std::string& task, const TriedPlan& tried) {
    auto actions = Json::array();
    for (const Command& command : tried.plan.commands) actions.push_back(command_to_json(command));
    const Json line{{"task", task},
                    {"mode", name_of(tried.mode)},
                    {"change", name_of(tried.plan.change)},
                    {"actions", std::move(actions)},
                    {"reaches_goal", tried.plan.reaches_goal},
                    {"breaks_constraint", tried.plan.breaks_constraint}};
    if (written_) written_ = file_.add(line.dump() + "\n");
  }
  Result<Done> finish() { return written_ ? file_.finish() : written_; }

 private:
  explicit PlanFile(FileWriter file) : file_(std::move(file)) {}
  FileWriter file_;
  Result<Done> written_ = Done{};
};

/// What blind policies reach on a sound data set, if it is the whole benchmark: they learn from the first data set that
/// it is held against.
Result<std::optional<AuditReport>> audit_if_benchmark(const ValidateOptions& options) {
  const auto manifest = read_manifest_file(options.folder);
  if (!manifest || recorded_homes(manifest->run.homes) != RecordedHomes::Benchmark || manifest->run.by_split.empty())
    return std::optional<AuditReport>();
  auto tasks = audited_tasks(options.folder, options.threads, [](int) {});
  if (!tasks) return tasks.error();
  std::vector<AuditedTask> training;
  if (!options.against.empty()) {
    auto examples = audited_tasks(options.against.front(), options.threads, [](int) {});
    if (!examples) return examples.error();
    training = std::move(*examples);
  }
  AuditSettings settings = whole_audit();
  settings.threads = options.threads;
  return std::optional(audit(std::move(*tasks), std::move(training), settings));
}

Exit validate(ValidateOptions& options, const CommandLine& program) {
  if (options.kinds) {
    print_kinds();
    return Exit::Ok;
  }
  auto folders_given = options.against;
  folders_given.push_back(options.folder);
  for (const auto& folder : folders_given) {
    if (std::error_code code; !std::filesystem::is_directory(folder, code))
      return refuse({Error::Kind::Usage,
                     folder.empty() ? "validate" : folder.string(),
                     {},
                     folder.empty() ? "expected the folder of a finished data set"
                                    : "is not a folder; expected a finished data set"});
  }
  const auto shard = options.shard.empty() ? Result(Shard()) : parse_shard(options.shard);
  if (!shard) return refuse(shard.error());
  const bool evaluation = is_evaluation(options.folder);
  if (evaluation && !options.shard.empty())
    return refuse({Error::Kind::Usage, "--shard", {}, "is of data sets; an evaluation is verified as a whole"});
  if (evaluation) return validate_evaluation(options.folder, options.dataset, options.threads, program);
  auto folders = program.folders;
  folders.extended_library = records_extended_library(options.folder);
  const auto reading = load_resources(folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const Resources& resources = reading.resources;
  std::vector<ValidationBackend> backends;
  for (const auto& backend : resources.backends) backends.push_back({&backend.knowledge, &backend.profile});
  auto validation = full_validation(resources, folders);
  if (!validation) return refuse(validation.error());
  validation->threads = options.threads;
  validation->part = shard->number;
  validation->parts = shard->of;
  validation->against = options.against;
  validation->accept_unchecked = options.accept_unchecked;
  std::optional<PlanFile> plans;
  if (!options.plans.empty()) {
    auto begun = PlanFile::begin(options.plans);
    if (!begun) return refuse(begun.error());
    plans.emplace(std::move(*begun));
    validation->take_plan = [&](const std::string& task, const TriedPlan& plan) { plans->add(task, plan); };
  }
  const auto report = validate_dataset(options.folder, backends, resources.digest, *validation);
  if (plans) {
    if (const auto written = plans->finish(); !written) return refuse(written.error());
  }
  auto audit = report.sound() && shard->is_whole() ? audit_if_benchmark(options) : Result(std::optional<AuditReport>());
  if (!audit) return refuse(audit.error());
  options.json ? print_json(report, *audit, options.shard) : print_text(report, *audit, options.shard);
  return report.sound() ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_validate_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<ValidateOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("validate", "Verify a data set, given only its files");
  command->explain(
      "Rebuilds each start scene in fresh physics, replays every demonstration and compares each outcome, view and "
      "change, evaluates the goal, checks that altered plans fail, and reads each instruction back into its goal. Also "
      "checks checksums, quotas, balance, duplicates and overlap with other data sets, from which homes and tasks must "
      "not be copied with small changes either.\n\n"
      "Of an evaluation that `unietp evaluate` wrote, it executes every episode again and computes every number of its "
      "results again.\n\n"
      "Prints one line per problem with its kind, task, file and line, then a table. Exit code 0 only when nothing is "
      "wrong.",
      {{"unietp validate out/first", ""},
       {"unietp validate out/my-model --dataset out/benchmark", "an evaluation"},
       {"unietp validate out/first --json > report.json", ""},
       {"unietp validate out/training --against out/benchmark",
        "no home or seed may be shared, nor a home or task copied with changes"},
       {"unietp validate out/training --shard 3/8", "an eighth of the tasks, on one of eight machines"}});
  auto* folder = command->add_option("FOLDER", options->folder, "A finished data set or an evaluation")->folder();
  command
      ->add_option(
          "--against", options->against,
          "Another data set: no home or seed may be in both, nor a copy of a home or task with small changes; shows "
          "how alike the two are, and how many instructions both have; may be repeated")
      ->folder()
      ->one_each();
  command->add_option("--dataset", options->dataset, "For an evaluation: the data set that it was made on")->folder();
  command
      ->add_option("--altered-plans", options->plans,
                   "Write the altered plans that were run, with their results, to this file as JSON lines")
      ->output();
  command
      ->add_option("--shard", options->shard,
                   "Prove only part K of N of the tasks; part 1 also checks what is of the whole data set, so that all "
                   "parts together are the whole verification")
      ->type_name("K/N");
  command->add_flag("--accept-unchecked", options->accept_unchecked,
                    "Count instructions by people that failed the checks, and do not report them as problems; their "
                    "tasks are not proven");
  command->add_flag("--kinds", options->kinds, "List the kinds of problems, as Markdown")->excludes(folder);
  add_threads_option(*command, options->threads, program);
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->callback([options, &program] { program.exit = validate(*options, program); });
}

}  // namespace unietp
