#include <memory>

#include "cli/command_parser.h"
#include "cli/writer_options.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Write the instructions of a finished data set anew.\n"
    "\n"
    "  unietp annotate out/mine --seed 5                       other words of the grammar\n"
    "  unietp annotate out/mine --phrasings benchmark          words that training texts never have\n"
    "  export UNIETP_LLM_KEY=...                               only for servers that ask for one\n"
    "  unietp annotate out/mine --writer llm --llm-url http://localhost:8080/v1 --llm-model qwen2.5-7b\n"
    "  unietp annotate out/mine --writer llm --llm-url URL --llm-model M --dry-run     print the prompts\n"
    "  unietp annotate out/mine --writer batch --batch out/batch --llm-model M         write request files,\n"
    "      and again, when the service's answers lie in out/batch, to read them and go on\n"
    "\n"
    "Every text is checked, whoever wrote it; where a model has no right one the grammar stands in, and the task's\n"
    "record says why. The folder is replaced at once when all is written, or stays as it was; --out leaves it alone.\n"
    "Exit code 1: some answers are missing.";

struct Options {
  std::filesystem::path folder, out;
  std::optional<std::uint64_t> seed;
  bool paired = false;
  WriterChoice writer;
};

Exit annotate(const Options& options, const CommandLine& program) {
  if (const auto sound = settled(options.writer); !sound) return refuse(sound.error());
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  return write_anew(options.folder, options.out.empty() ? options.folder : options.out, reading.resources,
                    options.writer, options.seed, options.paired, program);
}

}  // namespace

void add_annotate_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("annotate", kHelp);
  command->add_option("folder", options->folder, "Data set")->required()->existing_folder();
  command->add_option("--out", options->out, "Folder to make, in place of changing the data set itself");
  command->add_option("--seed", options->seed, "Number that names the wording (default: that of the run)");
  command->add_flag("--paired", options->paired,
                    "Also write wordings.jsonl: each episode in a direct, a referring and a complex wording");
  add_writer_options(*command, options->writer);
  command->callback([options, &program] { program.exit = annotate(*options, program); });
}

}  // namespace unietp
