#include "serve/methods.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/version.h"
#include "serve/episode_methods.h"
#include "serve/parameters.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kProtocolVersion = 1;
constexpr std::size_t kTasksInAnAnswer = 100;

MethodResult hello(const MethodCall& call) {
  Parameters parameters(call.parameters);
  if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
  Json methods = Json::array(), modes = Json::array();
  for (const Method& method : all_methods()) methods.push_back(method.name);
  const auto& stored = call.tasks.stored;
  for (const Mode mode : stored ? stored->modes() : std::vector<Mode>()) modes.push_back(name_of(mode));
  return Json{{"name", "unietp"},
              {"version", program_version()},
              {"protocol", kProtocolVersion},
              {"methods", std::move(methods)},
              {"tasks", stored ? stored->size() : 0},
              {"demonstrated", std::move(modes)},
              {"procedural", static_cast<bool>(call.tasks.made)},
              {"privileged", call.options.privileged},
              {"sessions", call.sessions.most()},
              {"idle_s", call.sessions.idle().count()}};
}

MethodResult tasks(const MethodCall& call) {
  Parameters parameters(call.parameters);
  const auto from = parameters.whole("from").value_or(0), count = parameters.whole("count").value_or(kTasksInAnAnswer);
  if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
  Json listed = Json::array();
  const std::size_t size = call.tasks.stored ? call.tasks.stored->size() : 0;
  const auto first = std::min<std::uint64_t>(from, size);
  const auto end = first + std::min<std::uint64_t>({size - first, count, kTasksInAnAnswer});
  for (auto i = first; i < end; ++i) {
    const TaskListing& task = call.tasks.stored->listing()[i];
    listed.push_back({{"index", i},
                      {"task", task.id},
                      {"simulator", task.simulator},
                      {"split", task.split},
                      {"instruction", task.instruction}});
  }
  return Json{{"total", size}, {"tasks", std::move(listed)}};
}

MethodResult open(const MethodCall& call) {
  Json settings = call.parameters;
  Session session;
  if (const auto pictures = settings.find("pictures"); pictures != settings.end()) {
    if (!pictures->is_boolean()) return wrong_parameters("/pictures: expected true or false");
    session.pictures = pictures->get<bool>();
    settings.erase(pictures);
  }
  auto read = settings_from_json(kCallName, settings);
  if (!read) return wrong_parameters(in_call(read.error()));
  if (session.pictures && !read->rules.picture) return wrong_parameters("/pictures: the setting \"picture\" is false");
  session.settings = *read;
  const Json known = settings_to_json(session.settings);
  const bool is_full = call.caller != nullptr && call.caller->sessions.size() >= call.caller->most_sessions;
  auto token = is_full ? std::nullopt : call.sessions.open(std::move(session), call.now);
  if (!token) return CallError{CallFailure::TooManySessions, "too many sessions are open; close one first"};
  if (call.caller != nullptr) call.caller->sessions.push_back(*token);
  return Json{{"session", *token}, {"settings", known}};
}

MethodResult close(const MethodCall& call) {
  Parameters parameters(call.parameters);
  const auto token = session_token(call, parameters);
  if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
  if (!token) return wrong_parameters("expected \"session\"");
  if (call.caller != nullptr) std::erase(call.caller->sessions, *token);
  if (!call.sessions.close(*token)) return unknown_session();
  return Json::object();
}

}  // namespace

const std::vector<Method>& all_methods() {
  static const std::vector<Method> kMethods{{"hello", hello},
                                            {"tasks", tasks},
                                            {"open", open},
                                            {"reset", reset_method},
                                            {"step", step_method},
                                            {"observe", observe_method},
                                            {"text", text_method},
                                            {"actions", actions_method},
                                            {"render", render_method},
                                            {"state", state_method},
                                            {"close", close}};
  return kMethods;
}

}  // namespace unietp
