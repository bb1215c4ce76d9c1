#include "serve/http_origin.h"

#include <arpa/inet.h>

#include <algorithm>
#include <string_view>

#include "core/text.h"

namespace unietp {
namespace {

bool is_address(int family, const std::string& text) {
  unsigned char bytes[sizeof(in6_addr)];
  return ::inet_pton(family, text.c_str(), bytes) == 1;
}

bool is_digits(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The host of "host", "host:port" or "[v6]:port"; "" for anything else.
std::string host_of(const std::string& header) {
  const bool v6 = header.starts_with('[');
  const auto end = v6 ? header.find(']') : header.find(':');
  if (v6 && end == std::string::npos) return "";
  const std::string_view rest = end == std::string::npos ? "" : std::string_view(header).substr(end + (v6 ? 1 : 0));
  if (!rest.empty() && !(rest.front() == ':' && is_digits(rest.substr(1)))) return "";
  return v6 ? header.substr(1, end - 1) : header.substr(0, end);
}

}  // namespace

std::optional<std::string> foreign(const std::string& host, const std::optional<std::string>& origin,
                                   const std::string& own) {
  const std::string name = host_of(host);
  const bool is_known = is_address(AF_INET, name) || is_address(AF_INET6, name) || lower(name) == "localhost" ||
                        (!name.empty() && name == own);
  if (!is_known) return "the header Host must name an IP address or localhost";
  if (origin && *origin != "http://" + host) return "the request comes from a page of another origin";
  return std::nullopt;
}

bool is_loopback(const std::string& address) {
  in_addr v4{};
  return ::inet_pton(AF_INET, address.c_str(), &v4) == 1 ? ntohl(v4.s_addr) >> 24 == 127 : address == "::1";
}

}  // namespace unietp
