#include "report/review_page.h"

#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/base64.h"
#include "core/files.h"
#include "core/ordered_work.h"
#include "core/text.h"
#include "report/asset.h"
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

/// Tasks of one home that are packed together.
struct Chunk {
  std::size_t number = 0;
  std::vector<ShownTask> tasks;
};

Result<std::string> packed(const Chunk& chunk, const PictureMaker& pictures) {
  Drawings drawings;
  Json shown = Json::array();
  for (const ShownTask& task : chunk.tasks) {
    const auto pair = pictures(task.record);
    if (!pair) return pair.error();
    Json card = card_json(task, pair->png);
    card["drawing"] = drawings.add(pair->svg);
    shown.push_back(std::move(card));
  }
  const Json json{
      {"layout", chunk.tasks.front().record.layout}, {"parts", std::move(drawings.parts)}, {"tasks", std::move(shown)}};
  return base64(gzip(json.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

/// Where each task of the list is packed: the number of its chunk and its place in it.
struct ChunkPlan {
  explicit ChunkPlan(const std::vector<ReviewEntry>& list) : places(list.size()) {
    std::map<std::string_view, std::vector<std::size_t>> homes;
    for (std::size_t i = 0; i < list.size(); ++i) homes[list[i].layout].push_back(i);
    for (const auto& [layout, tasks] : homes) {
      for (std::size_t k = 0; k < tasks.size(); ++k) {
        if (k % kChunk == 0) sizes.push_back(0);
        places[tasks[k]] = {sizes.size() - 1, k % kChunk};
        ++sizes.back();
      }
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> places;
  std::vector<std::size_t> sizes;  // tasks of each chunk
};

/// Collects tasks until a chunk is whole.
class Chunks {
 public:
  Chunks(const FinishedSet& set, const std::vector<ReviewEntry>& list, const ChunkPlan& plan,
         const ShownTaskSource& tasks)
      : set_(set), list_(list), plan_(plan), tasks_(tasks) {}

  /// The next whole chunk; nullopt after the last task.
  std::optional<Result<Chunk>> next() {
    while (auto task = tasks_()) {
      if (!*task) return task->error();
      if (read_ == list_.size() || list_[read_].id != (*task)->record.id ||
          list_[read_].layout != (*task)->record.layout)
        return changed_while_read(set_);
      const std::size_t number = plan_.places[read_++].first;
      auto& chunk = begun_[number];
      chunk.push_back(std::move(**task));
      if (chunk.size() < plan_.sizes[number]) continue;
      Chunk whole{number, std::move(chunk)};
      begun_.erase(number);
      return whole;
    }
    if (read_ < list_.size()) return changed_while_read(set_);
    return std::nullopt;
  }

 private:
  const FinishedSet& set_;
  const std::vector<ReviewEntry>& list_;
  const ChunkPlan& plan_;
  const ShownTaskSource& tasks_;
  std::size_t read_ = 0;
  std::map<std::size_t, std::vector<ShownTask>> begun_;
};

}  // namespace

Result<std::vector<ReviewEntry>> read_review_list(const FinishedSet& set, int threads) {
  auto reader = DatasetReader::open(set.folder, {});
  if (!reader) return reader.error();
  std::vector<ReviewEntry> list;
  const auto read = for_each_task<ReviewEntry>(
      std::move(*reader), threads,
      [](const FinishedTask& task) -> Result<ReviewEntry> {
        const TaskRecord& record = task.record;
        return ReviewEntry{record.id,          record.simulator, record.split, record.template_name,
                           record.instruction, record.layout};
      },
      [&](ReviewEntry&& entry) -> Result<Done> {
        list.push_back(std::move(entry));
        return Done{};
      });
  if (!read) return read.error();
  return list;
}

Result<ShownTaskSource> shown_tasks(const FinishedSet& set) {
  auto opened = DatasetReader::open(set.folder, {.modes = set.modes});
  if (!opened) return opened.error();
  const auto reader = std::make_shared<DatasetReader>(std::move(*opened));  // shared: std::function copies
  return ShownTaskSource([reader]() -> std::optional<Result<ShownTask>> {
    const auto lines = reader->lines().next();
    if (!lines) {
      if (const auto stray = reader->lines().next_stray()) return stray->error;
      return std::nullopt;
    }
    const auto task = reader->read(*lines);
    return task ? Result<ShownTask>(shown_task(*task)) : Result<ShownTask>(task.error());
  });
}

Result<std::string> review_page(const FinishedSet& set, const std::vector<ReviewEntry>& list,
                                const ShownTaskSource& tasks, int threads, const PictureMaker& pictures) {
  const ChunkPlan plan(list);
  Chunks chunks(set, list, plan, tasks);
  std::vector<std::string> made(plan.sizes.size());
  using Packed = std::pair<std::size_t, std::string>;  // number of the chunk
  const auto done = work_in_order<Result<Chunk>, Result<Packed>>(
      threads, [&] { return chunks.next(); },
      [&](const Result<Chunk>& chunk) -> Result<Packed> {
        if (!chunk) return chunk.error();
        auto text = packed(*chunk, pictures);
        if (!text) return text.error();
        return Packed(chunk->number, std::move(*text));
      },
      [&](Result<Packed>&& one) -> Result<Done> {
        if (!one) return one.error();
        made[one->first] = std::move(one->second);
        return Done{};
      });
  if (!done) return done.error();

  HtmlPage page;
  page.title = set.name + ": review";
  page.body = replace_all(std::string(asset("review.html")), "{{task}}", asset("task.html"));
  Json rows = Json::array();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const ReviewEntry& task = list[i];
    const auto& [chunk, place] = plan.places[i];
    rows.push_back({task.id, task.simulator, task.split, task.template_name, task.instruction, chunk, place});
  }
  const Json data{{"name", set.name}, {"tasks_sha256", set.digest}, {"tasks", std::move(rows)}};
  page.data.emplace_back("data", json_in_html(data.dump(-1, ' ', false, Json::error_handler_t::replace)));
  for (std::size_t i = 0; i < made.size(); ++i)
    page.data.emplace_back("chunk-" + std::to_string(i), std::move(made[i]));
  page.styles = {asset("page.css"), asset("review.css")};
  page.scripts = {asset("page.js"), asset("task.js"), asset("review.js")};
  return to_html(std::move(page));
}

}  // namespace unietp
