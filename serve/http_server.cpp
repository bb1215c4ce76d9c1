#include "serve/http_server.h"

#include <optional>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "core/limits.h"
#include "serve/http_origin.h"

namespace unietp {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::asio::ip::tcp;
using Code = boost::system::error_code;
using Question = http::request<http::string_body>;

constexpr std::chrono::seconds kPatience{30};  // for a request to arrive whole, or an answer to leave
constexpr std::chrono::seconds kQuiet{120};    // without a sign of life from the other end of a WebSocket

/// What all connections share. They hold on to it, since they may outlive the server's other parts.
struct Shared {
  HttpOptions options;
  HttpService service;
  std::size_t open = 0, last = 0;
};

/// Counts a connection as long as it lives.
class Counted {
 public:
  explicit Counted(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) { ++shared_->open; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --shared_->open; }
  Shared& operator*() const { return *shared_; }
  Shared* operator->() const { return shared_.get(); }

 private:
  std::shared_ptr<Shared> shared_;
};

/// A WebSocket: one message is answered after the other, so that nothing piles up.
class Talk : public std::enable_shared_from_this<Talk> {
 public:
  Talk(beast::tcp_stream&& stream, std::shared_ptr<Counted> shared)
      : shared_(std::move(shared)), id_{++(*shared_)->last}, socket_(std::move(stream)) {}
  Talk(const Talk&) = delete;
  Talk& operator=(const Talk&) = delete;
  ~Talk() {
    if (is_open_) (*shared_)->service.closed(id_);
  }

  void start(const Question& question) {
    socket_.set_option(websocket::stream_base::timeout{kPatience, kQuiet, true});
    socket_.read_message_max((*shared_)->options.message_bytes);
    socket_.async_accept(question, [self = shared_from_this()](Code code) {
      self->is_open_ = !code;
      if (!code) self->read();
    });
  }

 private:
  void read() {
    socket_.async_read(incoming_, [self = shared_from_this()](Code code, std::size_t) {
      if (!code) self->reply();
    });
  }
  void reply() {
    const auto bytes = incoming_.cdata();
    answer_ = (*shared_)->service.message(id_, {static_cast<const char*>(bytes.data()), bytes.size()});
    incoming_.clear();
    socket_.text(true);
    socket_.async_write(boost::asio::buffer(answer_), [self = shared_from_this()](Code code, std::size_t) {
      if (!code) self->read();
    });
  }

  std::shared_ptr<Counted> shared_;
  ConnectionId id_;
  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_buffer incoming_;
  std::string answer_;
  bool is_open_ = false;
};

/// A connection of HTTP, which may become a WebSocket.
class Visit : public std::enable_shared_from_this<Visit> {
 public:
  Visit(tcp::socket&& socket, std::shared_ptr<Counted> shared)
      : shared_(std::move(shared)), stream_(std::move(socket)) {}

  void read() {
    parser_.emplace();
    parser_->header_limit(limits::kHeaderBytes);
    parser_->body_limit((*shared_)->options.message_bytes);
    stream_.expires_after(kPatience);
    http::async_read(stream_, incoming_, *parser_,
                     [self = shared_from_this()](Code code, std::size_t) { self->on_read(code); });
  }

 private:
  void on_read(Code code) {
    if (code == http::error::body_limit) return refuse(http::status::payload_too_large, "the body is too long");
    if (code == http::error::header_limit)
      return refuse(http::status::request_header_fields_too_large, "the headers are too long");
    if (code.category() == http::make_error_code(http::error::end_of_stream).category() &&
        code != http::error::end_of_stream && code != http::error::partial_message)
      return refuse(http::status::bad_request, "this is not HTTP/1.1");
    if (code) return;  // it went away, or was too slow
    const Question& question = parser_->get();
    if (const auto reason =
            foreign(text_of(question, http::field::host), origin_of(question), (*shared_)->options.host))
      return refuse(http::status::forbidden, *reason);
    const bool is_talk = question.target() == (*shared_)->options.socket;
    if (is_talk && websocket::is_upgrade(question)) {
      stream_.expires_never();  // a WebSocket watches the time itself
      return std::make_shared<Talk>(std::move(stream_), shared_)->start(question);
    }
    if (is_talk) return refuse(http::status::upgrade_required, "expected a WebSocket");
    write((*shared_)->service.request({std::string(question.method_string()), std::string(question.target()),
                                       std::move(parser_->get().body())}),
          question.keep_alive());
  }

