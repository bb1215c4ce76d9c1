#include "serve/play_page.h"

#include <utility>

#include "report/asset.h"
#include "report/html.h"
#include "serve/play_asset.h"

namespace unietp {

std::string play_page() {
  HtmlPage page;
  page.title = "unietp play";
  page.styles = {asset("page.css"), play_asset("play.css")};
  page.body = play_asset("play.html");
  page.scripts = {asset("page.js"), play_asset("play.js")};
  page.asks_its_server = true;
  return to_html(std::move(page));
}

}  // namespace unietp
