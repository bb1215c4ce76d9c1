#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/result.h"

namespace unietp {

/// A whole request of HTTP/1.1 that passed the checks of HttpServer.
struct HttpRequest {
  std::string method;  // "POST"
  std::string target;  // "/v1/step"; with its query, if it has one
  std::string body;
};

/// What a server answers.
struct HttpResponse {
  int status = 200;
  std::string type = "application/json";
  std::string body;
};

/// Who sends messages over a WebSocket. A number is never used again.
struct ConnectionId {
  std::size_t value;
  auto operator<=>(const ConnectionId&) const = default;
};

/// What a server does with what it gets. It is called from HttpServer::serve only, one call at a time.
struct HttpService {
  std::function<HttpResponse(const HttpRequest&)> request;
  std::function<std::string(ConnectionId, std::string_view)> message;  // of a WebSocket; returns the answer
  std::function<void(ConnectionId)> closed;                            // a WebSocket that was opened
};

/// Where a server listens and what it accepts.
struct HttpOptions {
  std::string host = "127.0.0.1";  // the address to listen at
  int port = 0;                    // 0: one that is free
  std::string socket = "/v1/ws";   // the target of WebSockets
  std::size_t message_bytes = 0;   // of a request's body, and of a message
  std::size_t connections = 0;     // open at once; more are closed unanswered
};

/// HTTP/1.1 and WebSocket (RFC 6455) in one thread. Refuses requests that a web page of someone else could make a
/// browser send: the header Host must name an IP address, `localhost` or the host of the options, since any other name
/// may have been pointed at this machine by whoever owns it (DNS rebinding); and the header Origin, where there is one,
/// must be that of the server's own pages. Headers, bodies and messages are bounded, and so is the time in which they
/// must arrive. The only user of Boost.
class HttpServer {
 public:
  /// Errors: Usage when the host is no IP address; Io when it cannot listen there.
  static Result<HttpServer> listen(HttpOptions options, HttpService service);
  HttpServer(HttpServer&&) noexcept;
  HttpServer& operator=(HttpServer&&) noexcept;
  ~HttpServer();

  /// Where it listens: "http://127.0.0.1:8080".
  const std::string& url() const;
  /// Waits at most so long for something to do and does it.
  void serve(std::chrono::milliseconds at_most);

 private:
  struct Impl;
  explicit HttpServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
