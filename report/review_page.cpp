#include "report/review_page.h"

#include <map>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/share_work.h"
#include "core/text.h"
#include "report/asset.h"
#include "report/base64.h"
#include "report/html.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kChunk = 24;  // tasks that are compressed together

/// The distinct elements of all drawings, and each drawing as runs of them: first, length, first, length, …
class Drawings {
 public:
  Json add(const std::string& svg) {
    Json runs = Json::array();
    std::size_t from = 0, before = 0;
    while (from < svg.size()) {
      std::size_t end = svg.find('>', from) + 1;  // no attribute of our drawings has one
      if (svg.compare(from, 3, "<g>") == 0) end = svg.find("</g>", from) + 4;
      if (svg.compare(from, 6, "<text ") == 0) end = svg.find("</text>", from) + 7;
      if (svg.compare(from, 7, "<title>") == 0) end = svg.find("</title>", from) + 8;
      if (end <= from || end > svg.size()) end = svg.size();
      const auto [known, is_new] = numbers_.emplace(svg.substr(from, end - from), parts.size());
      if (is_new) parts.push_back(known->first);
      if (!runs.empty() && known->second == before + 1) {
        runs.back() = runs.back().get<std::size_t>() + 1;
      } else {
        runs.push_back(known->second);
        runs.push_back(1);
      }
      before = known->second;
      from = end;
    }
    return runs;
  }
  Json parts = Json::array();

 private:
  std::map<std::string, std::size_t> numbers_;
};

Result<std::string> packed(const FinishedSet& set, const std::vector<std::size_t>& tasks,
                           const std::vector<std::vector<PlanCard>>& plans, const PictureMaker& pictures) {
  Drawings drawings;
  Json shown = Json::array();
  for (const std::size_t i : tasks) {
    const auto pair = pictures(i);
    if (!pair) return pair.error();
    Json card = card_json(set.tasks[i], plans[i], pair->png);
    card["drawing"] = drawings.add(pair->svg);
    shown.push_back(std::move(card));
  }
  const Json chunk{
      {"layout", set.tasks[tasks.front()].layout}, {"parts", std::move(drawings.parts)}, {"tasks", std::move(shown)}};
  return base64(gzip(chunk.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

}  // namespace

Result<std::string> review_page(const FinishedSet& set, const std::vector<std::vector<PlanCard>>& plans, int threads,
                                const PictureMaker& pictures) {
  std::map<std::string, std::vector<std::size_t>> homes;
  for (std::size_t i = 0; i < set.tasks.size(); ++i) homes[set.tasks[i].layout].push_back(i);
  std::vector<std::vector<std::size_t>> chunks;
  std::vector<std::pair<std::size_t, std::size_t>> places(set.tasks.size());  // chunk, place in it
  for (const auto& [layout, tasks] : homes) {
    for (std::size_t k = 0; k < tasks.size(); ++k) {
      if (k % kChunk == 0) chunks.emplace_back();
      places[tasks[k]] = {chunks.size() - 1, k % kChunk};
      chunks.back().push_back(tasks[k]);
    }
  }
  std::vector<std::optional<Result<std::string>>> made(chunks.size());
  share_work(threads, chunks.size(), [&](std::size_t i) { made[i] = packed(set, chunks[i], plans, pictures); });

  HtmlPage page;
  page.title = set.name + ": review";
  page.body = replace_all(std::string(asset("review.html")), "{{task}}", asset("task.html"));
  Json tasks = Json::array();
  for (std::size_t i = 0; i < set.tasks.size(); ++i) {
    const TaskRecord& task = set.tasks[i];
    tasks.push_back(
        {task.id, task.simulator, task.split, task.template_name, task.instruction, places[i].first, places[i].second});
  }
  const Json data{{"name", set.name}, {"tasks_sha256", set.digest}, {"tasks", std::move(tasks)}};
  page.data.emplace_back("data", json_in_html(data.dump(-1, ' ', false, Json::error_handler_t::replace)));
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (!*made[i]) return made[i]->error();
    page.data.emplace_back("chunk-" + std::to_string(i), std::move(**made[i]));
    made[i].reset();
  }
  page.styles = {asset("page.css"), asset("review.css")};
  page.scripts = {asset("task.js"), asset("review.js")};
  return to_html(page);
}

}  // namespace unietp
