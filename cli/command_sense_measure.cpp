#include <cstdio>
#include <memory>

#include "cli/command_knowledge.h"
#include "cli/command_parser.h"
#include "cli/sense_folder.h"
#include "core/text.h"
#include "sense/fit.h"
#include "sense/measure.h"

namespace unietp {
namespace {

struct SenseMeasureOptions {
  std::filesystem::path metadata, activities;
  bool items = false, unjudged = false;
};

void print_counts(const char* what, const GradeCounts& counts) {
  const int all = counts[0] + counts[1] + counts[2];
  if (all == 0) return;
  const auto share = [&](int count) { return 100.0 * count / all; };
  std::printf("  %-34s %5d: %5.1f %% usual, %5.1f %% tolerable, %5.1f %% senseless\n", what, all, share(counts[2]),
              share(counts[1]), share(counts[0]));
}

void print_items(const char* what, const std::vector<GradedItem>& items) {
  for (const auto& item : items) {
    print_line(join({item.evidence.source, what, item.evidence.thing, item.evidence.role, item.evidence.example,
                     std::string(name_of(item.grade))},
                    "\t"));
  }
}

Exit measure(const SenseMeasureOptions& options, const CommandLine& program) {
  std::vector<Error> errors;
  const auto knowledge = load_some(program, {Simulator::Behavior}, errors);
  const auto folder = sense_folder(program);
  const Kinds kinds = read_kinds(folder / "kinds.csv", errors);
  const auto words = read_word_kinds(folder, kinds, errors);
  const auto categories = read_category_kinds(folder / "categories.csv", kinds, errors);
  const auto judgments = read_judgments(folder / "judged.csv", kinds, errors);
  const auto rules = read_sense_rules(folder / "rules.csv", kinds, errors);
  if (!errors.empty()) return refuse(errors);
  const auto net = Hypernyms::read(Hypernyms::kFolder);
  if (!net) return refuse(net.error());
  const SenseSources sources{options.metadata, options.activities, program.folders.root / "data/bddl"};
  auto synsets = read_category_synsets(sources.bddl);
  if (!synsets) return refuse(synsets.error());
  const auto items = read_items(sources, {kinds, words, *net, std::move(*synsets)});
  if (!items) return refuse(items.error());
  const auto judged = options.unjudged ? without_held_out(judgments, *items) : judgments;
  for (const auto& figures : measure_held_out(*items, kinds, categories, judged, rules, knowledge.front())) {
    if (options.items) {
      print_items("held out", figures.items);
      print_items("swapped", figures.swapped);
      continue;
    }
    print_line(figures.source);
    print_counts("held out", figures.real);
    print_counts("one role swapped, physically", figures.moved);
    print_counts("held out, beside its activity", figures.real_beside);
    print_counts("swapped, beside its activity", figures.moved_beside);
    print_counts("one role swapped, as listed", figures.listed);
    print_counts("voted implausible", figures.against);
  }
  return Exit::Ok;
}

}  // namespace

void add_sense_measure_command(CommandParser& knowledge, CommandLine& program) {
  auto options = std::make_shared<SenseMeasureOptions>();  // shared: the callback outlives this function
  auto* command = knowledge.add_subcommand("measure-sense", "Grade what people wrote, held out of fitting");
  command->explain(
      "Fits to a part of the activities, titles and objects and grades the others, as they are and with one role "
      "swapped.",
      {{"unietp knowledge measure-sense metadata --activities bddl/activity_definitions", ""},
       {"unietp knowledge measure-sense metadata --activities bddl/activity_definitions --items",
        "one line for each item"}});
  command->add_option("FOLDER", options->metadata, "Folder with virtualhome/, housekeep/ and ai2thor/")
      ->required()
      ->folder();
  command->add_option("--activities", options->activities, "Folder of BEHAVIOR's activity definitions")
      ->required()
      ->folder();
  command->add_flag("--items", options->items, "Print each item with its grade, fields separated by tabs");
  command->add_flag("--unjudged", options->unjudged, "Leave out the rows of judged.csv that speak of a held-out item");
  command->callback([options, &program] { program.exit = measure(*options, program); });
}

}  // namespace unietp
