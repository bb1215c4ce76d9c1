#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unietp {

/// Text escaped for an element or a quoted attribute.
std::string escaped_html(std::string_view text);
/// JSON escaped for a script element: without "<", so that no text can end the element.
std::string json_in_html(std::string json);

/// A self-contained page. Its content security policy allows its own scripts only, and no requests but, if it says so,
/// to the server that it came from or for pages beside it, whatever the texts of a data set contain.
struct HtmlPage {
  std::string title;
  std::vector<std::string_view> styles;
  std::string body;
  std::vector<std::pair<std::string, std::string>> data;  // id, text of script elements that are not run
  std::vector<std::string_view> scripts;                  // in order, run as one
  bool asks_its_server = false;
  bool frames = false;  // shows pages from beside it, also on a disk
};
/// The whole page. Each of its data is freed once it is in the text.
std::string to_html(HtmlPage page);

}  // namespace unietp
