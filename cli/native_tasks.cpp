#include "cli/native_tasks.h"

#include <memory>
#include <utility>

#include "exports/express.h"
#include "scene/telling_order.h"

namespace unietp {

Result<NotNative> refuse_not_native(const Resources& resources, const CommandLine& program) {
  struct Checking {
    ExportRequest request;
    NativeCheck check;
  };
  const auto own = std::make_shared<Checking>();  // shared: the result is copied, and its check refers to the request
  own->request.data = program.folders.root / "data";
  for (const Backend& backend : resources.backends)
    own->request.backends.push_back({&backend.knowledge, &backend.profile});
  auto check = native_check(own->request);
  if (!check) return check.error();
  own->check = std::move(*check);
  return NotNative([own](const Task& task, const WrittenTask& written) -> std::string {
    auto record = read_task("task", 1, written.line);
    auto shown = read_demonstration("demonstration", 1, written.shown.front());
    if (!record) return format(record.error());
    if (!shown) return format(shown.error());
    const FinishedTask finished{
        std::move(*record), {{Mode::M1, std::move(*shown)}}, std::nullopt, in_telling_order(task.episode.start)};
    auto why = own->check(finished);
    return why ? std::move(*why) : format(why.error());
  });
}

}  // namespace unietp
