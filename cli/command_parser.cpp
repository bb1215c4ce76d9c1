#include "cli/command_parser.h"

#include <CLI/CLI.hpp>

#include "cli/help_text.h"
#include "cli/output_place.h"
#include "core/text.h"

namespace unietp {
namespace {

/// Stops parsing with an exit code. CLI11 has exceptions for this.
[[noreturn]] void stop(int code) { throw CLI::RuntimeError(code); }

/// The innermost command that was named on the command line.
const CLI::App* chosen_in(const CLI::App& app) {
  const CLI::App* chosen = &app;
  for (auto below = app.get_subcommands(); !below.empty(); below = chosen->get_subcommands()) chosen = below.front();
  return chosen;
}

std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name() : full_name(*app.get_parent()) + " " + app.get_name();
}

}  // namespace

CommandOption* CommandOption::required(bool is_required) {
  option_->required(is_required);
  page_.required = is_required;
  return this;
}
CommandOption* CommandOption::within(int low, int high) {
  option_->check(CLI::Range(low, high));
  return this;
}
CommandOption* CommandOption::within(double low, double high) {
  option_->check(CLI::Range(low, high));
  return this;
}
CommandOption* CommandOption::not_negative() {
  option_->check(CLI::NonNegativeNumber);
  return this;
}
CommandOption* CommandOption::one_of(const std::vector<std::string>& values) {
  option_->check(CLI::IsMember(values));
  page_.choices = values;
  return this;
}
CommandOption* CommandOption::existing_file() {
  option_->check(CLI::ExistingFile);
  page_.completes = OptionPage::Completes::File;
  return this;
}
CommandOption* CommandOption::existing_folder() {
  option_->check(CLI::ExistingDirectory);
  return folder();
}
CommandOption* CommandOption::output() {
  option_->check(refusal_of_output, "");
  return this;
}
CommandOption* CommandOption::needs(const CommandOption* other) {
  option_->needs(other->option_);
  return this;
}
CommandOption* CommandOption::excludes(const CommandOption* other) {
  option_->excludes(other->option_);
  return this;
}
CommandOption* CommandOption::type_name(const std::string& name) {
  option_->type_name(name);
  page_.value = name;
  return this;
}
CommandOption* CommandOption::suggests(const std::vector<std::string>& values) {
  page_.choices = values;
  return this;
}
CommandOption* CommandOption::folder() {
  page_.completes = OptionPage::Completes::Folder;
  if (!page_.argument) page_.value = "FOLDER";
  return this;
}
CommandOption* CommandOption::delimiter(char sign) {
  option_->delimiter(sign);
  return this;
}
CommandOption* CommandOption::one_each() {
  option_->allow_extra_args(false);
  return this;
}
CommandOption* CommandOption::shows_default() {
  option_->capture_default_str();
  page_.fallback = option_->get_default_str();
  return this;
}
bool CommandOption::given() const { return option_->count() > 0; }

CommandParser::CommandParser(const std::string& name, const std::string& summary)
    : own_(std::make_unique<CLI::App>(summary, name)), app_(own_.get()) {
  page_.name = name;
  page_.summary = summary;
  app_->formatter_fn([this](const CLI::App*, const std::string&, CLI::AppFormatMode) {
    return screen_.empty() ? help_text(page()) : screen_;
  });
}
CommandParser::CommandParser(CLI::App* app, std::string name, std::string summary) : app_(app) {
  page_.name = std::move(name);
  page_.summary = std::move(summary);
  app_->formatter_fn([this](const CLI::App*, const std::string&, CLI::AppFormatMode) {
    return screen_.empty() ? help_text(page()) : screen_;
  });
}
CommandParser::~CommandParser() = default;

CommandParser* CommandParser::add_subcommand(const std::string& name, const std::string& summary) {
  commands_.push_back(
      std::make_unique<CommandParser>(app_->add_subcommand(name, summary), page_.name + " " + name, summary));
  return commands_.back().get();
}

void CommandParser::explain(const std::string& about, const std::vector<CommandExample>& examples) {
  page_.about = about;
  page_.examples = examples;
}
void CommandParser::help_screen(const std::string& text) { screen_ = text; }

