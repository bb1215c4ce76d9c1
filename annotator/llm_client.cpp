#include "annotator/llm_client.h"

#include <curl/curl.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "core/text.h"

namespace unietp {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLargestAnswer = std::size_t{4} << 20;  // bytes

struct HttpAnswer {
  CURLcode result = CURLE_OK;
  long status = 0;
  std::string body, retry_after;
};

std::size_t take_body(char* data, std::size_t size, std::size_t count, void* user) {
  auto& body = *static_cast<std::string*>(user);
  if (body.size() + size * count > kLargestAnswer) return 0;  // ends the transfer
  body.append(data, size * count);
  return size * count;
}

std::size_t take_header(char* data, std::size_t size, std::size_t count, void* user) {
  const std::string line = lower(std::string_view(data, size * count));
  constexpr std::string_view kName = "retry-after:";
  if (line.starts_with(kName)) *static_cast<std::string*>(user) = trim(std::string_view(line).substr(kName.size()));
  return size * count;
}

bool is_loopback(const std::string& url) {
  const std::size_t host = url.find("://") == std::string::npos ? 0 : url.find("://") + 3;
  const std::string_view rest = std::string_view(url).substr(host);
  return rest.starts_with("127.") || rest.starts_with("localhost") || rest.starts_with("[::1]");
}

HttpAnswer post(const LlmEndpoint& endpoint, const std::string& body) {
  static std::once_flag started;  // libcurl's own set-up is not safe from two threads
  std::call_once(started, [] { curl_global_init(CURL_GLOBAL_DEFAULT); });
  HttpAnswer answer;
  const std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> handle(curl_easy_init(), &curl_easy_cleanup);
  if (handle == nullptr) {
    answer.result = CURLE_FAILED_INIT;
    return answer;
  }
  curl_slist* list = curl_slist_append(nullptr, "Content-Type: application/json");
  if (!endpoint.key.empty()) list = curl_slist_append(list, ("Authorization: Bearer " + endpoint.key).c_str());
  const std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)> headers(list, &curl_slist_free_all);
  CURL* curl = handle.get();
  curl_easy_setopt(curl, CURLOPT_URL, endpoint.url.c_str());
  curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers.get());
  curl_easy_setopt(curl, CURLOPT_POSTFIELDS, body.c_str());
  curl_easy_setopt(curl, CURLOPT_POSTFIELDSIZE, static_cast<long>(body.size()));
  curl_easy_setopt(curl, CURLOPT_TIMEOUT_MS, static_cast<long>(endpoint.timeout_s * 1000));
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, &take_body);
  curl_easy_setopt(curl, CURLOPT_WRITEDATA, &answer.body);
  curl_easy_setopt(curl, CURLOPT_HEADERFUNCTION, &take_header);
  curl_easy_setopt(curl, CURLOPT_HEADERDATA, &answer.retry_after);
  if (is_loopback(endpoint.url)) curl_easy_setopt(curl, CURLOPT_NOPROXY, "*");
  answer.result = curl_easy_perform(curl);
  curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &answer.status);
  return answer;
}

std::string body_of(const LlmEndpoint& endpoint, const LlmRequest& request) {
  const Json schema = {{"type", "object"},
                       {"properties", {{request.field, {{"type", "string"}}}}},
                       {"required", Json::array({request.field})},
                       {"additionalProperties", false}};
  const Json messages =
      Json::array({{{"role", "system"}, {"content", request.system}}, {{"role", "user"}, {"content", request.user}}});
  const Json body = {
      {"model", endpoint.model},
      {"messages", messages},
      {"response_format",
       {{"type", "json_schema"}, {"json_schema", {{"name", request.field}, {"strict", true}, {"schema", schema}}}}}};
  return body.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Error schema_error(const std::string& pointer, const std::string& message) {
  return {Error::Kind::Schema, "chat completion " + pointer, {}, message};
}

Result<LlmAnswer> read_answer(const std::string& body, const std::string& field) {
  const Json outer = Json::parse(body, nullptr, false);
  if (outer.is_discarded()) return schema_error("/", "expected a JSON object");
  const Json::json_pointer where("/choices/0/message/content");
  if (!outer.contains(where) || !outer.at(where).is_string())
    return schema_error(where.to_string(), "expected a string");
  const Json inner = Json::parse(outer.at(where).get<std::string>(), nullptr, false);
  if (!inner.is_object() || !inner.contains(field) || !inner.at(field).is_string())
    return schema_error(where.to_string(), "expected a JSON object with the string '" + field + "'");
  LlmAnswer answer;
  answer.text = inner.at(field).get<std::string>();
  const auto count = [&](const char* name) {
    const Json::json_pointer at(std::string("/usage/") + name);
    return outer.contains(at) && outer.at(at).is_number_integer() ? outer.at(at).get<int>() : 0;
  };
  answer.prompt_tokens = count("prompt_tokens");
  answer.completion_tokens = count("completion_tokens");
  return answer;
}

/// Seconds, when the header gives them; its date form is not used by these services.
std::optional<double> seconds_in(const std::string& retry_after) {
  if (retry_after.empty() || retry_after.size() > 6) return std::nullopt;
  if (!std::all_of(retry_after.begin(), retry_after.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  return std::stod(retry_after);
}

}  // namespace

Result<LlmAnswer> ask_llm(const LlmEndpoint& endpoint, const LlmRequest& request, Rng rng) {
  const std::string body = body_of(endpoint, request);
  double wait_s = endpoint.first_wait_s;
  std::string reason;
  for (int attempt = 1; attempt <= endpoint.max_attempts; ++attempt) {
    const HttpAnswer answer = post(endpoint, body);
    if (answer.result == CURLE_OK && answer.status >= 200 && answer.status < 300) {
      auto read = read_answer(answer.body, request.field);
      if (read) read->attempts = attempt;
      return read;
    }
    // The body is left out on purpose: a server may repeat the key in it.
    reason = answer.result != CURLE_OK ? curl_easy_strerror(answer.result) : "status " + std::to_string(answer.status);
    const bool again = answer.result != CURLE_OK || answer.status == 429 || answer.status >= 500;
    if (!again || attempt == endpoint.max_attempts) {
      reason += " after " + std::to_string(attempt) + (attempt == 1 ? " attempt" : " attempts");
      break;
    }
    const double asked = seconds_in(answer.retry_after).value_or(wait_s * (1 + rng.unit()));
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(asked, endpoint.longest_wait_s)));
    wait_s *= 2;
  }
  return Error{Error::Kind::Io, "language model", {}, "no answer: " + reason};
}

}  // namespace unietp
