#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace unietp::test {

/// One request as it came in.
struct Received {
  int number = 0;           // counted from 0 in the order of arrival
  std::string head, body;   // the lines before the empty one; what follows
  std::string user;         // the user's message in a chat request
  bool structured = false;  // it has a response_format
};

/// An HTTP server on 127.0.0.1 that does as it is told, also badly; each connection has a thread of its own. A handler
/// gives the bytes to send before the connection is closed: a whole HTTP text, a part of one, or nothing.
/// kSilence keeps the connection open without a byte until the server goes.
class ChatServer {
 public:
  using Handler = std::function<std::string(const Received&)>;
  static const std::string kSilence;

  explicit ChatServer(Handler handler);
  ~ChatServer();
  ChatServer(const ChatServer&) = delete;
  ChatServer& operator=(const ChatServer&) = delete;

  std::string url;  // whole, to /v1/chat/completions
  std::vector<Received> received();
  int count() { return static_cast<int>(received().size()); }

 private:
  void accept_all();
  void serve(int peer);

  Handler handler_;
  int listener_ = -1;
  std::mutex mutex_;  // of the members below
  std::vector<Received> received_;
  std::vector<int> peers_;
  std::vector<std::thread> servings_;
  std::thread accepting_;
};

/// A whole HTTP answer; header lines end in CRLF.
std::string http(const std::string& status, const std::string& body, const std::string& headers = "");
/// A chat completion with that text from the model, which cost 11 and 7 tokens.
std::string completion(const std::string& content);

}  // namespace unietp::test