  static std::string text_of(const Question& question, http::field field) { return std::string(question[field]); }
  static std::optional<std::string> origin_of(const Question& question) {
    const auto origin = question.find(http::field::origin);
    return origin == question.end() ? std::nullopt : std::optional(std::string(origin->value()));
  }

  void refuse(http::status status, const std::string& reason) {
    write({static_cast<int>(status), "text/plain", reason + "\n"}, false);
  }

  void write(HttpResponse&& answer, bool keep_alive) {
    answer_ = {};
    answer_.version(11);
    answer_.result(static_cast<unsigned>(answer.status));
    answer_.set(http::field::content_type, answer.type + "; charset=utf-8");
    answer_.set(http::field::cache_control, "no-store");
    answer_.set("Referrer-Policy", "no-referrer");
    answer_.set(http::field::x_frame_options, "DENY");
    answer_.set("X-Content-Type-Options", "nosniff");
    answer_.body() = std::move(answer.body);
    answer_.keep_alive(keep_alive);
    answer_.prepare_payload();
    stream_.expires_after(kPatience);
    http::async_write(stream_, answer_, [self = shared_from_this(), keep_alive](Code code, std::size_t) {
      if (code) return;
      if (keep_alive) return self->read();
      Code ignored;  // it may have gone already
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
      self->stream_.expires_after(kPatience);
      self->drain(4 * (*self->shared_)->options.message_bytes);
    });
  }

  /// Reads what is still on its way, as otherwise the system tells the other end of an error before it has the answer.
  void drain(std::size_t at_most) {
    incoming_.clear();
    stream_.async_read_some(incoming_.prepare(limits::kHeaderBytes),
                            [self = shared_from_this(), at_most](Code code, std::size_t count) {
                              if (!code && count < at_most) self->drain(at_most - count);
                            });
  }

  std::shared_ptr<Counted> shared_;
  beast::tcp_stream stream_;
  beast::flat_buffer incoming_;
  std::optional<http::request_parser<http::string_body>> parser_;
  http::response<http::string_body> answer_;
};

Error cannot_listen(const HttpOptions& options, const Code& code) {
  return {
      Error::Kind::Io, options.host + ":" + std::to_string(options.port), {}, "cannot listen there: " + code.message()};
}

}  // namespace

struct HttpServer::Impl {
  explicit Impl(HttpOptions options, HttpService service)
      : shared(std::make_shared<Shared>(Shared{std::move(options), std::move(service)})), listener(context) {}

  void accept() {
    listener.async_accept([this](Code code, tcp::socket socket) {
      if (!code && shared->open < shared->options.connections)
        std::make_shared<Visit>(std::move(socket), std::make_shared<Counted>(shared))->read();
      if (code != boost::asio::error::operation_aborted) accept();
    });
  }

  std::shared_ptr<Shared> shared;
  std::string url;
  boost::asio::io_context context{1};
  tcp::acceptor listener;
};

HttpServer::HttpServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HttpServer::HttpServer(HttpServer&&) noexcept = default;
HttpServer& HttpServer::operator=(HttpServer&&) noexcept = default;
HttpServer::~HttpServer() = default;

Result<HttpServer> HttpServer::listen(HttpOptions options, HttpService service) {
  Code code;
  const auto address = boost::asio::ip::make_address(options.host, code);
  if (code) return Error{Error::Kind::Usage, "--host", {}, "expected an IP address, such as 127.0.0.1"};
  auto impl = std::make_unique<Impl>(std::move(options), std::move(service));
  const HttpOptions& asked = impl->shared->options;
  const tcp::endpoint place(address, static_cast<unsigned short>(asked.port));
  auto& listener = impl->listener;
  (void)listener.open(place.protocol(), code);
  if (!code) (void)listener.set_option(boost::asio::socket_base::reuse_address(true), code);
  if (!code) (void)listener.bind(place, code);
  if (!code) (void)listener.listen(boost::asio::socket_base::max_listen_connections, code);
  if (code) return cannot_listen(asked, code);
  const std::string host = address.is_v6() ? "[" + asked.host + "]" : asked.host;
  impl->url = "http://" + host + ":" + std::to_string(listener.local_endpoint(code).port());
  impl->accept();
  return HttpServer(std::move(impl));
}

const std::string& HttpServer::url() const { return impl_->url; }

void HttpServer::serve(std::chrono::milliseconds at_most) { (void)impl_->context.run_one_for(at_most); }

}  // namespace unietp
