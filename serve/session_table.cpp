#include "serve/session_table.h"

#include <sys/random.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <utility>

namespace unietp {

SessionTable::SessionTable(std::size_t most, std::chrono::seconds idle, std::function<std::string()> token)
    : most_(most), idle_(idle), token_(std::move(token)) {}

std::optional<std::string> SessionTable::open(Session session, ServerTime now) {
  reap(now);
  if (sessions_.size() >= most_) return std::nullopt;
  session.used = now;
  return sessions_.emplace(token_(), std::move(session)).first->first;
}

Session* SessionTable::find(std::string_view token, ServerTime now) {
  reap(now);
  const auto found = sessions_.find(token);
  if (found == sessions_.end()) return nullptr;
  found->second.used = now;
  return &found->second;
}

bool SessionTable::close(std::string_view token) {
  const auto found = sessions_.find(token);
  if (found == sessions_.end()) return false;
  sessions_.erase(found);
  return true;
}

void SessionTable::reap(ServerTime now) {
  std::erase_if(sessions_, [&](const auto& entry) { return now - entry.second.used > idle_; });
}

std::function<std::string()> counted_tokens() {
  return [last = 0]() mutable { return std::to_string(++last); };
}

std::function<std::string()> secret_tokens() {
  return [] {
    std::array<unsigned char, 16> bytes{};
    while (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
      if (errno != EINTR) throw std::runtime_error("the system gives no random numbers");
    }
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string token;
    for (const unsigned char byte : bytes) {
      token += kDigits[byte >> 4];
      token += kDigits[byte & 15];
    }
    return token;
  };
}

}  // namespace unietp
