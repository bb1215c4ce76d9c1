#include "exports/task_folder.h"

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/staged_folder.h"
#include "scene/telling_order.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

std::string left_out_line(const TaskRecord& task, const std::string& why) {
  using Json = nlohmann::ordered_json;
  const Json json{{"task", task.id}, {"simulator", task.simulator}, {"template", task.template_name}, {"reason", why}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
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
    const auto read = for_each_task<std::string>(
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

std::string summary_of(const ExportedTasks& made, const fs::path& out) {
  return std::to_string(made.said) + " tasks in " + out.string() + ", " + std::to_string(made.left_out) + " left out";
}

}  // namespace unietp
