#include "scores/report_pages.h"

#include <array>
#include <cstdio>
#include <utility>

#include "report/html.h"

namespace unietp {

Result<Done> ReportPages::add(const std::string& view) {
  views_ += (count_ == 0 ? "[" : ",\n") + view;
  return ++count_ == kEpisodesInPage ? finish() : Result<Done>(Done{});
}

Result<Done> ReportPages::finish() {
  if (count_ == 0) return Done{};
  HtmlPage page;
  page.title = "Episodes of a report";
  page.body = "<p>The report beside this folder shows these episodes.</p>\n";
  page.data = {{"data", json_in_html(std::exchange(views_, {}) + "]")}};
  page.scripts = {"parent.postMessage(document.getElementById('data').textContent, '*');"};
  count_ = 0;
  std::array<char, 24> number{};
  (void)std::snprintf(number.data(), number.size(), "/%04d.html", ++pages_);
  return take_(kReportFolder + std::string(number.data()), to_html(std::move(page)));
}

}  // namespace unietp
