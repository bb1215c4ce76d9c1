#include "server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>

#include <nlohmann/json.hpp>

namespace unietp::test {
namespace {

using Json = nlohmann::json;

/// Reads until the body is whole or the peer is gone.
bool read_request(int peer, std::string& head, std::string& body) {
  std::string bytes;
  char buffer[4096];
  for (;;) {
    const ssize_t got = ::recv(peer, buffer, sizeof buffer, 0);
    if (got <= 0) return false;
    bytes.append(buffer, static_cast<std::size_t>(got));
    const auto end = bytes.find("\r\n\r\n"), length = bytes.find("Content-Length: ");
    if (end == std::string::npos || length == std::string::npos) continue;
    const auto whole = static_cast<std::size_t>(std::stoul(bytes.substr(length + 16)));
    if (bytes.size() < end + 4 + whole) continue;
    head = bytes.substr(0, end);
    body = bytes.substr(end + 4);
    return true;
  }
}

void send_all(int peer, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t now = ::send(peer, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (now <= 0) return;
    sent += static_cast<std::size_t>(now);
  }
}

}  // namespace

const std::string ChatServer::kSilence = "\1silence";

ChatServer::ChatServer(Handler handler) : handler_(std::move(handler)) {
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(listener_, 64) != 0)
    throw std::runtime_error("no socket on loopback");
  ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
  url = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/v1/chat/completions";
  accepting_ = std::thread([this] { accept_all(); });
}

ChatServer::~ChatServer() {
  ::shutdown(listener_, SHUT_RDWR);
  accepting_.join();
  ::close(listener_);
  {
    const std::lock_guard lock(mutex_);
    for (const int peer : peers_) ::shutdown(peer, SHUT_RDWR);
  }
  for (auto& serving : servings_) serving.join();
  for (const int peer : peers_) ::close(peer);
}

std::vector<Received> ChatServer::received() {
  const std::lock_guard lock(mutex_);
  return received_;
}

void ChatServer::accept_all() {
  for (;;) {
    const int peer = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (peer < 0) return;
    const std::lock_guard lock(mutex_);
    peers_.push_back(peer);
    servings_.emplace_back([this, peer] { serve(peer); });
  }
}

namespace {

/// The text of a message; of one with pictures, that of its parts.
std::string text_of(const Json& message) {
  const Json content = message.value("content", Json(""));
  if (content.is_string()) return content;
  std::string text;
  for (const Json& part : content) text += part.value("text", "");
  return text;
}

}  // namespace

void ChatServer::serve(int peer) {
  Received received;
  if (!read_request(peer, received.head, received.body)) return;
  const Json json = Json::parse(received.body, nullptr, false);
  if (json.is_object()) {
    received.structured = json.contains("response_format");
    if (json.contains("messages")) received.user = text_of(json["messages"].back());
  }
  {
    const std::lock_guard lock(mutex_);
    received.number = static_cast<int>(received_.size());
    received_.push_back(received);
  }
  const auto answer = handler_(received);
  if (answer == kSilence) return;
  send_all(peer, answer);
  ::shutdown(peer, SHUT_RDWR);
}

std::string http(const std::string& status, const std::string& body, const std::string& headers) {
  return "HTTP/1.1 " + status + "\r\n" + headers + "Content-Length: " + std::to_string(body.size()) +
         "\r\nConnection: close\r\n\r\n" + body;
}

std::string completion(const std::string& content) {
  const Json body = {{"choices", Json::array({{{"message", {{"role", "assistant"}, {"content", content}}}}})},
                     {"usage", {{"prompt_tokens", 11}, {"completion_tokens", 7}}}};
  return http("200 OK", body.dump(), "Content-Type: application/json\r\n");
}

}  // namespace unietp::test
