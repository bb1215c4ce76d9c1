#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "core/text.h"
#include "exports/formats.h"
#include "record/manifest_record.h"

namespace unietp {
namespace {

/// The command-line option of one or more formats.
struct FormatOption {
  ExportOption described;
  std::vector<std::string> formats;  // that take it
  std::string value;                 // as given, for a single value,
  std::vector<std::string> values;   // a list
  bool flag = false;                 // or a flag
  CommandOption* option = nullptr;
};

struct ExportOptions {
  std::filesystem::path dataset, out;
  std::string format;
  int threads = 1;
  bool json = false;
  std::vector<FormatOption> special;  // complete before the first is added to the parser, which keeps pointers to them
};

/// The options of all formats, each name once.
std::vector<FormatOption> options_of(const std::vector<ExportFormat>& formats) {
  std::vector<FormatOption> all;
  for (const auto& format : formats) {
    for (const auto& option : format.options) {
      const auto same = [&](const FormatOption& known) { return known.described.name == option.name; };
      auto found = std::find_if(all.begin(), all.end(), same);
      if (found == all.end()) found = all.insert(all.end(), {option, {}, "", {}, false, nullptr});
      found->formats.push_back(format.name);
    }
  }
  return all;
}

void add_to(CommandParser& command, FormatOption& special) {
  const ExportOption& described = special.described;
  const std::string name = "--" + described.name, help = join(special.formats, ", ") + ": " + described.help;
  if (described.flag) {
    special.option = command.add_flag(name, special.flag, help);
    return;
  }
  if (described.list) {
    special.option = command.add_option(name, special.values, help)->delimiter(',')->one_each()->type_name("NAME,...");
  } else {
    special.value = described.fallback;
    special.option =
        command.add_option(name, special.value, help)->type_name(described.choices.empty() ? "VALUE" : "NAME");
    if (!described.fallback.empty()) special.option->shows_default();
  }
  if (!described.choices.empty()) special.option->one_of(described.choices);
}

/// The request's options for a format. Errors: Usage for an option that the format does not take.
Result<Done> take_options(const ExportOptions& options, const ExportFormat& format, ExportRequest& request) {
  for (const auto& special : options.special) {
    const bool taken = std::find(special.formats.begin(), special.formats.end(), format.name) != special.formats.end();
    const std::string& name = special.described.name;
    if (!taken && special.option->given())
      return Error{Error::Kind::Usage,
                   "--" + name,
                   {},
                   "the format " + format.name + " does not take it; it is for " + join(special.formats, ", ")};
    if (!taken) continue;
    if (special.flag) request.options[name] = {"true"};
    if (!special.value.empty()) request.options[name] = {special.value};
    if (!special.values.empty()) request.options[name] = special.values;
  }
  return Done{};
}

Exit export_dataset(const ExportOptions& options, const std::vector<ExportFormat>& formats,
                    const CommandLine& program) {
  if (std::error_code code; !std::filesystem::is_directory(options.dataset, code))
    return refuse({Error::Kind::Usage, options.dataset.string(), {}, "is not a folder; expected a finished data set"});
  const auto format =
      std::find_if(formats.begin(), formats.end(), [&](const ExportFormat& one) { return one.name == options.format; });
  ExportRequest request{options.dataset, options.out, program.folders.root / "data", {}, options.threads, {}};
  if (const auto taken = take_options(options, *format, request); !taken) return refuse(taken.error());
  BackendsReading reading;
  if (format->needs_knowledge) {
    DataFolders folders = program.folders;
    folders.extended_library = records_extended_library(options.dataset);
    reading = load_backends(folders);
    if (!reading.errors.empty()) return refuse(reading.errors);
    for (const auto& backend : reading.backends) request.backends.push_back({&backend.knowledge, &backend.profile});
  }
  const auto summary = format->write(request);
  if (!summary) return refuse(summary.error());
  std::printf("%s\n", (options.json ? summary->json : summary->text).c_str());
  return Exit::Ok;
}

}  // namespace

void add_export_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<ExportOptions>();  // shared: the callback outlives this function
  auto formats = std::make_shared<std::vector<ExportFormat>>(export_formats());
  options->special = options_of(*formats);
  std::vector<std::string> names;
  std::string about = "Formats:\n";
  std::vector<CommandExample> examples;
  for (const auto& format : *formats) {
    names.push_back(format.name);
    about += "  " + format.name + std::string(format.name.size() < 16 ? 16 - format.name.size() : 1, ' ') +
             format.help + "\n";
    examples.push_back({"unietp export out/mine --format " + format.name + " --out out/" + format.name, ""});
  }
  auto* command = app.add_subcommand("export", "Convert a data set to another format");
  command->explain(about +
                       "\nTasks that a format cannot express are left out and counted by reason; left_out.jsonl "
                       "lists them with the reasons. The folder is written completely or not at all.",
                   examples);
  command->add_option("FOLDER", options->dataset, "A finished data set")->required()->folder();
  command->add_option("--format", options->format, "Format to write")->required()->one_of(names)->type_name("FORMAT");
  command->add_option("--out", options->out, "Folder to make; it must not exist")->required()->folder()->output();
  command->add_flag("--json", options->json, "Print the summary, with the counts of reasons, as JSON");
  for (auto& special : options->special) add_to(*command, special);
  add_threads_option(*command, options->threads, program);
  command->callback([options, formats, &program] { program.exit = export_dataset(*options, *formats, program); });
}

}  // namespace unietp
