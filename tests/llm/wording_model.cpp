#include "wording_model.h"

#include <nlohmann/json.hpp>

namespace unietp::test {
namespace {

using Json = nlohmann::json;

std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t from = text.find(before);
  if (from == std::string::npos) return "";
  const std::size_t start = from + before.size();
  return text.substr(start, text.find(after, start) - start);
}

}  // namespace

std::string WordingModel::content_for(const Json& body) {
  const std::string user = body["messages"][1]["content"];
  const std::scoped_lock lock(mutex_);
  if (user.find("Goal as a formula: ") != std::string::npos) {
    const std::string wordings = between(user, "that are right:\n", "\nWrite another one.");
    const std::string text = wordings.substr(wordings.rfind("- ") + 2);
    goal_of_[text] = between(user, "Goal as a formula: ", "\n");
    return Json{{"instruction", text}}.dump();
  }
  return Json{{"formula", goal_of_[between(user, "The instruction:\n", "\n")]}}.dump();
}

std::string WordingModel::operator()(const Received& received) {
  return completion(content_for(Json::parse(received.body)));
}

}  // namespace unietp::test
