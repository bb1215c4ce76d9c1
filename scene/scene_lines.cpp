#include "scene/scene_lines.h"

#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/json_parse.h"
#include "scene/node_json.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

constexpr std::size_t kMostLines = 1 << 14;  // remembered of a kind

/// Where the items of a list stand in a text as scene_to_json writes it, each on a line of its own.
struct Lines {
  std::size_t begin = 0, end = 0;  // in the text, between the brackets
  std::vector<std::string_view> items;
};

/// nullopt when the text is written otherwise.
std::optional<Lines> lines_of(std::string_view text, std::string_view name) {
  const std::string opening = "\n\"" + std::string(name) + "\": [\n";
  const auto found = text.find(opening);
  if (found == std::string_view::npos) return std::nullopt;
  Lines lines;
  lines.begin = found + opening.size() - 1;
  std::size_t at = lines.begin + 1;
  for (bool more = true; more;) {
    const auto end = text.find('\n', at);
    if (end == std::string_view::npos || end < at + 2) return std::nullopt;
    std::string_view item = text.substr(at, end - at);
    more = item.back() == ',';
    if (more) item.remove_suffix(1);
    if (item.front() != '{' || item.back() != '}') return std::nullopt;
    lines.items.push_back(item);
    at = end + 1;
  }
  if (at >= text.size() || text[at] != ']') return std::nullopt;
  lines.end = at;
  return lines;
}

/// False when a line is not one sound item.
template <class T, class Known>
bool read_items(const Lines& lines, Known& known, T (*read)(JsonReader&, const JsonAt&), std::vector<T>& items) {
  if (known.size() > kMostLines) known.clear();
  items.reserve(lines.items.size());
  for (const std::string_view line : lines.items) {
    const auto found = known.find(line);
    if (found != known.end()) {
      items.push_back(found->second);
      continue;
    }
    const auto json = parse_json("", line);
    if (!json) return false;
    JsonReader reader("");
    items.push_back(read(reader, JsonAt{*json}));
    if (reader.error()) return false;
    known.emplace(line, items.back());
  }
  return true;
}

}  // namespace

Result<Scene> SceneLines::read(std::string_view where, std::string_view text) {
  // Whatever is unusual, and whatever is wrong, is left to the one reader that knows where in the file it is.
  const auto nodes = lines_of(text, "nodes"), edges = lines_of(text, "edges");
  if (!nodes || !edges || edges->begin < nodes->end) return scene_from_json(where, text);
  std::string rest(text.substr(0, nodes->begin));
  rest += text.substr(nodes->end, edges->begin - nodes->end);
  rest += text.substr(edges->end);
  auto scene = scene_from_json(where, rest);
  if (!scene || !scene->nodes.empty() || !scene->edges.empty() ||
      !read_items(*nodes, nodes_, node_from_json, scene->nodes) ||
      !read_items(*edges, edges_, edge_from_json, scene->edges))
    return scene_from_json(where, text);
  auto whole = check_whole(where, std::move(*scene));
  return whole ? std::move(whole) : scene_from_json(where, text);
}

}  // namespace unietp
