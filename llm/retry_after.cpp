#include "llm/retry_after.h"

#include <curl/curl.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ctime>

namespace unietp {

std::optional<double> retry_after_s(const std::string& retry_after, const std::string& date) {
  double seconds = 0;
  const char* end = retry_after.data() + retry_after.size();
  const auto [stopped, code] = std::from_chars(retry_after.data(), end, seconds, std::chars_format::fixed);
  if (code == std::errc() && stopped == end && !retry_after.empty()) {
    if (!std::isfinite(seconds) || seconds < 0) return std::nullopt;
    return seconds;
  }
  const std::time_t then = curl_getdate(retry_after.c_str(), nullptr);
  if (then == -1) return std::nullopt;
  const std::time_t said = curl_getdate(date.c_str(), nullptr);
  const std::time_t now = said == -1 ? std::time(nullptr) : said;
  return std::max(0.0, std::difftime(then, now));
}

}  // namespace unietp
