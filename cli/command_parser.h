#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace unietp {

/// An option of a command, as whoever adds it refines it. A value that does not meet what was asked for is refused with
/// a sentence, and the program ends with exit code 2.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option* option) : option_(option) {}

  CommandOption* required(bool is_required = true);
  CommandOption* within(int low, int high);        // both included
  CommandOption* within(double low, double high);  // both included
  CommandOption* not_negative();
  CommandOption* one_of(const std::vector<std::string>& values);
  CommandOption* existing_file();
  CommandOption* existing_folder();
  CommandOption* needs(const CommandOption* other);
  CommandOption* excludes(const CommandOption* other);
  CommandOption* type_name(const std::string& name);  // in the help: "NAME,..."
  CommandOption* delimiter(char sign);                // between the items of a list
  CommandOption* one_each();                          // a list has one item each time that the option is given
  CommandOption* shows_default();                     // in the help

  /// Only after parsing.
  bool given() const;

 private:
  CLI::Option* option_;
};

/// A program or one of its commands on the command line; the one place that knows the library behind it, since every
/// file that includes that library takes seconds to compile. Options and commands live as long as the program's parser.
class CommandParser {
 public:
  CommandParser(const std::string& about, const std::string& name);
  explicit CommandParser(CLI::App* app);
  CommandParser(const CommandParser&) = delete;
  CommandParser& operator=(const CommandParser&) = delete;
  ~CommandParser();

  CommandParser* add_subcommand(const std::string& name, const std::string& help);
  /// `name`: "--count", "--scenes,--scene" for two that mean the same, "FOLDER" for one told by its place. The value is
  /// written to `target`, which must live until after parsing.
  CommandOption* add_option(const std::string& name, std::string& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::filesystem::path& target, const std::string& help);
  CommandOption* add_option(const std::string& name, int& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::uint64_t& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::optional<std::uint64_t>& target, const std::string& help);
  CommandOption* add_option(const std::string& name, double& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::vector<std::string>& target, const std::string& help);
  CommandOption* add_option(const std::string& name, std::vector<std::filesystem::path>& target,
                            const std::string& help);
  CommandOption* add_flag(const std::string& name, bool& target, const std::string& help);

  void callback(std::function<void()> run);
  void footer(const std::string& text);
  void require_subcommand();
  void fall_through();  // options of the program may stand after the command
  void version_flag(const std::string& name, const std::string& version);

  /// Runs the callback of the command that is asked for. 0 when it ran or a help was shown, 2 for what was refused.
  int parse(int argc, char** argv);

 private:
  CommandOption* keep(CLI::Option* option);
  std::unique_ptr<CLI::App> own_;  // of a program; a command's belongs to its program
  CLI::App* app_;
  std::vector<std::unique_ptr<CommandParser>> commands_;
  std::vector<std::unique_ptr<CommandOption>> options_;
};

}  // namespace unietp
