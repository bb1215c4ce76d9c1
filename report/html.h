#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unietp {

/// Text as it may stand in an element or in a quoted attribute.
std::string escaped_html(std::string_view text);
/// JSON as it may stand in a script element: no "<" is left in it, so that nothing in a text can end the element.
std::string json_in_html(std::string json);

/// A page that needs nothing but itself. Its policy lets no script run but its own and nothing be fetched, whatever a
/// data set's texts say.
struct HtmlPage {
  std::string title;
  std::vector<std::string_view> styles;
  std::string body;
  std::vector<std::pair<std::string, std::string>> data;  // id, text of script elements that are not run
  std::vector<std::string_view> scripts;                  // in order, run as one
};
std::string to_html(const HtmlPage& page);

}  // namespace unietp
