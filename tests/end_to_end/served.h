#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "program.h"

namespace unietp {

/// A call to `unietp serve`.
struct ServedCall {
  std::string method;
  nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
};
/// Its line: JSON-RPC 2.0.
std::string request_line(int id, const ServedCall& call);

/// The calls that play a task of a data set in a mode as its demonstration does: `open`, `reset` and each step.
std::vector<ServedCall> demonstrated_calls(const std::filesystem::path& folder, const std::string& mode,
                                           std::size_t task);

/// The answers of `unietp serve FOLDER OPTIONS` to lines on its standard input, which then ends.
std::vector<std::string> served_lines(const std::filesystem::path& folder, const std::vector<std::string>& requests,
                                      const std::string& options = "");

/// A command of the program that goes on until it is told to end: its standard input stays open, and what it prints can
/// be read meanwhile.
class LongCommand {
 public:
  /// `arguments`: as in a shell.
  explicit LongCommand(const std::string& arguments);
  /// Writes to its standard input.
  void write(const std::string& text) const;
  /// Waits until it has printed a text, and returns all that it printed.
  std::string until_printed(const std::string& text);
  /// The address that it printed: "http://127.0.0.1:40123".
  std::string url();
  void send(int signal) const { program_.send(signal); }
  Ended wait() { return program_.wait(); }

 private:
  std::string printed() const;

  ScratchFolder folder_;
  RunningProgram program_;
};

}  // namespace unietp
