#include "includes.h"

#include <algorithm>
#include <set>

#include "core/text.h"

namespace unietp {
namespace {

/// What an include in quotes names, "" for other lines.
std::string quoted_include(std::string_view line) {
  const auto trimmed = trim(line);
  if (!trimmed.starts_with("#include")) return "";
  const auto open = trimmed.find('"');
  const auto close = open == std::string_view::npos ? open : trimmed.find('"', open + 1);
  return close == std::string_view::npos ? "" : std::string(trimmed.substr(open + 1, close - open - 1));
}

std::string stem_of(const std::string& path) { return path.substr(0, path.rfind('.')); }

/// The room that an include names, "" for one in angle brackets.
std::string room_of_include(std::string_view line) {
  const auto name = quoted_include(line);
  const auto slash = name.find('/');
  return slash == std::string::npos ? "" : name.substr(0, slash);
}

/// `<vector>`, `<unistd.h>`: no folder. Ours and the third parties' headers stand in one.
bool is_third_party(std::string_view name) {
  static const std::set<std::string_view> kWithoutFolder{"sqlite3.h", "libdeflate.h", "btBulletDynamicsCommon.h",
                                                         "btBulletCollisionCommon.h"};
  const bool posix = name.starts_with("sys/");
  return (name.find('/') != std::string_view::npos && !posix) || kWithoutFolder.count(name) > 0;
}

bool allowed_in_header(std::string_view name, std::string_view room) {
  return name == "nlohmann/json_fwd.hpp" || (room == "scene" && name.starts_with("Eigen/"));
}

}  // namespace

RoomGraph read_room_graph(std::string_view text) {
  RoomGraph graph;
  for (const auto& line : split(text, '\n')) {
    const auto colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::string room(trim(line.substr(0, colon)));
    graph.rooms.push_back(room);
    for (const auto& below : split(line.substr(colon + 1), ';')) {
      if (!trim(below).empty()) graph.depends[room].emplace_back(trim(below));
    }
  }
  return graph;
}

std::vector<std::string> graph_problems(const RoomGraph& graph) {
  std::vector<std::string> problems;
  const auto level = [&](const std::string& room) {
    return std::find(graph.rooms.begin(), graph.rooms.end(), room) - graph.rooms.begin();
  };
  for (const auto& [room, depends] : graph.depends) {
    for (const auto& below : depends) {
      if (level(below) == static_cast<std::ptrdiff_t>(graph.rooms.size())) {
        problems.push_back(room + " declares " + below + ", which is no room");
      } else if (level(below) >= level(room)) {
        problems.push_back(room + " declares " + below + ", which stands above it");
      }
    }
  }
  return problems;
}

std::vector<std::string> include_problems(const RoomGraph& graph, const std::string& path, std::string_view text) {
  std::vector<std::string> problems;
  const std::string room = path.substr(0, path.find('/'));
  const auto declared = graph.depends.find(room);
  std::set<std::string> accepted{room};
  if (declared != graph.depends.end()) accepted.insert(declared->second.begin(), declared->second.end());
  const bool header = path.ends_with(".h");
  int number = 0;
  for (const auto& line : split(text, '\n')) {
    ++number;
    const auto trimmed = trim(line);
    if (!trimmed.starts_with("#include")) continue;
    const auto open = trimmed.find_first_of("<\"");
    const auto close = open == std::string_view::npos ? open : trimmed.find_first_of(">\"", open + 1);
    if (close == std::string_view::npos) continue;
    const std::string name(trimmed.substr(open + 1, close - open - 1));
    const auto at = path + ":" + std::to_string(number) + ": ";
    if (trimmed[open] == '<') {
      if (header && is_third_party(name) && !allowed_in_header(name, room))
        problems.push_back(at + "a third party's header <" + name + "> in a header; it belongs in a .cpp file");
      continue;
    }
    const auto other = name.substr(0, name.find('/'));
    if (std::find(graph.rooms.begin(), graph.rooms.end(), other) == graph.rooms.end()) {
      problems.push_back(at + "\"" + name + "\" is in no room; includes are written \"room/file.h\"");
    } else if (accepted.count(other) == 0) {
      problems.push_back(at + room + " may not include " + other + "; its CMakeLists.txt does not declare that arrow");
    }
  }
  return problems;
}

std::vector<std::string> unused_arrows(const RoomGraph& graph, const std::string& room,
                                       const std::vector<std::string>& texts) {
  std::set<std::string> used;
  for (const auto& text : texts) {
    for (const auto& line : split(text, '\n')) used.insert(room_of_include(line));
  }
  std::vector<std::string> problems;
  const auto declared = graph.depends.find(room);
  if (declared == graph.depends.end()) return problems;
  for (const auto& below : declared->second) {
    if (used.count(below) == 0) problems.push_back(room + " declares " + below + ", but none of its files includes it");
  }
  return problems;
}

std::vector<std::vector<std::string>> file_circles(const std::map<std::string, std::string>& texts) {
  std::map<std::string, std::set<std::string>> includes;  // by stem
  for (const auto& [path, text] : texts) includes[stem_of(path)];
  for (const auto& [path, text] : texts) {
    for (const auto& line : split(text, '\n')) {
      const auto other = stem_of(quoted_include(line));
      if (other != stem_of(path) && includes.contains(other)) includes[stem_of(path)].insert(other);
    }
  }
  std::map<std::string, std::set<std::string>> reached;  // from each stem, by one include or more
  for (const auto& [stem, direct] : includes) {
    std::vector<std::string> open(direct.begin(), direct.end());
    while (!open.empty()) {
      const auto next = open.back();
      open.pop_back();
      if (!reached[stem].insert(next).second) continue;
      open.insert(open.end(), includes[next].begin(), includes[next].end());
    }
  }
  std::set<std::vector<std::string>> circles;
  for (const auto& [stem, others] : reached) {
    std::vector<std::string> circle;
    for (const auto& other : others) {
      if (reached[other].contains(stem)) circle.push_back(other);
    }
    if (!circle.empty()) circles.insert(circle);
  }
  return {circles.begin(), circles.end()};
}

std::vector<std::string> types_defined(std::string_view text) {
  std::vector<std::string> types;
  bool own = false;
  for (const auto& line : split(text, '\n')) {
    if (line.starts_with("namespace")) own = line == "namespace unietp {";
    if (line == "}  // namespace") own = true;  // back from the unnamed one
    if (!own || line.ends_with(";")) continue;
    for (const std::string_view keyword : {"struct ", "class ", "enum class "}) {
      if (!line.starts_with(keyword)) continue;
      auto rest = std::string_view(line).substr(keyword.size());
      if (rest.starts_with("[[")) rest.remove_prefix(std::min(rest.size(), rest.find("]]") + 3));
      const auto name = rest.substr(0, rest.find_first_of(" {:<"));
      const auto after = rest.substr(name.size());
      if (!name.empty() && !after.starts_with("::")) types.emplace_back(name);
    }
  }
  return types;
}

}  // namespace unietp
