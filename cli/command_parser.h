#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_page.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace unietp {

/// An option or argument of a command. Its methods narrow what it accepts; the program refuses any other value with a
/// message and exit code 2.
class CommandOption {
 public:
  CommandOption(CLI::Option* option, OptionPage page) : option_(option), page_(std::move(page)) {}

  /// Each returns this option, so that calls can follow one another.
  CommandOption* required(bool is_required = true);
  CommandOption* within(int low, int high);        // both included
  CommandOption* within(double low, double high);  // both included
  CommandOption* not_negative();
  CommandOption* one_of(const std::vector<std::string>& values);
  CommandOption* existing_file();
  CommandOption* existing_folder();
  CommandOption* output();  // a place to write to, outside of data sets and the like (cli/output_place.h)
  /// This option is refused without the other, or together with it.
  CommandOption* needs(const CommandOption* other);
  CommandOption* excludes(const CommandOption* other);
  CommandOption* type_name(const std::string& name);                // placeholder in help: "NAME,..."
  CommandOption* suggests(const std::vector<std::string>& values);  // for completion only; nothing is checked
  CommandOption* folder();                                          // completion offers folders
  CommandOption* delimiter(char sign);                              // between the items of a list
  CommandOption* one_each();                                        // one item each time the option is given
  CommandOption* shows_default();                                   // in help

  /// Only after parsing.
  bool given() const;
  /// What help and completion say of it.
  const OptionPage& page() const { return page_; }

 private:
  CLI::Option* option_;
  OptionPage page_;
};

/// A program or one of its commands on the command line. The only user of CLI11, which takes seconds to include.
/// Options and commands live as long as the program's parser.
class CommandParser {
 public:
  CommandParser(const std::string& name, const std::string& summary);
  CommandParser(CLI::App* app, std::string name, std::string summary);
  CommandParser(const CommandParser&) = delete;
  CommandParser& operator=(const CommandParser&) = delete;
  ~CommandParser();

  /// `summary`: one line without a full stop, for lists of commands and as the first line of its help.
  CommandParser* add_subcommand(const std::string& name, const std::string& summary);
  /// The rest of its help: paragraphs separated by empty lines, and examples.
  void explain(const std::string& about, const std::vector<CommandExample>& examples);
  /// Replaces the generated help text of this command.
  void help_screen(const std::string& text);

  /// `name`: "--count", "--scenes,--scene" for synonyms, "FOLDER" for an argument. The value is written to `target`,
  /// which must live until after parsing.
  CommandOption* add_option(const std::string& name, std::string& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::filesystem::path& target, const std::string& help);
  CommandOption* add_option(const std::string& name, int& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::size_t& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::optional<std::uint64_t>& target, const std::string& help);
  CommandOption* add_option(const std::string& name, double& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::vector<std::string>& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::vector<std::filesystem::path>& target,
                            const std::string& help);
  /// An option without a value: `target` becomes true when it is given.
  CommandOption* add_flag(const std::string& name, bool& target, const std::string& help);

  /// What runs when this command was asked for, after all options were read.
  void callback(std::function<void()> run);
  /// Refuses the command alone, without one of its subcommands.
  void require_subcommand();
  void fall_through();  // options of the program may follow the command
  /// A flag that prints the text and ends parsing.
  void version_flag(const std::string& name, const std::function<std::string()>& version);

  /// Runs the callback of the command that was asked for. `before` is called first with the command's name as typed
  /// ("scene"); a result other than 0 ends parsing. Returns 0 when the command ran or help was shown, the result of
  /// `before`, or 2 for a command line that was refused.
  int parse(int argc, char** argv, const std::function<int(const std::string& command)>& before);

  /// This command and all below it as data.
  CommandPage page() const;

 private:
  CommandOption* keep(CLI::Option* option, const std::string& name, const std::string& value, const std::string& help,
                      bool many = false);
  std::string unknown_command(const std::vector<std::string>& words) const;

  std::unique_ptr<CLI::App> own_;  // of a program; a command's belongs to its program
  CLI::App* app_;
  CommandPage page_;  // without options and commands, which the lists below have
  std::string screen_;
  std::vector<std::unique_ptr<CommandParser>> commands_;
  std::vector<std::unique_ptr<CommandOption>> options_;
};

}  // namespace unietp
