#include "grounding/layout_library.h"

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/digest.h"
#include "grounding/floor_plan.h"
#include "grounding/furniture_position.h"
#include "grounding/reachability.h"
#include "homes.h"
#include "scene/scene_json.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

std::vector<BenchmarkLayout> committed() {
  const auto layouts = benchmark_layouts(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/layouts");
  EXPECT_TRUE(layouts) << format(layouts.error());
  return layouts ? *layouts : std::vector<BenchmarkLayout>{};
}

/// Of all of a scene but its name.
std::string digest_of(Scene scene) {
  scene.id = "home";
  return sha256(scene_to_json(scene));
}

TEST(BenchmarkLayouts, Are170OfSevenRoomsAndTwoHundredAndTenObjectsOnAverage) {
  const auto layouts = committed();
  ASSERT_EQ(layouts.size(), 170u);
  std::map<Simulator, int> counts;
  double rooms = 0, objects = 0;
  for (const BenchmarkLayout& layout : layouts) {
    ++counts[layout.simulator];
    rooms += layout.rooms;
    objects += layout.objects;
  }
  EXPECT_EQ(counts[Simulator::Ai2thor], 50);
  EXPECT_EQ(counts[Simulator::Virtualhome], 50);
  EXPECT_EQ(counts[Simulator::Habitat], 20);
  EXPECT_EQ(counts[Simulator::Behavior], 50);
  EXPECT_NEAR(rooms / 170, 7, 0.01);
  EXPECT_NEAR(objects / 170, 210, 0.1);
}

/// The homes of the benchmark for one simulator, made once for all tests.
class EveryLibrary : public ::testing::TestWithParam<Simulator> {
 protected:
  static const Surroundings& style() {
    static const auto kStyles = [] {
      std::vector<Surroundings> styles;
      for (const Simulator simulator : kSimulators) styles.push_back(style_of(simulator).value());
      return styles;
    }();
    return kStyles[static_cast<std::size_t>(GetParam())];
  }
  static const std::vector<Scene>& homes() {
    static std::map<Simulator, std::vector<Scene>> made;
    auto& homes = made[GetParam()];
    if (!homes.empty()) return homes;
    for (const BenchmarkLayout& layout : committed()) {
      if (layout.simulator != GetParam()) continue;
      auto home = benchmark_layout(layout, style().recipe, style().knowledge, style().profile);
      EXPECT_TRUE(home) << layout.id << ": " << format(home.error());
      if (home) homes.push_back(std::move(*home));
    }
    return homes;
  }
};

TEST_P(EveryLibrary, GeneratesEveryBenchmarkLayoutAsItsRowSaysAndTrainingLayoutsThatAreNoneOfThem) {
  std::set<std::string> digests;
  double rooms = 0, objects = 0;
  std::size_t next = 0;
  for (const BenchmarkLayout& layout : committed()) {
    if (layout.simulator != GetParam()) continue;
    ASSERT_LT(next, homes().size());
    const Scene& home = homes()[next++];
    EXPECT_EQ(home.id, layout.id);
    EXPECT_EQ(static_cast<int>(home.rooms.size()), layout.rooms);
    EXPECT_NEAR(static_cast<double>(home.nodes.size()), layout.objects, 0.04 * layout.objects) << layout.id;
    rooms += static_cast<double>(home.rooms.size());
    objects += static_cast<double>(home.nodes.size());
    EXPECT_TRUE(digests.insert(digest_of(home)).second) << layout.id;
  }
  const auto count = static_cast<double>(digests.size());
  const HomeScale scale = style().recipe.scale;
  const double mean_rooms = (scale.fewest_rooms + scale.most_rooms) / 2.0;
  EXPECT_NEAR(rooms / count, mean_rooms, 0.01);
  EXPECT_NEAR(objects / count, mean_rooms * scale.objects_a_room, 5);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {  // seeds that benchmark layouts have too
    for (std::uint64_t n = 0; n < 3; ++n) {
      const auto home = training_layout(style().recipe, style().knowledge, style().profile, n, seed);
      ASSERT_TRUE(home) << n << ": " << format(home.error());
      EXPECT_TRUE(digests.insert(digest_of(*home)).second) << home->id;
    }
  }
}

/// A home's rooms and openings as a graph.
struct Doors {
  std::vector<std::string> types;
  std::vector<std::vector<std::size_t>> beyond;  // by room

  explicit Doors(const Scene& home) : beyond(home.rooms.size()) {
    const auto number = [&](const std::string& id) {
      return static_cast<std::size_t>(
          std::find_if(home.rooms.begin(), home.rooms.end(), [&](const Room& room) { return room.id == id; }) -
          home.rooms.begin());
    };
    for (const Room& room : home.rooms) types.push_back(room.type);
    for (const Opening& opening : home.openings) {
      beyond.at(number(opening.room_a)).push_back(number(opening.room_b));
      beyond.at(number(opening.room_b)).push_back(number(opening.room_a));
    }
  }
  int count(std::string_view type) const { return static_cast<int>(std::count(types.begin(), types.end(), type)); }
  bool leads_to(std::size_t room, const std::set<std::string>& wanted) const {
    return std::any_of(beyond[room].begin(), beyond[room].end(),
                       [&](std::size_t i) { return wanted.contains(types[i]); });
  }
  /// Rooms that one comes to from the first without going through `closed`.
  std::set<std::size_t> reached_without(std::size_t closed) const {
    std::set<std::size_t> reached{0};
    std::vector<std::size_t> next{0};
    while (!next.empty()) {
      const std::size_t room = next.back();
      next.pop_back();
      for (const std::size_t other : beyond[room]) {
        if (other != closed && reached.insert(other).second) next.push_back(other);
      }
    }
    return reached;
  }
};

TEST_P(EveryLibrary, HasDoorsWherePeopleBuildThem) {
  for (const Scene& home : homes()) {
    SCOPED_TRACE(home.id);
    const Doors doors(home);
    EXPECT_EQ(doors.count("corridor"), home.rooms.size() > 4 ? 1 : 0);
    const int bedrooms = doors.count("bedroom"), bathrooms = doors.count("bathroom");
    EXPECT_GE(bathrooms, 1);
    EXPECT_LE(bathrooms, 3);
    EXPECT_LE(bathrooms, bedrooms);
    EXPECT_GE(3 * bathrooms, bedrooms);
    bool bathroom_for_all = false;
    for (std::size_t room = 0; room < doors.types.size(); ++room) {
      const std::string& type = doors.types[room];
      std::set<std::size_t> cut_off;  // rooms that one comes to only through this one
      const auto reached = doors.reached_without(room);
      for (std::size_t other = 0; other < doors.types.size() && room > 0; ++other) {
        if (other != room && !reached.contains(other)) cut_off.insert(other);
      }
      for (const std::size_t other : doors.beyond[room]) {
        const std::string& to = doors.types[other];
        if (type == "bathroom") {
          EXPECT_TRUE(to == "corridor" || to == "bedroom") << "a bathroom opens into a " << to;
        }
        if (type == "bedroom") {
          EXPECT_TRUE(to == "corridor" || to == "living_room" || to == "bathroom") << "a bedroom opens into a " << to;
        }
      }
      if (type == "bathroom") {
        EXPECT_EQ(doors.beyond[room].size(), 1u);
        bathroom_for_all = bathroom_for_all || doors.leads_to(room, {"corridor"});
      }
      if (type == "bedroom") {
        EXPECT_LE(cut_off.size(), 1u);
        for (const std::size_t other : cut_off) EXPECT_EQ(doors.types[other], "bathroom") << "through a bedroom";
      }
      if (type == "office" || type == "bathroom") {
        EXPECT_TRUE(cut_off.empty()) << "a passage through a " << type;
      }
      if (type == "kitchen") {
        EXPECT_TRUE(doors.leads_to(room, {"dining_room", "living_room"})) << "a kitchen apart";
        EXPECT_TRUE(cut_off.empty()) << "a passage through the kitchen";
      }
    }
    EXPECT_TRUE(bathroom_for_all || home.rooms.size() == 4) << "every bathroom belongs to a bedroom";
  }
}

TEST_P(EveryLibrary, IsEnteredThroughTheCorridorOrElseTheLivingRoom) {
  for (const Scene& home : homes()) {
    EXPECT_EQ(home.rooms.front().type, home.rooms.size() > 4 ? "corridor" : "living_room") << home.id;
    const auto entrance = entrance_of(home.rooms);
    ASSERT_TRUE(entrance) << home.id;
    EXPECT_EQ(room_at(home, entrance->at - 0.3 * entrance->inward), nullptr) << "the front door leads out of the home";
    EXPECT_EQ(room_at(home, entrance->at + 0.3 * entrance->inward), &home.rooms.front());
    EXPECT_LT((home.agent.position - entrance->at).norm(), 1.0) << "the agent starts at the entrance of " << home.id;
    for (const Node& node : home.nodes) {
      const Bounds box = bounds_of(node.pose, node.size);
      const Vec2 door = entrance->at + 0.2 * entrance->inward;
      const bool before = door.x() > box.low.x() && door.x() < box.high.x() && door.y() > box.low.y() &&
                          door.y() < box.high.y() && box.low.z() < 2;
      EXPECT_FALSE(before) << node.id << " stands before the front door of " << home.id;
    }
  }
}

/// Whether one of a room's things is of one of the categories.
bool has_one_of(const Scene& home, const Room& room, const std::set<std::string>& categories) {
  return std::any_of(home.nodes.begin(), home.nodes.end(), [&](const Node& node) {
    return categories.contains(node.category) && room_at(home, node.pose.position.head<2>()) == &room;
  });
}

TEST_P(EveryLibrary, HasInKitchensAndBathroomsWhatTheyAreFor) {
  const std::set<std::string> toilets{"Toilet", "toilet"}, fridges{"Fridge", "fridge"};
  const std::set<std::string> stoves{"StoveBurner", "stove"};
  const std::set<std::string> basins{"Sink", "sink", "furniture_sink", "pedestal_sink", "drop_in_sink"};
  for (const Scene& home : homes()) {
    for (const Room& room : home.rooms) {
      if (room.type == "bathroom") {
        EXPECT_TRUE(has_one_of(home, room, toilets)) << home.id << " " << room.id;
      }
      if (room.type == "bathroom" || room.type == "kitchen") {
        EXPECT_TRUE(has_one_of(home, room, basins)) << home.id << " " << room.id;
      }
      if (room.type != "kitchen") continue;
      EXPECT_TRUE(has_one_of(home, room, fridges)) << home.id;
      EXPECT_TRUE(has_one_of(home, room, stoves)) << home.id;
    }
  }
}

TEST_P(EveryLibrary, LetsTheAgentReachEveryRoomAndPieceFromTheEntrance) {
  for (const Scene& home : homes()) {
    const Walk walk = walk_in(home, style().profile);
    EXPECT_EQ(unreached_room(home, walk), std::nullopt) << home.id;
    EXPECT_THAT(unreached_furniture(home, physics_of(home), style().profile, walk), ::testing::IsEmpty()) << home.id;
  }
}

/// Seats of a category that stand at a piece and face it.
int seats_at(const Scene& home, const Node& piece, const std::string& category) {
  constexpr double kNear_m = 0.2;
  const Bounds box = bounds_of(piece.pose, piece.size);
  return static_cast<int>(std::count_if(home.nodes.begin(), home.nodes.end(), [&](const Node& seat) {
    if (seat.category != category || !overlap(bounds_of(seat.pose, seat.size), box, kNear_m)) return false;
    const Vec3 before = seat.pose * Vec3(0, -seat.size.y() / 2 - kNear_m, 0);
    return before.x() > box.low.x() && before.x() < box.high.x() && before.y() > box.low.y() &&
           before.y() < box.high.y();
  }));
}

TEST_P(EveryLibrary, HasSeatsAtDesksAndTablesThatFaceThem) {
  int desks = 0, without_seat = 0, tables = 0, with_few_seats = 0;
  for (const FurnitureRule& rule : style().recipe.furniture) {
    const auto where = parse_furniture_position(rule.where);
    if (where->kind != FurniturePosition::Kind::At) continue;
    for (const Scene& home : homes()) {
      for (const Node& piece : home.nodes) {
        const Room* room = piece.category == where->host ? room_at(home, piece.pose.position.head<2>()) : nullptr;
        if (room == nullptr || room->type != rule.room) continue;
        const int seats = seats_at(home, piece, rule.category);
        if (rule.at_most == 1) {
          ++desks;
          without_seat += seats == 0 ? 1 : 0;
        } else {
          ++tables;
          with_few_seats += seats < 2 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GE(desks, 5);
  EXPECT_GE(tables, 5);
  EXPECT_LE(without_seat, 0.05 * desks) << "of " << desks << " desks";
  EXPECT_LE(with_few_seats, 0.05 * tables) << "of " << tables << " tables";
}

TEST_P(EveryLibrary, HasSofasThatLookAtTheTelevision) {
  const std::set<std::string> sofas{"Sofa", "sofa", "couch"};
  const std::set<std::string> televisions{"Television", "tv", "television", "wall_mounted_tv"};
  int rooms = 0, watched = 0;
  for (const Scene& home : homes()) {
    for (const Room& room : home.rooms) {
      if (room.type != "living_room" || !has_one_of(home, room, sofas) || !has_one_of(home, room, televisions))
        continue;
      ++rooms;
      bool seen = false;
      for (const Node& sofa : home.nodes) {
        if (!sofas.contains(sofa.category)) continue;
        for (const Node& screen : home.nodes) {
          if (!televisions.contains(screen.category)) continue;
          const Vec3 at = inverse(sofa.pose) * screen.pose.position;
          const double facing = (sofa.pose.rotation * Vec3::UnitY()).dot(screen.pose.rotation * Vec3::UnitY());
          const bool same_room = room_at(home, screen.pose.position.head<2>()) == &room &&
                                 room_at(home, sofa.pose.position.head<2>()) == &room;
          seen = seen || (same_room && facing < -0.99 && at.y() < 0 && std::abs(at.x()) < 1);
        }
      }
      watched += seen ? 1 : 0;
    }
  }
  EXPECT_GE(rooms, 20);
  EXPECT_GE(watched, 0.95 * rooms) << "of " << rooms << " living rooms with a television";
}

/// How many pieces of these categories stand or hang within `gap_m` of one of the others, and how many there are.
struct Company {
  int all = 0, beside = 0;
};
Company company_of(const std::vector<Scene>& homes, const std::set<std::string>& pieces,
                   const std::set<std::string>& others, double gap_m, const std::string& room_type = "") {
  Company count;
  for (const Scene& home : homes) {
    for (const Node& piece : home.nodes) {
      if (!pieces.contains(piece.category)) continue;
      const Room* room = room_at(home, piece.pose.position.head<2>());
      if (room == nullptr || (!room_type.empty() && room->type != room_type)) continue;
      Bounds area = bounds_of(piece.pose, piece.size);
      area.low.z() = 0;  // what hangs beside a basin is above its top
      area.high.z() = home.wall_height;
      ++count.all;
      count.beside += std::any_of(home.nodes.begin(), home.nodes.end(), [&](const Node& other) {
        return others.contains(other.category) && overlap(bounds_of(other.pose, other.size), area, gap_m);
      });
    }
  }
  return count;
}

TEST_P(EveryLibrary, HasWashingMachinesAndTowelRailsBesideABasin) {
  constexpr double kBeside_m = 0.15;
  const std::set<std::string> machines{"washingmachine", "washer_dryer", "washer"};
  const std::set<std::string> rails{"HandTowelHolder", "TowelHolder", "towelrack", "towel_rack", "towel_ring"};
  const std::set<std::string> basins{"Sink", "sink", "furniture_sink", "pedestal_sink", "drop_in_sink"};
  const Company washing = company_of(homes(), machines, basins, kBeside_m, "bathroom");
  const Company towels = company_of(homes(), rails, basins, kBeside_m, "bathroom");
  EXPECT_EQ(washing.beside, washing.all);
  EXPECT_GE(washing.all, GetParam() == Simulator::Ai2thor ? 0 : 10);
  EXPECT_EQ(towels.beside, towels.all);
  EXPECT_GE(towels.all, 20);
}

/// The most things of one category among those on or in a node.
int most_alike(const Scene& home, const std::string& host, const Household& household) {
  std::map<std::string, int> alike;
  int most = 0;
  for (const Edge& edge : home.edges) {
    if (edge.to != host || (edge.relation != Predicate::On && edge.relation != Predicate::Inside)) continue;
    const Node* thing = find_node(home, edge.from);
    if (household.is_a(thing->category, "plate") || household.is_a(thing->category, "book"))
      most = std::max(most, ++alike[thing->category]);
  }
  return most;
}

TEST_P(EveryLibrary, HasPlatesAndBooksInRowsWhereTheyArePutAwayAndFlatwareInKitchenDrawers) {
  const Household& household = *style().recipe.household;
  int rows = 0, kitchen_drawers = 0, with_cutlery = 0;
  for (const Scene& home : homes()) {
    for (const Node& node : home.nodes) {
      if (node.movable || !household.puts_away(node.category)) continue;
      rows += most_alike(home, node.id, household) >= 3 ? 1 : 0;
      const Room* room = room_at(home, node.pose.position.head<2>());
      if (household.kind_of(node.category) != "drawer" || room == nullptr || room->type != "kitchen") continue;
      ++kitchen_drawers;
      with_cutlery += std::any_of(home.edges.begin(), home.edges.end(), [&](const Edge& edge) {
        return edge.relation == Predicate::Inside && edge.to == node.id &&
               household.kind_of(find_node(home, edge.from)->category) == "cutlery";
      });
    }
  }
  EXPECT_GE(rows, static_cast<int>(homes().size() / 8));
  if (GetParam() != Simulator::Ai2thor && GetParam() != Simulator::Habitat) return;  // the others have no such drawers
  EXPECT_GE(kitchen_drawers, static_cast<int>(homes().size()));
  EXPECT_GE(with_cutlery, 0.4 * kitchen_drawers) << "of " << kitchen_drawers << " drawers";
}

TEST_P(EveryLibrary, HasComputersOnDesksAndTablesBesideBeds) {
  const std::set<std::string> desks{"Desk", "desk"}, beds{"Bed", "bed"};
  const std::set<std::string> computers{"Desktop", "Laptop",  "computer",        "cpuscreen",
                                        "laptop",  "monitor", "desktop_computer"};
  const std::set<std::string> bedside{"SideTable", "nightstand", "bedside_table", "night_stand"};
  const Company worked_at = company_of(homes(), desks, computers, 0),
                slept_in = company_of(homes(), beds, bedside, 0.15);
  EXPECT_GE(worked_at.all, 20);
  EXPECT_GE(worked_at.beside, 0.75 * worked_at.all) << "of " << worked_at.all << " desks";
  EXPECT_GE(slept_in.all, 30);
  EXPECT_GE(slept_in.beside, 0.9 * slept_in.all) << "of " << slept_in.all << " beds";
}

TEST_P(EveryLibrary, HasRugsBeforeSofasThatTheCoffeeTableStandsOn) {
  if (GetParam() == Simulator::Ai2thor) GTEST_SKIP() << "AI2-THOR's objects have no rug";
  const std::set<std::string> sofas{"sofa", "couch"}, rugs{"rug", "carpet"}, tables{"coffeetable", "coffee_table"};
  const Company sat_on = company_of(homes(), sofas, rugs, 0.2, "living_room");
  EXPECT_GE(sat_on.beside, 0.5 * sat_on.all) << "of " << sat_on.all << " sofas";
  int on_rugs = 0;
  for (const Scene& home : homes()) {
    for (const Node& table : home.nodes) {
      if (!tables.contains(table.category)) continue;
      const double bottom = table.pose.position.z() - table.size.z() / 2;
      const bool above = std::any_of(home.nodes.begin(), home.nodes.end(), [&](const Node& rug) {
        return rugs.contains(rug.category) &&
               overlap(bounds_of(rug.pose, rug.size), bounds_of(table.pose, table.size), 0.01);
      });
      EXPECT_TRUE(above || bottom < 0.005) << home.id << ": " << table.id << " floats";
      on_rugs += above ? 1 : 0;
    }
  }
  EXPECT_GE(on_rugs, 10);
}

TEST_P(EveryLibrary, HasThingsOnTheFloorThatPeopleKeepThere) {
  int movables = 0, low = 0;
  for (const Scene& home : homes()) {
    const Walk walk = walk_in(home, style().profile);
    movables +=
        static_cast<int>(std::count_if(home.nodes.begin(), home.nodes.end(), [](const Node& n) { return n.movable; }));
    for (const Edge& edge : home.edges) {
      if (edge.relation != Predicate::OnFloor) continue;
      const Node* thing = find_node(home, edge.from);
      // What lies in a basket can touch the floor through its thin bottom.
      const bool in_something = std::any_of(home.edges.begin(), home.edges.end(), [&](const Edge& other) {
        return other.relation == Predicate::Inside && other.from == edge.from;
      });
      if (!thing->movable || in_something) continue;
      ++low;
      EXPECT_GT(style().recipe.household->on_floor(thing->category), 0) << thing->id << " on a floor of " << home.id;
      const Vec2 at = thing->pose.position.head<2>();
      bool near = false;
      for (int y = 0; y < walk.grid.height() && !near; ++y) {
        for (int x = 0; x < walk.grid.width() && !near; ++x)
          near = walk.reached.has(x, y) && (walk.grid.center({x, y}) - at).norm() < style().profile.reach_m;
      }
      EXPECT_TRUE(near) << thing->id << " in " << home.id;
    }
  }
  EXPECT_NEAR(low, style().recipe.floor_share * movables, 0.3 * style().recipe.floor_share * movables + 2);
}

INSTANTIATE_TEST_SUITE_P(Simulators, EveryLibrary, ::testing::ValuesIn(kSimulators),
                         [](const auto& one) { return std::string(name_of(one.param)); });

TEST(ReadBenchmark, ReportsEveryErrorWithLineAndColumn) {
  const auto table = read_benchmark("b.csv",
                                    "id,simulator,seed,rooms,objects\n"
                                    "a,ai2thor,1,7,210\n"
                                    "a,ai2thor,2,7,210\n"
                                    "b,ai2thor,1,7,210\n"
                                    "c,thor,1,7,210\n"
                                    "d,habitat,-1,7,210\n"
                                    "e,habitat,1,99,210\n"
                                    "f,habitat,2,7,many\n");
  EXPECT_EQ(table.layouts.size(), 1u);
  std::vector<std::string> messages;
  for (const Error& error : table.errors) messages.push_back(format(error));
  const std::vector<std::string> expected{
      "b.csv:3:1: schema error: 'a' is duplicated; expected a new id",
      "b.csv:4:11: schema error: is duplicated for ai2thor; expected a different seed for each layout",
      "b.csv:5:3: schema error: unknown simulator 'thor'; expected one of ai2thor, virtualhome, habitat, behavior",
      "b.csv:6:11: schema error: expected a whole number from 0 to 18446744073709551615, got '-1'",
      "b.csv:7:13: schema error: expected a whole number from 4 to 12, got '99'",
      "b.csv:8:15: schema error: expected a whole number from 50 to 600, got 'many'"};
  EXPECT_EQ(messages, expected);
}

}  // namespace
}  // namespace unietp
