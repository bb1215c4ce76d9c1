#include <memory>

#include "cli/command_parser.h"
#include "cli/writer_options.h"

namespace unietp {
namespace {

struct AnnotateCommandOptions {
  std::filesystem::path folder, out;
  std::optional<std::uint64_t> seed;
  bool paired = false;
  WriterChoice writer;
};

Exit annotate(const AnnotateCommandOptions& options, const CommandLine& program) {
  if (const auto sound = check_writer(options.writer); !sound) return refuse(sound.error());
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  return reword_dataset(options.folder, options.out.empty() ? options.folder : options.out, reading.resources,
                        options.writer, options.seed, options.paired, program);
}

}  // namespace

void add_annotate_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<AnnotateCommandOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("annotate", "Rewrite the instructions of a data set");
  command->explain(
      "Instructions are written by a grammar (the default) or by a language model. Every text is checked, whoever "
      "wrote it. Where a model gives no correct text, the grammar's is used and the task's record says why. The data "
      "set is replaced in one step when everything is written; with --out it is left alone.\n\n"
      "See `unietp help models` for servers, keys and batch files. Exit code 1: some answers are missing.",
      {{"unietp annotate out/mine --seed 5", "other wordings by the grammar"},
       {"unietp annotate out/mine --phrasings benchmark", "phrases that never occur in training texts"},
       {"unietp annotate out/mine --writer llm --llm-url http://localhost:8080/v1 --llm-model qwen2.5-7b", ""},
       {"unietp annotate out/mine --writer llm --llm-url URL --llm-model M --dry-run",
        "print the prompts and send nothing"},
       {"unietp annotate out/mine --writer batch --batch out/batch --llm-model M",
        "write request files; run it again when the service's answers are in out/batch"}});
  command->add_option("FOLDER", options->folder, "A finished data set")->required()->existing_folder();
  command->add_option("--out", options->out, "Write a new data set here and leave the old one alone")->folder();
  command->add_option("--seed", options->seed, "Seed of the wording (default: that of the data set)");
  command->add_flag("--paired", options->paired,
                    "Also write wordings.jsonl: a direct, a referring and a complex wording of each task");
  add_writer_options(*command, options->writer);
  command->callback([options, &program] { program.exit = annotate(*options, program); });
}

}  // namespace unietp
