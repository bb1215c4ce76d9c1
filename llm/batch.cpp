#include "llm/batch.h"

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "llm/chat.h"
#include "llm/foreign_json.h"
#include "llm/json_object.h"
#include "llm/redact.h"

namespace unietp {
namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

constexpr const char* kPath = "/v1/chat/completions";

/// Marked as cached, since it was paid for when the batch ran.
Result<LlmAnswer> answer_in(const Json& line) {
  const auto failed = [](const std::string& message) {
    return Error{Error::Kind::Io, "batch answer", {}, plain_line(message, kLongestErrorMessage)};
  };
  const Pointer body("/response/body");
  if (!line.contains(body) || !line.at(body).is_object()) {
    const auto message = text_at(line, "/error/message");
    return failed(message.empty() ? "failed without a reason" : message);
  }
  const Pointer status("/response/status_code");
  const auto text = line.at(body).dump(-1, ' ', false, Json::error_handler_t::replace);
  if (line.contains(status) && line.at(status) != 200)
    return failed("status " + line.at(status).dump() + " " + error_message_in(text, ""));
  auto answer = read_completion(text, "");
  if (answer) answer->attempts = 1;
  return answer;
}

}  // namespace

LlmEndpoint batch_endpoint(std::string model) { return {kPath, std::move(model), ""}; }

std::string batch_line(const LlmEndpoint& endpoint, const LlmRequest& request) {
  const Json line = {{"custom_id", digest_of(endpoint, request)},
                     {"method", "POST"},
                     {"url", kPath},
                     {"body", Json::parse(chat_body(endpoint, request, LlmForm::ResponseFormat))}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string id_of_batch_line(std::string_view line) {
  const Json json = foreign_json(line);
  return json.is_object() ? text_at(json, "/custom_id") : "";
}

std::vector<std::string> batch_files(const std::vector<std::string>& lines, std::size_t most_lines,
                                     std::size_t most_bytes) {
  std::vector<std::string> files;
  std::size_t count = 0;
  for (const std::string& line : lines) {
    if (files.empty() || count == most_lines || files.back().size() + line.size() + 1 > most_bytes) {
      files.emplace_back();
      count = 0;
    }
    files.back().append(line).append("\n");
    ++count;
  }
  return files;
}

void read_batch_answers(std::string_view where, std::string_view text, BatchAnswers& into) {
  int number = 0;
  for (const std::string& line : split(text, '\n')) {
    ++number;
    if (trim(line).empty()) continue;
    const Json json = foreign_json(line);
    const auto id = json.is_object() ? text_at(json, "/custom_id") : "";
    if (id.empty()) {
      into.unreadable.push_back({Error::Kind::Parse,
                                 std::string(where),
                                 {number, 1},
                                 "expected a JSON object with a custom_id; is the file cut off?"});
      continue;
    }
    auto answer = answer_in(json);
    if (!answer) ++into.failures[id];
    const auto found = into.by_id.find(id);
    if (found == into.by_id.end()) {
      into.by_id.emplace(id, std::move(answer));
    } else if (answer && (!found->second || answer->text < found->second->text)) {
      found->second = std::move(answer);  // in any order of the files
    }
  }
}

}  // namespace unietp
