#include "served.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <stdexcept>
#include <thread>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string all_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

/// The folder, in which there is now a pipe `in`.
const fs::path& with_pipe(const fs::path& folder) {
  if (::mkfifo((folder / "in").c_str(), 0600) != 0) throw std::runtime_error("no pipe");
  return folder;
}

}  // namespace

std::string request_line(int id, const ServedCall& call) {
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", call.method}, {"params", call.parameters}}.dump();
}

std::vector<ServedCall> demonstrated_calls(const fs::path& folder, const std::string& mode, std::size_t task) {
  const auto shown = json_lines(folder / "demonstrations" / (mode + ".jsonl")).at(task);
  std::vector<ServedCall> calls{{"open", {{"mode", mode}}}, {"reset", {{"task", shown["task"]}}}};
  for (const auto& step : shown["steps"])
    calls.push_back({"step", {{"action", {{"action", step["action"]}, {"args", step["args"]}}}}});
  return calls;
}

std::vector<std::string> served_lines(const fs::path& folder, const std::vector<std::string>& requests,
                                      const std::string& options) {
  const ScratchFolder scratch;
  if (!write_file(scratch.path() / "requests", all_lines(requests))) throw std::runtime_error("no requests");
  const auto ended = run_script("unietp serve '" + folder.string() + "' " + options + " < requests", scratch.path());
  if (ended.code != 0) throw std::runtime_error("unietp serve: " + ended.err);
  auto lines = split(ended.out, '\n');
  lines.pop_back();
  return lines;
}

LongCommand::LongCommand(const std::string& arguments)
    : program_("/bin/sh", {"-c", "exec unietp " + arguments + " <>in >out"}, with_pipe(folder_.path())) {}

void LongCommand::write(const std::string& text) const {
  const int pipe = ::open((folder_.path() / "in").c_str(), O_WRONLY | O_CLOEXEC);
  if (pipe < 0 || ::write(pipe, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    throw std::runtime_error("the program does not listen");
  ::close(pipe);
}

std::string LongCommand::printed() const {
  const auto text = read_file(folder_.path() / "out");
  return text ? *text : std::string();
}

std::string LongCommand::until_printed(const std::string& text) {
  for (auto all = printed();; all = printed()) {
    if (all.find(text) != std::string::npos) return all;
    if (!program_.running()) throw std::runtime_error("it ended without printing " + text);
    std::this_thread::yield();
  }
}

std::string LongCommand::url() {
  const std::string all = until_printed("http://"),
                    whole = all.find('\n', all.find("http://")) == std::string::npos ? until_printed("\n") : all;
  const auto start = whole.find("http://");
  return whole.substr(start, whole.find_first_of("/ \n", start + 7) - start);
}

}  // namespace unietp
