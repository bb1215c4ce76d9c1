#include "serve/http_protocol.h"

#include <map>
#include <memory>
#include <string_view>
#include <utility>

namespace unietp {
namespace {

constexpr std::string_view kMethods = "/v1/";

HttpResponse refusal(int status, const std::string& text) { return {status, "text/plain", text + "\n"}; }

HttpResponse routed(Protocol& protocol, const std::string& page, const HttpRequest& request) {
  const std::string_view target = request.target;
  const bool is_page = target == "/", is_call = target.starts_with(kMethods);
  if (!is_page && !is_call) return refusal(404, "there is a page at / and the protocol at /v1/");
  if (request.method != (is_page ? "GET" : "POST")) return refusal(405, is_page ? "expected GET" : "expected POST");
  if (is_page) return {200, "text/html", page};
  auto answered = protocol.call(target.substr(kMethods.size()), request.body, std::chrono::steady_clock::now());
  return {answered.failure ? http_status(*answered.failure) : 200, "application/json", std::move(answered.body)};
}

}  // namespace

HttpService http_service(Protocol& protocol, std::string page) {
  // Shared by the functions of the service, which std::function copies.
  const auto callers = std::make_shared<std::map<ConnectionId, Caller>>();
  HttpService service;
  service.request = [&protocol, page = std::move(page)](const HttpRequest& request) {
    return routed(protocol, page, request);
  };
  service.message = [&protocol, callers](ConnectionId connection, std::string_view text) {
    return protocol.message(text, (*callers)[connection], std::chrono::steady_clock::now());
  };
  service.closed = [&protocol, callers](ConnectionId connection) {
    protocol.leave((*callers)[connection]);
    callers->erase(connection);
  };
  return service;
}

}  // namespace unietp
