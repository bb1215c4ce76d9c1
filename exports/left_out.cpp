#include "exports/left_out.h"

#include <nlohmann/json.hpp>

namespace unietp {

std::string left_out_line(const TaskRecord& task, const std::string& why) {
  using Json = nlohmann::ordered_json;
  const Json json{{"task", task.id}, {"simulator", task.simulator}, {"template", task.template_name}, {"reason", why}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace unietp
