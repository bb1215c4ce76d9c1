#include "exports/task_folder.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/staged_folder.h"
#include "core/text.h"
#include "scene/telling_order.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

std::string left_out_line(const TaskRecord& task, const std::string& why) {
  using Json = nlohmann::ordered_json;
  const Json json{{"task", task.id}, {"simulator", task.simulator}, {"template", task.template_name}, {"reason", why}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::pair<std::string, std::size_t>> by_frequency(const std::map<std::string, std::size_t>& reasons) {
  std::vector<std::pair<std::string, std::size_t>> all(reasons.begin(), reasons.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  return all;
}

}  // namespace

Result<ExportedTasks> write_task_folder(const fs::path& dataset, const std::vector<Mode>& modes, const fs::path& out,
                                        const SayTask& say,
                                        const std::function<Result<Done>(const fs::path& folder)>& finish) {
  ExportedTasks made;
  const auto written = write_staged_folder(dataset, out, [&](const fs::path& aside) -> Result<Done> {
    auto tasks = DatasetReader::open(dataset, {.modes = modes, .starts = true});
    if (!tasks) return tasks.error();
    std::string left_out;
    auto read = for_each_task<std::string>(
        std::move(*tasks), 1,
        [&](const FinishedTask& finished) -> Result<std::string> {
          FinishedTask task = finished;
          task.start = in_telling_order(task.start);  // a new thing is not the last of its scene
          const auto why = say(task, aside);
          if (!why) return why.error();
          return *why ? left_out_line(task.record, **why) : std::string();
        },
        [&](std::string&& line) -> Result<Done> {
          ++(line.empty() ? made.said : made.left_out);
          if (!line.empty()) ++made.reasons[without_numbers(nlohmann::json::parse(line)["reason"])];
          left_out += line;
          return Done{};
        });
    if (!read) return read;
    if (finish) {
      if (auto done = finish(aside); !done) return done;
    }
    return write_file(aside, "left_out.jsonl", left_out);
  });
  if (!written) return written.error();
  return made;
}

std::string without_numbers(const std::string& reason) {
  std::vector<std::string> words = split(reason, ' ');
  for (std::string& word : words) {
    const auto at = word.rfind('_');
    const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    if (at == std::string::npos || at == 0 || at + 1 >= word.size() || !is_digit(word[at + 1])) continue;
    const auto end = std::find_if_not(word.begin() + static_cast<std::ptrdiff_t>(at) + 1, word.end(), is_digit);
    word.erase(word.begin() + static_cast<std::ptrdiff_t>(at), end);
  }
  return join(words, " ");
}

std::string reason_lines(const std::map<std::string, std::size_t>& reasons) {
  std::string lines;
  for (const auto& [reason, count] : by_frequency(reasons)) lines += "\n  " + std::to_string(count) + ": " + reason;
  return lines;
}

nlohmann::ordered_json reasons_json(const std::map<std::string, std::size_t>& reasons) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [reason, count] : by_frequency(reasons)) list.push_back({{"reason", reason}, {"tasks", count}});
  return list;
}

ExportSummary summary_of(const ExportedTasks& made, const fs::path& out) {
  using Json = nlohmann::ordered_json;
  const Json json{{"out", out.string()},
                  {"tasks", made.said},
                  {"left_out", made.left_out},
                  {"reasons", reasons_json(made.reasons)}};
  return {std::to_string(made.said) + " tasks in " + out.string() + ", " + std::to_string(made.left_out) + " left out" +
              reason_lines(made.reasons),
          json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

}  // namespace unietp
