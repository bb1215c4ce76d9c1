#include "report/html.h"

#include <utility>

#include "core/base64.h"
#include "core/digest.h"
#include "core/text.h"

namespace unietp {
namespace {

/// The bytes that a hexadecimal digest names.
std::string bytes_of(const std::string& hexadecimal) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hexadecimal.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hexadecimal.substr(i, 2), nullptr, 16));
  return bytes;
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string json_in_html(std::string json) { return replace_all(std::move(json), "<", "\\u003c"); }

std::string to_html(HtmlPage page) {  // NOLINT(performance-unnecessary-value-param): its texts are let go one by one
  std::string script, style;
  for (const auto part : page.scripts) script.append(part).append("\n");
  for (const auto part : page.styles) style.append(part);
  const std::string policy = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-" +
                             base64(bytes_of(sha256(script))) + "'; base-uri 'none'; form-action 'none'" +
                             (page.asks_its_server ? "; connect-src 'self'" : "") +
                             (page.frames ? "; frame-src 'self' file:" : "");
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  html += "<meta http-equiv=\"Content-Security-Policy\" content=\"" + policy + "\">\n";
  html += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  html += "<title>" + escaped_html(page.title) + "</title>\n<style>\n" + style + "</style>\n</head>\n<body>\n";
  html += page.body;
  for (auto& [id, text] : page.data) {
    html += "<script type=\"text/plain\" id=\"" + escaped_html(id) + "\">";
    html += std::exchange(text, {});
    html += "</script>\n";
  }
  html += "<script>" + script + "</script>\n</body>\n</html>\n";
  return html;
}

}  // namespace unietp
