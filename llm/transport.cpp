#include "llm/transport.h"

#include <curl/curl.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>

#include "core/limits.h"
#include "core/text.h"

namespace unietp {
namespace {

struct EasyEnd {
  void operator()(CURL* easy) const { curl_easy_cleanup(easy); }
};
struct MultiEnd {
  void operator()(CURLM* multi) const { curl_multi_cleanup(multi); }
};
struct ListEnd {
  void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};

struct Transfer {
  HttpAnswer answer;
  std::string sent;
  std::unique_ptr<CURL, EasyEnd> easy;
};

std::size_t take_body(char* data, std::size_t size, std::size_t count, void* user) {
  auto& transfer = *static_cast<Transfer*>(user);
  transfer.answer.too_large = transfer.answer.body.size() + size * count > limits::kAnswerBytes;
  if (transfer.answer.too_large) return 0;  // ends the transfer
  transfer.answer.body.append(data, size * count);
  return size * count;
}

std::size_t take_header(char* data, std::size_t size, std::size_t count, void* user) {
  auto& answer = static_cast<Transfer*>(user)->answer;
  const std::string_view line(data, size * count);
  const auto value_of = [&](std::string_view name, std::string& value) {
    if (lower(line.substr(0, name.size())) == name) value = trim(line.substr(name.size()));
  };
  value_of("retry-after:", answer.retry_after);
  value_of("date:", answer.date);
  return size * count;
}

bool is_loopback(const std::string& url) {
  const std::string_view host = std::string_view(url).substr(url.find("://") + 3);
  return host.starts_with("127.") || host.starts_with("localhost") || host.starts_with("[::1]");
}

long milliseconds(double seconds) { return static_cast<long>(std::ceil(std::clamp(seconds, 0.001, 1e6) * 1000)); }

}  // namespace

struct Transport::Impl {
  LlmEndpoint endpoint;
  long attempt_ms;
  std::unique_ptr<curl_slist, ListEnd> headers;
  std::unique_ptr<CURLM, MultiEnd> multi;
  std::map<CURL*, std::unique_ptr<Transfer>> transfers;  // by handle; never iterated into output

  void add_header(const std::string& line) {
    curl_slist* longer = curl_slist_append(headers.get(), line.c_str());
    if (longer == nullptr) throw std::runtime_error("libcurl: out of memory");
    (void)headers.release();
    headers.reset(longer);
  }
};

Transport::Transport(const LlmEndpoint& endpoint, double attempt_s) : impl_(std::make_unique<Impl>()) {
  static std::once_flag started;  // curl_global_init is not thread-safe
  std::call_once(started, [] { curl_global_init(CURL_GLOBAL_DEFAULT); });
  impl_->endpoint = endpoint;
  impl_->attempt_ms = milliseconds(attempt_s);
  impl_->add_header("Content-Type: application/json");
  impl_->add_header("Expect:");  // no delay before long prompts
  if (!endpoint.key.empty()) impl_->add_header("Authorization: Bearer " + endpoint.key);
  impl_->multi.reset(curl_multi_init());
  if (impl_->multi == nullptr) throw std::runtime_error("libcurl: out of memory");
}

Transport::~Transport() {
  for (const auto& [easy, transfer] : impl_->transfers) curl_multi_remove_handle(impl_->multi.get(), easy);
}

int Transport::in_progress() const { return static_cast<int>(impl_->transfers.size()); }

void Transport::start(std::size_t id, std::string body) {
  auto transfer = std::make_unique<Transfer>();
  transfer->answer.id = id;
  transfer->sent = std::move(body);
  transfer->easy.reset(curl_easy_init());
  CURL* easy = transfer->easy.get();
  if (easy == nullptr) throw std::runtime_error("libcurl: out of memory");
  curl_easy_setopt(easy, CURLOPT_URL, impl_->endpoint.url.c_str());
  curl_easy_setopt(easy, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(easy, CURLOPT_HTTPHEADER, impl_->headers.get());
  curl_easy_setopt(easy, CURLOPT_POSTFIELDS, transfer->sent.c_str());
  curl_easy_setopt(easy, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(transfer->sent.size()));
  curl_easy_setopt(easy, CURLOPT_TIMEOUT_MS, impl_->attempt_ms);
  curl_easy_setopt(easy, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(easy, CURLOPT_WRITEFUNCTION, &take_body);
  curl_easy_setopt(easy, CURLOPT_WRITEDATA, transfer.get());
  curl_easy_setopt(easy, CURLOPT_HEADERFUNCTION, &take_header);
  curl_easy_setopt(easy, CURLOPT_HEADERDATA, transfer.get());
  if (is_loopback(impl_->endpoint.url)) curl_easy_setopt(easy, CURLOPT_NOPROXY, "*");
  curl_multi_add_handle(impl_->multi.get(), easy);
  impl_->transfers.emplace(easy, std::move(transfer));
}

std::vector<HttpAnswer> Transport::wait(double seconds) {
  int running = 0;
  curl_multi_perform(impl_->multi.get(), &running);
  const bool something_ended = running < in_progress();
  if (!something_ended) {
    curl_multi_poll(impl_->multi.get(), nullptr, 0, static_cast<int>(milliseconds(seconds)), nullptr);
    curl_multi_perform(impl_->multi.get(), &running);
  }
  std::vector<HttpAnswer> ended;
  int left = 0;
  while (const CURLMsg* message = curl_multi_info_read(impl_->multi.get(), &left)) {
    CURL* easy = message->easy_handle;
    const CURLcode code = message->data.result;  // read before the handle is removed, which frees the message
    const auto found = impl_->transfers.find(easy);
    auto& transfer = *found->second;
    curl_easy_getinfo(easy, CURLINFO_RESPONSE_CODE, &transfer.answer.status);
    transfer.answer.timed_out = code == CURLE_OPERATION_TIMEDOUT;
    if (transfer.answer.too_large) {
      transfer.answer.failure = "an answer of more than " + std::to_string(limits::kAnswerBytes >> 20) + " MB";
    } else if (code != CURLE_OK) {
      transfer.answer.failure = curl_easy_strerror(code);
    }
    ended.push_back(std::move(transfer.answer));
    curl_multi_remove_handle(impl_->multi.get(), easy);
    impl_->transfers.erase(found);
  }
  return ended;
}

}  // namespace unietp
