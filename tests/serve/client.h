#pragma once

#include <map>
#include <memory>
#include <string>

namespace unietp::test {

struct HttpReply {
  int status = 0;  // 0: the connection was closed without an answer
  std::map<std::string, std::string> headers;
  std::string body;
};

/// One request of HTTP/1.1 on a connection of its own. `url`: "http://127.0.0.1:8080". `headers` replace the usual
/// ones.
HttpReply ask(const std::string& url, const std::string& method, const std::string& target,
              const std::string& body = "", const std::map<std::string, std::string>& headers = {});
/// The bytes as they are, on a connection of its own; returns all that comes back until it is closed.
std::string ask_raw(const std::string& url, const std::string& bytes);

/// A WebSocket by a library that the program's own server is made with, too, but in the part of a client.
class WebSocketClient {
 public:
  /// Throws std::runtime_error when it is refused, with the status.
  explicit WebSocketClient(const std::string& url, const std::string& target = "/v1/ws",
                           const std::string& origin = "");
  WebSocketClient(const WebSocketClient&) = delete;
  WebSocketClient& operator=(const WebSocketClient&) = delete;
  ~WebSocketClient();  // closes it

  /// Sends a message and returns the answer. Throws std::runtime_error when the connection was closed instead.
  std::string say(const std::string& text);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp::test
