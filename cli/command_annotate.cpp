#include <memory>

#include "cli/command_parser.h"
#include "cli/writer_options.h"
#include "core/limits.h"

namespace unietp {
namespace {

struct AnnotateCommandOptions {
  RewordRequest request;
  WriterChoice writer;
};

Exit annotate(AnnotateCommandOptions& options, const CommandLine& program) {
  if (options.request.out.empty()) options.request.out = options.request.folder;
  if (const auto sound = check_writer(options.writer); !sound) return refuse(sound.error());
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  return reword_dataset(options.request, reading.resources, options.writer, program);
}

}  // namespace

void add_annotate_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<AnnotateCommandOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("annotate", "Rewrite the instructions of a data set");
  command->explain(
      "Instructions are written by a grammar (the default) or by a language model. Every text is checked, whoever "
      "wrote it. Where a model gives no correct text, the grammar's is used and the task's record says why. Texts that "
      "people wrote or corrected are kept. The data set is replaced in one step when everything is written; with --out "
      "it is left unchanged.\n\n"
      "See `unietp help models` for servers, keys and batch files. Exit code 1: some answers are missing; the data set "
      "is then as it was, unless --stand-in is given.",
      {{"unietp annotate out/mine --seed 5", "other wordings by the grammar"},
       {"unietp annotate out/mine --phrasings benchmark", "phrases that never occur in training texts"},
       {"unietp annotate out/mine --english gb", "bin, tap and cooker for trash can, faucet and stove"},
       {"unietp annotate out/mine --wordings 5", "wordings.jsonl with five texts of each task's goal"},
       {"unietp annotate out/mine --contrasts", "wordings.jsonl with minimal pairs"},
       {"unietp annotate out/mine --writer llm --llm-url http://localhost:8080/v1 --llm-model qwen2.5-7b", ""},
       {"unietp annotate out/mine --writer llm --llm-url URL --llm-model M --dry-run",
        "print the prompts and send nothing"},
       {"unietp annotate out/mine --writer batch --batch out/batch --llm-model M",
        "write request files; run it again when the service's answers are in out/batch"}});
  command->add_option("FOLDER", options->request.folder, "A finished data set")->required()->folder();
  command->add_option("--out", options->request.out, "Write a new data set here and do not change the old one")
      ->folder()
      ->output();
  command->add_option("--seed", options->request.seed, "Seed of the wording (default: that of the data set)");
  command->add_flag("--paired", options->request.paired,
                    "Also write wordings.jsonl: a direct, a referring and a complex wording of each task");
  command
      ->add_option("--wordings", options->request.wordings,
                   "The same, with this many different texts of each task's goal, or as many as the grammar has "
                   "(default with --paired: 2)")
      ->within(2, limits::kWordings);
  command->add_flag("--contrasts", options->request.contrasts,
                    "The same, with a text that differs from the direct one in one word and asks for another goal");
  command->add_flag("--replace-human", options->request.replace_human,
                    "Also replace texts that people wrote or corrected");
  add_writer_options(*command, options->writer);
  command->callback([options, &program] { program.exit = annotate(*options, program); });
}

}  // namespace unietp