CommandOption* CommandParser::keep(CLI::Option* option, const std::string& name, const std::string& value,
                                   const std::string& help, bool many) {
  OptionPage page{split(name, ','), value, help, {}, "", OptionPage::Completes::Nothing, false, false, many};
  page.argument = !name.starts_with('-');
  if (value == "FILE") page.completes = OptionPage::Completes::File;
  options_.push_back(std::make_unique<CommandOption>(option, std::move(page)));
  return options_.back().get();
}

CommandOption* CommandParser::add_option(const std::string& name, std::string& target, const std::string& help) {
  return keep(app_->add_option(name, target, help), name, "TEXT", help);
}
CommandOption* CommandParser::add_option(const std::string& name, std::filesystem::path& target,
                                         const std::string& help) {
  return keep(app_->add_option(name, target, help), name, "FILE", help);
}
CommandOption* CommandParser::add_option(const std::string& name, int& target, const std::string& help) {
  return keep(app_->add_option(name, target, help), name, "N", help);
}
CommandOption* CommandParser::add_option(const std::string& name, std::size_t& target, const std::string& help) {
  return keep(app_->add_option(name, target, help), name, "N", help);
}
CommandOption* CommandParser::add_option(const std::string& name, std::optional<std::uint64_t>& target,
                                         const std::string& help) {
  return keep(app_->add_option(name, target, help), name, "N", help);
}
CommandOption* CommandParser::add_option(const std::string& name, double& target, const std::string& help) {
  return keep(app_->add_option(name, target, help), name, "X", help);
}
CommandOption* CommandParser::add_option(const std::string& name, std::vector<std::string>& target,
                                         const std::string& help) {
  return keep(app_->add_option(name, target, help), name, "TEXT", help, true);
}
CommandOption* CommandParser::add_option(const std::string& name, std::vector<std::filesystem::path>& target,
                                         const std::string& help) {
  return keep(app_->add_option(name, target, help), name, "FILE", help, true);
}
CommandOption* CommandParser::add_flag(const std::string& name, bool& target, const std::string& help) {
  return keep(app_->add_flag(name, target, help), name, "", help);
}

void CommandParser::callback(std::function<void()> run) { app_->callback(std::move(run)); }
void CommandParser::require_subcommand() { app_->require_subcommand(1); }
void CommandParser::fall_through() { app_->fallthrough(); }
void CommandParser::version_flag(const std::string& name, const std::function<std::string()>& version) {
  app_->set_version_flag(name, version);
  options_.push_back(std::make_unique<CommandOption>(
      nullptr, OptionPage{{name}, "", "Print the version, the knowledge digest and the build", {}, "", {}}));
}

/// A message when the words begin with something that should be a command and is none; "" otherwise.
std::string CommandParser::unknown_command(const std::vector<std::string>& words) const {
  if (commands_.empty() || words.empty() || words.front().starts_with('-')) return "";
  std::vector<std::string> names;
  for (const auto& command : commands_) {
    if (command->app_->get_name() == words.front()) return command->unknown_command({words.begin() + 1, words.end()});
    names.push_back(command->app_->get_name());
  }
  const auto near = nearest_name(words.front(), names);
  return page_.name + ": unknown command \"" + words.front() + "\"" +
         (near.empty() ? "" : ", did you mean \"" + near + "\"") + "; commands are " + join(names, ", ");
}

int CommandParser::parse(int argc, char** argv, const std::function<int(const std::string& command)>& before) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (const auto unknown = unknown_command(words); !unknown.empty()) {
    (void)std::fprintf(stderr, "%s\n", unknown.c_str());
    return 2;
  }
  if (words.empty()) {
    (void)std::fprintf(stderr, "%s", app_->help().c_str());
    return 2;
  }
  app_->parse_complete_callback([&] {
    const auto chosen = app_->get_subcommands();
    if (const int code = before(chosen.empty() ? "" : chosen.front()->get_name()); code != 0) stop(code);
  });
  app_->failure_message([](const CLI::App* app, const CLI::Error& error) {
    const std::string name = full_name(*chosen_in(*app));
    return name + ": " + error.what() + "\nSee `" + name + " --help`.\n";
  });
  try {
    app_->parse(argc, argv);
    return 0;
  } catch (const CLI::RuntimeError& stopped) {
    return stopped.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? 0 : 2;
  }
}

CommandPage CommandParser::page() const {
  CommandPage page = page_;
  for (const auto& option : options_) page.options.push_back(option->page());
  for (const auto& command : commands_) page.commands.push_back(command->page());
  return page;
}

}  // namespace unietp
