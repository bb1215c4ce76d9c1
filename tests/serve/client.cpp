#include "client.h"

#include <stdexcept>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

namespace unietp::test {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;
using Code = boost::system::error_code;

constexpr std::string_view kScheme = "http://";

std::string host_of(const std::string& url) { return url.substr(kScheme.size()); }

tcp::socket connected(boost::asio::io_context& context, const std::string& url) {
  const auto host = host_of(url);
  const auto colon = host.rfind(':');
  tcp::socket socket(context);
  boost::asio::connect(socket, tcp::resolver(context).resolve(host.substr(0, colon), host.substr(colon + 1)));
  return socket;
}

}  // namespace

HttpReply ask(const std::string& url, const std::string& method, const std::string& target, const std::string& body,
              const std::map<std::string, std::string>& headers) {
  boost::asio::io_context context;
  auto socket = connected(context, url);
  http::request<http::string_body> question(http::string_to_verb(method), target, 11);
  question.set(http::field::host, host_of(url));
  question.set(http::field::connection, "close");
  for (const auto& [name, value] : headers) question.set(name, value);
  question.body() = body;
  question.prepare_payload();
  Code code;
  http::write(socket, question, code);
  beast::flat_buffer buffer;
  http::response<http::string_body> answer;
  http::read(socket, buffer, answer, code);
  HttpReply reply;
  if (code) return reply;
  reply.status = static_cast<int>(answer.result_int());
  for (const auto& field : answer) reply.headers[std::string(field.name_string())] = std::string(field.value());
  reply.body = answer.body();
  return reply;
}

std::string ask_raw(const std::string& url, const std::string& bytes) {
  boost::asio::io_context context;
  auto socket = connected(context, url);
  Code code;
  boost::asio::write(socket, boost::asio::buffer(bytes), code);
  std::string answer;
  boost::asio::read(socket, boost::asio::dynamic_buffer(answer), code);
  return answer;
}

struct WebSocketClient::Impl {
  explicit Impl(const std::string& url) : socket(connected(context, url)) {}
  boost::asio::io_context context;
  beast::websocket::stream<tcp::socket> socket;
};

WebSocketClient::WebSocketClient(const std::string& url, const std::string& target, const std::string& origin)
    : impl_(std::make_unique<Impl>(url)) {
  impl_->socket.set_option(beast::websocket::stream_base::decorator([&](beast::websocket::request_type& question) {
    if (!origin.empty()) question.set(http::field::origin, origin);
  }));
  beast::websocket::response_type answer;
  Code code;
  impl_->socket.handshake(answer, host_of(url), target, code);
  if (code) throw std::runtime_error(std::to_string(answer.result_int()) + " " + code.message());
}

WebSocketClient::~WebSocketClient() {
  Code code;
  impl_->socket.close(beast::websocket::close_code::normal, code);
}

std::string WebSocketClient::say(const std::string& text) {
  Code code;
  impl_->socket.write(boost::asio::buffer(text), code);
  beast::flat_buffer buffer;
  if (!code) impl_->socket.read(buffer, code);
  if (code) throw std::runtime_error(code.message());
  return beast::buffers_to_string(buffer.data());
}

}  // namespace unietp::test
