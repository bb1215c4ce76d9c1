#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>
#include <memory>

#include "authoring/usual_categories.h"
#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "core/text.h"
#include "record/dataset_reader.h"
#include "report/figure_table.h"
#include "report/word_figures.h"
#include "resources/resources.h"
#include "scene/comparisons.h"
#include "validator/carefulness.h"
#include "validator/referents.h"
#include "validator/replay.h"
#include "validator/trace_maker.h"

namespace unietp {
namespace {

struct StatsOptions {
  std::vector<std::filesystem::path> folders;
  int threads = 1, rows = 25;
  bool json = false, words = false, usual = false, referents = false, careful = false;
};

/// The figures of how the instructions ask for things, beside those of people.
Exit word_stats(const StatsOptions& options, const CommandLine& program) {
  const auto human = read_human_goals(program.folders.english());
  if (!human) return refuse(human.error());
  std::vector<std::pair<std::string, WordFigures>> sets;
  for (const auto& folder : options.folders) {
    const auto set = read_finished_set(folder);
    if (!set) return refuse(set.error());
    const auto texts = counted_texts(*set);
    if (!texts) return refuse(texts.error());
    sets.emplace_back(set->name, word_figures(*texts));
  }
  std::fputs(word_table(sets, *human).c_str(), stdout);
  return Exit::Ok;
}

/// What the goals of a data set refer to, and what of that is amiss.
Result<ReferentCounts> counted_referents(const std::filesystem::path& folder, const std::vector<Backend>& backends,
                                         int threads) {
  auto reader = DatasetReader::open(folder, {.modes = {}, .starts = true});
  if (!reader) return reader.error();
  ReferentCounts all;
  const auto done = for_each_task<ReferentCounts>(
      std::move(*reader), threads,
      [&](const FinishedTask& task) -> Result<ReferentCounts> {
        ReferentCounts own;
        const Formula& goal = task.record.goal_tree;
        const Profile& profile = backends[static_cast<std::size_t>(task.start.simulator)].profile;
        for (const Referents& one : referents_of(goal, task.start, to_logic(task.start, {}, true), profile))
          own.add(one);
        return own;
      },
      [&](ReferentCounts&& own) -> Result<Done> {
        all.add(own);
        return Done{};
      });
  if (!done) return done.error();
  return all;
}

Exit referent_stats(const StatsOptions& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  for (const auto& folder : options.folders) {
    const auto set = read_finished_set(folder);
    if (!set) return refuse(set.error());
    const auto counts = counted_referents(folder, known.backends, options.threads);
    if (!counts) return refuse(counts.error());
    std::printf("%s\n  %d referents of %d phrases\n", set->name.c_str(), counts->referents, counts->phrases);
    for (const auto& [kind, count] : counts->by_kind) std::printf("    %s: %d\n", kind.c_str(), count);
    std::printf(
        "  beyond a wall: %d\n  phrases that mean another thing on foot: %d\n"
        "  without something that differs in just what the phrase says: %d\n"
        "  told by where they are, though none of the others is on, in, under or beside anything: %d\n",
        counts->beyond_wall, counts->rivals, counts->without_alternative, counts->without_relation);
  }
  return Exit::Ok;
}

/// What the demonstrations of a task do that a careful person would not.
using CarelessInModes = std::map<Mode, Carelessness>;

Result<CarelessInModes> careless_in_modes(const FinishedTask& task, const Backend& backend) {
  CarelessInModes all;
  const Formula& goal = task.record.goal_tree;
  const auto world = World::create(task.start, backend.knowledge, backend.profile);
  if (!world) return world.error();
  const TraceMaker traces(task.start, reads_comparisons(goal), reads_later_comparisons(goal));
  for (const auto& [mode, shown] : task.shown)
    all[mode] = carelessness_of(goal, *world, traces, replay(*world, mode, shown, task.record.id).plan);
  return all;
}

/// Prints what is careless, task by task, then how much of it there is.
Exit careful_stats(const StatsOptions& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  for (const auto& folder : options.folders) {
    const auto set = read_finished_set(folder);
    if (!set) return refuse(set.error());
    auto reader = DatasetReader::open(folder, {.modes = set->modes, .starts = true});
    if (!reader) return refuse(reader.error());
    using OfTask = std::pair<std::string, CarelessInModes>;
    std::map<Mode, std::map<CarelessKind, int>> counts;
    std::map<Mode, int> demonstrations;
    std::printf("%s\n", set->name.c_str());
    const auto done = for_each_task<OfTask>(
        std::move(*reader), options.threads,
        [&](const FinishedTask& task) -> Result<OfTask> {
          auto careless = careless_in_modes(task, known.backends[static_cast<std::size_t>(task.start.simulator)]);
          if (!careless) return careless.error();
          return OfTask{task.record.id, std::move(*careless)};
        },
        [&](OfTask&& one) -> Result<Done> {
          for (const auto& [mode, careless] : one.second) {
            ++demonstrations[mode];
            for (const auto& [kind, ids] : careless) {
              ++counts[mode][kind];
              std::printf("  %s %s %s: %s\n", one.first.c_str(), name_of(mode).data(), name_of(kind).data(),
                          join(ids, " ").c_str());
            }
          }
          return Done{};
        });
    if (!done) return refuse(done.error());
    for (const auto& [mode, all] : demonstrations) {
      std::printf("  %s: of %d demonstrations\n", name_of(mode).data(), all);
      for (const CarelessKind kind : kCarelessKinds)
        std::printf("    %s: %d\n", name_of(kind).data(), counts[mode][kind]);
    }
  }
  return Exit::Ok;
}

/// Why no goal names a thing that most homes have.
std::string reason_text(const CommonUnused& unused) {
  constexpr std::size_t kNamed = 3;
  const auto& templates = unused.templates;
  if (templates.empty()) return unused.category + ": no template has a usual goal about it";
  std::vector<std::string> some(templates.begin(), templates.begin() + std::min(templates.size(), kNamed));
  const std::string rest = templates.size() > kNamed ? ", ..." : "";
  return unused.category + ": the " + std::to_string(unused.tasks) + " tasks of the " +
         std::to_string(templates.size()) + " templates that could be about it are about other things (" +
         join(some, ", ") + rest + ")";
}

std::string usual_text(const std::vector<std::pair<std::string, std::vector<UsualCoverage>>>& sets) {
  std::string text;
  for (const auto& [name, all] : sets) {
    text += name + "\n";
    for (const UsualCoverage& one : all) {
      const auto named = one.usual - one.missing.size();
      const double share = one.usual == 0 ? 0 : static_cast<double>(named) / static_cast<double>(one.usual);
      text += "  " + one.simulator + ": " + std::to_string(named) + " of " + std::to_string(one.usual) +
              " categories with usual goals are in a goal (" + percent_text(share) + ")\n";
      if (!one.missing.empty()) text += "    not: " + join(one.missing, " ") + "\n";
      if (!one.common.empty()) text += "    common in homes, in no goal:\n";
      for (const CommonUnused& unused : one.common) text += "      " + reason_text(unused) + "\n";
      if (!one.sole.empty()) text += "    the only thing that some templates can be about:\n";
      for (const SoleCategory& only : one.sole) {
        const auto share_of = [&](int part) {
          return percent_text(only.all == 0 ? 0 : static_cast<double>(part) / only.all);
        };
        text += "      " + only.category + ": " + share_of(only.tasks) + " of the tasks are of these templates, " +
                share_of(only.named) + " name it (" + join(only.templates, ", ") + ")\n";
      }
    }
  }
  return text;
}

/// How many tasks of the set are of the templates.
int tasks_of(const std::vector<std::string>& templates, const GoalThings& things) {
  int tasks = 0;
  for (const std::string& name : templates) {
    const auto made = things.templates.find(name);
    tasks += made == things.templates.end() ? 0 : made->second;
  }
  return tasks;
}

std::vector<CommonUnused> common_unused_of(const GoalThings& things, const Resources& resources) {
  std::vector<CommonUnused> all;
  for (const std::string& category : things.common_unused) {
    CommonUnused& one = all.emplace_back();
    one.category = category;
    one.templates = templates_with_usual_goals(category, resources, *simulator_named(things.simulator));
    one.tasks = tasks_of(one.templates, things);
  }
  return all;
}

/// Of the categories that some usual goal could be about, how many the goals of each set name, and which they do not.
Exit usual_stats(const StatsOptions& options, const CommandLine& program) {
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const Resources& resources = reading.resources;
  std::vector<const Knowledge*> knowledge;
  for (const auto simulator : kSimulators) knowledge.push_back(&resources.backend(simulator).knowledge);
  std::map<std::string, std::vector<std::string>> usual;
  std::map<std::string, std::map<std::string, std::vector<std::string>>> of_one;
  for (const auto simulator : kSimulators) {
    usual[std::string(name_of(simulator))] = categories_with_usual_goals(resources, simulator);
    of_one[std::string(name_of(simulator))] = templates_of_one_category(resources, simulator);
  }
  std::vector<std::pair<std::string, std::vector<UsualCoverage>>> sets;
  for (const auto& folder : options.folders) {
    const auto set = read_finished_set(folder);
    if (!set) return refuse(set.error());
    const auto statistics = statistics_of_set(*set, knowledge, options.threads);
    if (!statistics) return refuse(statistics.error());
    auto& of_set = sets.emplace_back(statistics->name, std::vector<UsualCoverage>{}).second;
    for (const GoalThings& things : statistics->things) {
      const auto& all = usual[things.simulator];
      of_set.push_back({things.simulator, all.size(), {}, common_unused_of(things, resources), {}});
      for (const auto& [category, templates] : of_one[things.simulator]) {
        const auto named = things.categories.find(category);
        of_set.back().sole.push_back({category, templates, tasks_of(templates, things),
                                      named == things.categories.end() ? 0 : named->second, things.tasks});
      }
      std::copy_if(all.begin(), all.end(), std::back_inserter(of_set.back().missing),
                   [&](const std::string& name) { return !things.named.contains(name); });
    }
  }
  std::fputs((options.json ? usual_coverage_json(sets) : usual_text(sets)).c_str(), stdout);
  return Exit::Ok;
}

Exit stats(const StatsOptions& options, const CommandLine& program) {
  if (options.words) return word_stats(options, program);
  if (options.usual) return usual_stats(options, program);
  if (options.referents) return referent_stats(options, program);
  if (options.careful) return careful_stats(options, program);
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  std::vector<const Knowledge*> knowledge;
  for (const auto& backend : known.backends) knowledge.push_back(&backend.knowledge);
  std::vector<DatasetStatistics> sets;
  for (const auto& folder : options.folders) {
    const auto set = read_finished_set(folder);
    if (!set) return refuse(set.error());
    auto statistics = statistics_of_set(*set, knowledge, options.threads);
    if (!statistics) return refuse(statistics.error());
    sets.push_back(std::move(*statistics));
  }
  const std::string text =
      options.json ? statistics_json(sets) : table_text(tables_of(sets), static_cast<std::size_t>(options.rows));
  std::fputs(text.c_str(), stdout);
  return Exit::Ok;
}

}  // namespace

void add_stats_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<StatsOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("stats", "Print statistics of one or more data sets");
  command->explain(
      "Tables of tasks, instructions, goals, plans, rejected candidates, homes and balance. `unietp report` "
      "shows the same with charts.",
      {{"unietp stats out/mine", ""},
       {"unietp stats out/benchmark out/training", "side by side"},
       {"unietp stats out/mine --rows 200", "longer tables"},
       {"unietp stats out/mine --words", "how its instructions ask, beside how people do"},
       {"unietp stats out/mine --referents",
        "what phrases such as \"the mug nearest to the sink\" mean, and what is amiss"},
       {"unietp stats out/mine --careful", "what demonstrations do that a careful person would not"},
       {"unietp stats out/training --usual", "which categories could be in a goal that makes sense, but are in none"},
       {"unietp stats out/mine --json > statistics.json", ""},
       {"unietp stats out/training --usual --json > usual.json", "with --usual, those figures as JSON"}});
  command->add_option("FOLDER", options->folders, "Finished data sets")->required()->folder();
  command->add_option("--rows", options->rows, "Rows of the longest table")->within(1, 1000000)->shows_default();
  add_threads_option(*command, options->threads, program);
  auto* const words = command->add_flag("--words", options->words,
                                        "Print how instructions ask for things, beside goals that people wrote");
  auto* const usual =
      command->add_flag("--usual", options->usual,
                        "Print how many of the categories with usual goals are in a goal, and the others (a minute)");
  auto* const referents = command->add_flag(
      "--referents", options->referents,
      "Print how many things referring phrases mean, by what they say, and how many cannot be told so");
  auto* const careful = command->add_flag("--careful", options->careful,
                                          "Print which demonstrations park things, move what the goal does not speak "
                                          "of, use a device in another room though one is near, or "
                                          "leave open or on what they opened or turned on");
  for (auto* const one : {words, usual, referents}) careful->excludes(one);
  command->add_flag("--json", options->json, "Print JSON with all rows")->excludes(referents)->excludes(careful);
  command->callback([options, &program] { program.exit = stats(*options, program); });
}

}  // namespace unietp
