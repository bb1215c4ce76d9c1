#include "cli/command_parser.h"

#include <CLI/CLI.hpp>

namespace unietp {

CommandOption* CommandOption::required(bool is_required) {
  option_->required(is_required);
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
  return this;
}
CommandOption* CommandOption::existing_file() {
  option_->check(CLI::ExistingFile);
  return this;
}
CommandOption* CommandOption::existing_folder() {
  option_->check(CLI::ExistingDirectory);
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
  return this;
}
bool CommandOption::given() const { return option_->count() > 0; }

CommandParser::CommandParser(const std::string& about, const std::string& name)
    : own_(std::make_unique<CLI::App>(about, name)), app_(own_.get()) {}
CommandParser::CommandParser(CLI::App* app) : app_(app) {}
CommandParser::~CommandParser() = default;

CommandParser* CommandParser::add_subcommand(const std::string& name, const std::string& help) {
  commands_.push_back(std::make_unique<CommandParser>(app_->add_subcommand(name, help)));
  return commands_.back().get();
}

CommandOption* CommandParser::keep(CLI::Option* option) {
  options_.push_back(std::make_unique<CommandOption>(option));
  return options_.back().get();
}

CommandOption* CommandParser::add_option(const std::string& name, std::string& target, const std::string& help) {
  return keep(app_->add_option(name, target, help));
}
CommandOption* CommandParser::add_option(const std::string& name, std::filesystem::path& target,
                                         const std::string& help) {
  return keep(app_->add_option(name, target, help));
}
CommandOption* CommandParser::add_option(const std::string& name, int& target, const std::string& help) {
  return keep(app_->add_option(name, target, help));
}
CommandOption* CommandParser::add_option(const std::string& name, std::uint64_t& target, const std::string& help) {
  return keep(app_->add_option(name, target, help));
}
CommandOption* CommandParser::add_option(const std::string& name, std::optional<std::uint64_t>& target,
                                         const std::string& help) {
  return keep(app_->add_option(name, target, help));
}
CommandOption* CommandParser::add_option(const std::string& name, double& target, const std::string& help) {
  return keep(app_->add_option(name, target, help));
}
CommandOption* CommandParser::add_option(const std::string& name, std::vector<std::string>& target,
                                         const std::string& help) {
  return keep(app_->add_option(name, target, help));
}
CommandOption* CommandParser::add_option(const std::string& name, std::vector<std::filesystem::path>& target,
                                         const std::string& help) {
  return keep(app_->add_option(name, target, help));
}
CommandOption* CommandParser::add_flag(const std::string& name, bool& target, const std::string& help) {
  return keep(app_->add_flag(name, target, help));
}

void CommandParser::callback(std::function<void()> run) { app_->callback(std::move(run)); }
void CommandParser::footer(const std::string& text) { app_->footer(text); }
void CommandParser::require_subcommand() { app_->require_subcommand(1); }
void CommandParser::fall_through() { app_->fallthrough(); }
void CommandParser::version_flag(const std::string& name, const std::string& version) {
  app_->set_version_flag(name, version);
}

int CommandParser::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? 0 : 2;
  }
}

}  // namespace unietp
