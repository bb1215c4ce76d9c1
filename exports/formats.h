#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "scene/simulator.h"
#include "validator/validation_options.h"

namespace unietp {

/// An option that one or more export formats take. Two formats may share a name; then they must describe it alike.
struct ExportOption {
  std::string name;                  // without dashes: "unit"
  std::string help;                  // one line, capitalized, no full stop
  std::vector<std::string> choices;  // accepted values; empty: the format says which
  std::string fallback;              // the value when the option is not given; "": none
  bool flag = false;                 // takes no value
  bool list = false;                 // takes several of the choices, separated by commas
};

/// What an export works on. All paths are as the user gave them.
struct ExportRequest {
  std::filesystem::path dataset;  // an existing folder
  std::filesystem::path out;      // must not exist; appears when the export is complete
  std::filesystem::path data;     // the program's data/ folder
  /// In the order of kSimulators; empty for a format that does not need knowledge.
  std::vector<ValidationBackend> backends;
  int threads = 1;  // never changes the result
  /// Of the format's own options: values as given or by default. A flag that was given has the value {"true"}.
  std::map<std::string, std::vector<std::string>> options;

  bool has(const std::string& option) const { return options.contains(option); }  // whether it was given
  /// The only value of an option; "" when it has none.
  std::string value(const std::string& option) const;
};

/// What an export tells its user.
struct ExportSummary {
  std::string text;  // lines without the last line break
  std::string json;  // the same as one JSON object in a line
};

/// A format that `unietp export` writes: all that the command line, its help and the shell completions know of it.
struct ExportFormat {
  std::string name;                   // "pddl"
  std::string help;                   // one line, lower case, no full stop
  std::vector<ExportOption> options;  // that only some formats take
  bool needs_knowledge = true;        // reads `backends`
  /// Writes the data set. Deterministic.
  /// Errors: those of reading the data set; Io; Usage for an `out` that exists or a value that does not fit.
  Result<ExportSummary> (*write)(const ExportRequest& request) = nullptr;
  bool is_form = false;                // tasks for programs of others, of which it may leave some out (`forms` asks it)
  std::optional<Simulator> only = {};  // the simulator whose tasks it writes; nullopt: all
};

/// Every format, in the order in which help lists them.
std::vector<ExportFormat> export_formats();

}  // namespace unietp
