#include "report/home_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/base64.h"
#include "core/png.h"
#include "core/text.h"
#include "grounding/reachability.h"
#include "grounding/scene_svg.h"
#include "report/asset.h"
#include "report/html.h"
#include "scene/simulator_info.h"
#include "simulation/picture.h"

namespace unietp {
namespace {

constexpr std::string_view kStyle =
    ".homes { max-width: 90rem; margin: 0 auto; padding: 1.5rem; display: grid; gap: 1.5rem; }\n"
    ".home { display: grid; gap: 1rem; grid-template-columns: minmax(0, 1fr) minmax(0, 1.3fr); align-items: start; }\n"
    ".home svg { width: 100%; height: auto; background: #fff; }\n"
    ".home h3 { grid-column: 1 / -1; }\n"
    ".views { display: grid; gap: 0.75rem; grid-template-columns: repeat(2, minmax(0, 1fr)); }\n"
    ".views figure { margin: 0; }\n"
    ".views img { width: 100%; height: auto; display: block; border-radius: 6px; }\n"
    "@media (max-width: 50rem) { .home { grid-template-columns: minmax(0, 1fr); } }\n";

double area_of(const Room& room) {
  const Bounds bounds = room_bounds(room, 1);
  return (bounds.high - bounds.low).head<2>().prod();
}

/// The rooms to show: the largest of each type, then the second largest, and so on; in the order of the home.
std::vector<std::size_t> chosen_rooms(const Scene& home, std::size_t most) {
  std::vector<std::size_t> order(home.rooms.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return area_of(home.rooms[a]) > area_of(home.rooms[b]); });
  std::map<std::string, int> seen;
  std::vector<std::pair<int, std::size_t>> ranked;
  ranked.reserve(order.size());
  for (const std::size_t i : order) ranked.emplace_back(seen[home.rooms[i].type]++, i);
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::size_t> rooms;
  for (std::size_t i = 0; i < ranked.size() && i < most; ++i) rooms.push_back(ranked[i].second);
  std::sort(rooms.begin(), rooms.end());
  return rooms;
}

/// The places in a room that the agent can walk to and that lie farthest in each of the four diagonal directions,
/// looking to the room's middle.
std::vector<Agent> ends_of(const Room& room, const Walk& walk) {
  const Bounds bounds = room_bounds(room, 1);
  const Vec2 middle = ((bounds.low + bounds.high) / 2).head<2>();
  const auto from = walk.grid.cell_at(bounds.low.head<2>()), to = walk.grid.cell_at(bounds.high.head<2>());
  constexpr std::array<std::array<double, 2>, 4> kWays{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  std::array<std::optional<Vec2>, 4> ends;
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      const Vec2 at = walk.grid.center({x, y});
      if (!walk.reached.has(x, y) || !contains(room.polygon, at)) continue;
      for (std::size_t i = 0; i < ends.size(); ++i) {
        const Vec2 way(kWays[i][0], kWays[i][1]);
        if (!ends[i] || way.dot(at - middle) > way.dot(*ends[i] - middle)) ends[i] = at;
      }
    }
  }
  std::vector<Agent> agents;
  for (const auto& end : ends) {
    if (!end || (*end - middle).norm() < 1e-6) continue;
    Agent agent;
    agent.position = *end;
    agent.yaw = std::atan2(middle.y() - end->y(), middle.x() - end->x());
    agent.pitch = 0.35;
    agents.push_back(agent);
  }
  return agents;
}

std::string home_html(const ShownHome& home) {
  std::string html = "<article class=\"card home\"><h3>" + escaped_html(home.id) + " <span class=\"soft small\">" +
                     std::to_string(home.rooms) + " rooms, " + std::to_string(home.objects) +
                     " objects</span></h3><div>" + home.svg + "</div><div class=\"views\">";
  for (const RoomView& view : home.views)
    html += "<figure><img alt=\"" + escaped_html(view.room + " of " + home.id) + "\" src=\"data:image/png;base64," +
            base64(view.png) + "\"><figcaption class=\"small\">" + escaped_html(view.room) + "</figcaption></figure>";
  return html + "</div></article>\n";
}

}  // namespace

Result<ShownHome> shown_home(const Scene& home, const Profile& profile, std::size_t views, int width) {
  ShownHome shown{home.id, home.simulator, home.rooms.size(), home.nodes.size(), replace_all(scene_svg(home), "\n", ""),
                  {}};
  Profile camera = profile;
  camera.image_width = width;
  camera.image_height = width * 3 / 4;
  camera.vertical_fov_deg = 65;
  const Walk walk = walk_in(home, profile);
  Viewer viewer(home);
  Rays rays;
  for (const std::size_t number : chosen_rooms(home, views)) {
    const Room& room = home.rooms[number];
    std::optional<Agent> best;
    std::size_t most = 0;
    for (const Agent& agent : ends_of(room, walk)) {
      const std::size_t seen = viewer.view(viewed(home), agent, camera, kEndless_m).size();
      if (!best || seen > most) best = agent, most = seen;
    }
    if (!best) continue;
    Scene from_there = home;
    from_there.agent = *best;
    const Picture picture = picture_of(from_there, camera, rays);
    auto png = few_colors_png(picture.width, picture.height, picture.rgb);
    if (!png) return png.error();
    shown.views.push_back({room.id, std::move(*png)});
  }
  return shown;
}

std::string home_page(const std::vector<ShownHome>& homes) {
  HtmlPage page;
  page.title = "Homes";
  page.styles = {asset("page.css"), kStyle};
  page.body = "<main class=\"homes\"><h1>" + std::to_string(homes.size()) + " homes</h1>\n";
  for (const Simulator simulator : kSimulators) {
    std::string cards;
    for (const ShownHome& home : homes) {
      if (home.simulator == simulator) cards += home_html(home);
    }
    if (!cards.empty()) page.body += "<h2>" + std::string(info(simulator).title) + "</h2>\n" + cards;
  }
  page.body += "</main>\n";
  return to_html(std::move(page));
}

}  // namespace unietp
