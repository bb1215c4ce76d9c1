#include "grounding/small_objects.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "grounding/make_node.h"
#include "grounding/place_object.h"

namespace unietp {
namespace {

constexpr double kObjectSizeSpread = 0.04;
constexpr double kUsualRoomFactor = 4;  // where no household says how rooms suit
constexpr double kOnMovable = 0.1;      // of the weight of a place that is itself carried about, such as a bowl
constexpr double kHeldByOthers = 0.5;   // things that a receptacle holds of which no home shows how many
constexpr double kLeastSuits = 1e-6;
constexpr double kWithLike = 3;  // of the weight of a place that has one of the category already: cups stand together
constexpr int kReceptaclesPerTry = 3;
constexpr double kSecond = 0.5;     // chance of a second thing where there is one already, to that of another category
constexpr double kMostOften = 1.5;  // times the number of a thing in real homes, when more things are asked for
constexpr double kRow = 0.6;        // chance that what is put away begins a row: plates in a cabinet, books on a shelf
constexpr int kFewestInRow = 3, kMostInRow = 4;

/// Of a category's things, one bool a room.
std::vector<bool> usual_rooms(const Workspace& workspace, const Category& category) {
  return workspace.rooms_with([&](const std::string& type) {
    return std::find(category.rooms.begin(), category.rooms.end(), type) != category.rooms.end();
  });
}

/// Whether food on or in the thing is eaten from it, so that it has to be clean.
bool is_eaten_from(const Household& household, std::string_view dish, std::string_view food) {
  const auto states = household.states_in_use(dish, std::string("carry:").append(household.kind_of(food)));
  return std::find(states.begin(), states.end(), Predicate::Clean) != states.end();
}

/// Whether people have such a thing on or in the dish: food is not on dirty dishes, nor on those that are put away or
/// to be washed. `around`: the category of what the dish is in, "" for none.
bool serves(const Household& household, const Node& dish, std::string_view around, std::string_view food) {
  if (!dish.movable || !is_eaten_from(household, dish.category, food)) return true;
  return !dish.states.has(Predicate::Dirty) && !household.puts_away(around) && !household.washes(around);
}

/// The category of what a thing of a workspace that began as a home is in, as last read; "" for none.
std::string_view around(const Workspace& workspace, const Node& node) {
  if (workspace.home() == nullptr) return "";
  const auto& present = workspace.current_state();
  const auto entity = present.reader().find(node.id);
  if (!entity) return "";
  const auto& trace = present.now();
  for (const auto& [relation, other] : trace.states.front().relations(*entity)) {
    const auto host = workspace.places().find(trace.entities[other].id);
    if (relation == Predicate::Inside && host) return workspace.scene().nodes[*host].category;
  }
  return "";
}

/// A thing that some room shall have.
struct PlacementRequest {
  std::optional<std::size_t> room;  // nullopt: any
  const Category* category;
  bool of_rule = false;  // real homes have it there
};

/// What each category can be put on or in, room by room, kept up while things are added.
class Scatterer {
 public:
  Scatterer(Workspace& workspace, const LayoutRecipe& recipe, const ScatterOptions& options)
      : workspace_(workspace), recipe_(recipe), options_(options), rooms_(workspace.scene().rooms.size()) {
    for (std::size_t i = 0; i < workspace.scene().nodes.size(); ++i) enter(i);
    for (const Effect& effect : workspace.knowledge().effects()) {
      if (effect.treatment == Treatment::Slices && effect.gives != effect.target) sliced_.insert(effect.gives);
    }
  }

  std::vector<PlacementRequest> draw_requests(Rng& rng) const {
    const double seen = options_.wanted * (1 - recipe_.unseen_share);
    std::vector<std::pair<PlacementRequest, double>> expected;
    double total = 0;
    for_each_rule([&](const PlacementRequest& request, double mean) {
      expected.emplace_back(request, mean);
      total += mean;
    });
    std::vector<PlacementRequest> requests;
    for (const auto& [request, mean] : expected) {
      const double number = mean * std::min(seen / total, kMostOften);
      const int count = static_cast<int>(number) + (rng.chance(number - std::floor(number)) ? 1 : 0);
      requests.insert(requests.end(), static_cast<std::size_t>(count), request);
    }
    const auto unseen = unseen_categories();
    const double rest = options_.wanted * recipe_.unseen_share;
    const int others = static_cast<int>(rest) + (rng.chance(rest - std::floor(rest)) ? 1 : 0);
    for (int i = 0; i < others && !unseen.empty(); ++i) requests.push_back({std::nullopt, rng.pick(unseen), false});
    rng.shuffle(requests);
    return requests;
  }

  /// One more thing: in a room drawn by how much its rules name, of a category that is usual there, the rarer the more
  /// of it there are; nullopt when there is none.
  std::optional<PlacementRequest> draw_request(Rng& rng) const {
    std::vector<double> rooms(rooms_.size(), 0);
    for_each_rule([&](const PlacementRequest& request, double mean) { rooms[*request.room] += mean; });
    if (std::none_of(rooms.begin(), rooms.end(), [](double mean) { return mean > 0; })) return std::nullopt;
    const std::size_t room = rng.weighted(rooms);
    const std::string& type = workspace_.scene().rooms[room].type;
    std::vector<const Category*> usual;
    std::vector<double> chances;
    std::map<std::string_view, int> alike;  // categories of a kind
    for (const Category& category : workspace_.knowledge().categories()) {
      if (!category.movable || sliced_.contains(category.name)) continue;
      if (std::find(category.rooms.begin(), category.rooms.end(), type) == category.rooms.end()) continue;
      if (workspace_.household() != nullptr && workspace_.household()->places_of(category.name).empty()) continue;
      if (!suits(room, category)) continue;
      usual.push_back(&category);
      ++alike[kind_of(category)];
    }
    for (const Category* category : usual) {
      const auto there = rooms_[room].find(category->name);
      const std::size_t number = there == rooms_[room].end() ? 0 : there->second.size();
      // People have several of many things; of hundreds of kinds of food no home has most.
      const double again = number == 0 ? 1 : number == 1 ? kSecond : std::pow(0.5, static_cast<double>(number));
      chances.push_back(again * in_room(room, *category));
    }
    if (usual.empty()) return std::nullopt;
    return PlacementRequest{room, usual[rng.weighted(chances)], false};
  }

  /// On or in what, nullopt when it found no place.
  std::optional<Host> place(const PlacementRequest& request, Rng rng) {
    const Node plain = make_node(workspace_, *request.category, kObjectSizeSpread, rng);
    std::vector<Host> hosts = hosts_in(request);
    std::erase_if(hosts, [&](const Host& host) { return holds_what_clashes(host, request.category->name); });
    for (int choice = 0; choice < kReceptaclesPerTry && !hosts.empty(); ++choice) {
      std::vector<double> chances;
      for (const Host& host : hosts) chances.push_back(host.weight);
      const std::size_t at = rng.weighted(chances);
      const Host host = hosts[at];
      hosts.erase(hosts.begin() + static_cast<std::ptrdiff_t>(at));
      if (put(plain, *request.category, host, rng, static_cast<std::uint64_t>(choice))) return host;
    }
    return std::nullopt;
  }

  /// How many more of the category belong beside the one that was just put there: people keep plates and books in
  /// rows where they put them away.
  int draw_row(const Host& host, const Category& category, Rng& rng) const {
    const auto* household = workspace_.household();
    if (household == nullptr || !household->puts_away(workspace_.scene().nodes[host.node].category)) return 0;
    const bool in_rows = household->is_a(category.name, "plate") || household->is_a(category.name, "book");
    const auto& there = carried_.at(host.node);
    if (!in_rows || !household->has_several(category.name)) return 0;
    if (std::count(there.begin(), there.end(), category.name) > 1 || !rng.chance(kRow)) return 0;
    return kFewestInRow - 1 + static_cast<int>(rng.below(kMostInRow - kFewestInRow + 1));
  }
  /// One more in that row.
  bool continue_row(const Host& host, const Category& category, Rng rng) {
    const Node plain = make_node(workspace_, category, kObjectSizeSpread, rng);
    return put(plain, category, host, rng, 0);
  }

 private:
  bool put(const Node& plain, const Category& category, const Host& host, Rng& rng, std::uint64_t choice) {
    PlacementOptions options;
    options.draws = std::max(1, options_.draws_per_object / kReceptaclesPerTry);
    options.settle = options_.settle;
    Node node = plain;
    draw_states(node, workspace_, {host.relation, workspace_.scene().nodes[host.node].category}, rng);
    const FoundPlace place = find_place(workspace_, node, workspace_.scene().nodes.size(), host.relation, host.node,
                                        options, rng.fork("place", choice));
    if (!place.pose) return false;
    node.pose = *place.pose;
    carried_[host.node].push_back(category.name);
    const std::size_t added = workspace_.add(std::move(node));
    if (host.relation == Predicate::Inside) {
      inside_[added] = workspace_.scene().nodes[host.node].category;
      contents_[host.node].push_back(category.name);
    }
    enter(added);
    return true;
  }

  template <class Each>
  void for_each_rule(const Each& each) const {
    for (std::size_t room = 0; room < rooms_.size(); ++room) {
      for (const ObjectRule& rule : recipe_.objects) {
        if (rule.room != workspace_.scene().rooms[room].type) continue;
        const Category* category = workspace_.knowledge().find(rule.category);
        if (category == nullptr || !suits(room, *category)) continue;
        each(PlacementRequest{room, category, true}, rule.mean * std::sqrt(in_room(room, *category)));
      }
    }
  }

  double in_room(std::size_t room, const Category& category) const {
    const auto* household = workspace_.household();
    return household == nullptr ? 1 : household->in_room(category.name, workspace_.scene().rooms[room].type);
  }
  /// Whether people keep such things in the room at times. What simulators' homes have elsewhere is left out.
  bool suits(std::size_t room, const Category& category) const { return in_room(room, category) >= Household::kNoRoom; }

  /// Movable categories of which no rule speaks and that slicing does not make.
  std::vector<const Category*> unseen_categories() const {
    const Knowledge& knowledge = workspace_.knowledge();
    std::set<std::string_view> spoken = sliced_;
    for (const ObjectRule& rule : recipe_.objects) spoken.insert(rule.category);
    std::vector<const Category*> unseen;
    for (const Category& category : knowledge.categories()) {
      const auto* household = workspace_.household();
      const bool kept = household == nullptr || !household->places_of(category.name).empty();
      if (category.movable && kept && !spoken.contains(category.name)) unseen.push_back(&category);
    }
    return unseen;
  }

  static std::string_view kind_of(const Category& category) {
    return category.kinds.empty() ? std::string_view() : std::string_view(category.kinds.front());
  }

  void enter(std::size_t index) {
    const Scene& scene = workspace_.scene();
    const Node& node = scene.nodes[index];
    const Room* room = room_at(scene, node.pose.position.head<2>());
    if (room == nullptr) return;
    rooms_[static_cast<std::size_t>(room - scene.rooms.data())][node.category].push_back(index);
  }

  std::vector<Host> hosts_in(const PlacementRequest& request) const {
    std::vector<Host> hosts;
    for (std::size_t room = 0; room < rooms_.size(); ++room) {
      if ((request.room && *request.room != room) || !suits(room, *request.category)) continue;
      if (workspace_.household() != nullptr) {
        add_usual_hosts(room, request, hosts);
        continue;
      }
      for (const Predicate relation : {Predicate::On, Predicate::Inside}) {
        for (const Placement* placement : workspace_.knowledge().placements_of(request.category->name, relation))
          add_hosts(room, request.category->name, placement->receptacle, relation, placement->likelihood, hosts);
      }
    }
    return hosts;
  }

  /// Whether the host has something on or in it that is kept apart from the category: no bleach among the bread, no
  /// soap in one cabinet with it.
  bool holds_what_clashes(const Host& host, std::string_view category) const {
    const auto* household = workspace_.household();
    if (household == nullptr) return false;
    const auto has = [&](const std::map<std::size_t, std::vector<std::string_view>>& things, const auto& clash) {
      const auto found = things.find(host.node);
      return found != things.end() && std::any_of(found->second.begin(), found->second.end(), clash);
    };
    const std::string& receptacle = workspace_.scene().nodes[host.node].category;
    return has(carried_, [&](std::string_view other) { return household->clash(category, other); }) ||
           has(contents_, [&](std::string_view other) {
             return household->stored_apart(category, other, host.relation, receptacle);
           });
  }

  /// Where the room has one of the usual places of a category, only these; where it has none of what has such places
  /// elsewhere, nothing, unless real homes have it there.
  void add_usual_hosts(std::size_t room, const PlacementRequest& request, std::vector<Host>& hosts) const {
    const auto& places = workspace_.household()->places_of(request.category->name);
    const auto is_usual = [](const Household::Place& place) { return place.usual; };
    const bool some = std::any_of(places.begin(), places.end(), is_usual);
    const bool here = std::any_of(places.begin(), places.end(), [&](const Household::Place& place) {
      return is_usual(place) && rooms_[room].contains(place.receptacle);
    });
    if (some && !here && !request.of_rule) return;
    const double suits_it = request.room ? 1 : in_room(room, *request.category);
    const auto& name = request.category->name;
    for (const auto& place : places) {
      if (!here || is_usual(place))
        add_hosts(room, name, place.receptacle, place.relation, place.weight * suits_it, hosts);
    }
  }

  bool keeps(std::size_t room, const std::string& category, const std::string& receptacle) const {
    const auto* household = workspace_.household();
    return household == nullptr || household->keeps(category, receptacle, workspace_.scene().rooms[room].type);
  }

  bool serves(std::size_t node, const std::string& category) const {
    if (workspace_.household() == nullptr) return true;
    const auto around = inside_.find(node);
    return unietp::serves(*workspace_.household(), workspace_.scene().nodes[node],
                          around == inside_.end() ? std::string_view() : around->second, category);
  }

  void add_hosts(std::size_t room, const std::string& category, const std::string& receptacle, Predicate relation,
                 double likelihood, std::vector<Host>& hosts) const {
    const auto there = rooms_[room].find(receptacle);
    if (likelihood <= 0 || there == rooms_[room].end() || !keeps(room, category, receptacle)) return;
    const auto usual = recipe_.held.find(receptacle);
    const double mean = usual == recipe_.held.end() ? kHeldByOthers : usual->second;
    for (const std::size_t node : there->second) {
      if (!serves(node, category)) continue;
      const auto carried = carried_.find(node);
      const double crowd = carried == carried_.end() ? 0 : static_cast<double>(carried->second.size()) / (mean + 1);
      const bool carried_about = workspace_.household() != nullptr && workspace_.scene().nodes[node].movable;
      const bool with_like = carried != carried_.end() && std::find(carried->second.begin(), carried->second.end(),
                                                                    category) != carried->second.end();
      const double share = likelihood * (carried_about ? kOnMovable : 1) * (with_like ? kWithLike : 1) /
                           static_cast<double>(there->second.size());
      hosts.push_back({node, relation, share / (1 + crowd + crowd * crowd * crowd)});
    }
  }

  Workspace& workspace_;
  const LayoutRecipe& recipe_;
  const ScatterOptions& options_;
  std::vector<std::map<std::string, std::vector<std::size_t>, std::less<>>> rooms_;  // category → nodes, by room
  std::set<std::string_view> sliced_;                              // categories that only slicing makes
  std::map<std::size_t, std::vector<std::string_view>> carried_;   // categories of the things put on or in a node
  std::map<std::size_t, std::vector<std::string_view>> contents_;  // the same of those that were put in it
  std::map<std::size_t, std::string> inside_;                      // of a thing that was put in one: that category
};

}  // namespace

std::vector<Host> hosts_for(const Workspace& workspace, const Node& object) {
  const Knowledge& knowledge = workspace.knowledge();
  const Category* category = knowledge.find(object.category);
  std::vector<Host> hosts;
  if (category == nullptr) return hosts;
  struct Receptacle {
    double on = 0, inside = 0;  // how likely
  };
  std::map<std::string_view, Receptacle> receptacles;
  const auto* household = workspace.household();
  const auto add = [&](std::string_view receptacle, Predicate relation, double weight) {
    (relation == Predicate::On ? receptacles[receptacle].on : receptacles[receptacle].inside) = weight;
  };
  if (household != nullptr && !household->places_of(object.category).empty()) {
    for (const auto& place : household->places_of(object.category)) add(place.receptacle, place.relation, place.weight);
  } else {
    for (const Predicate relation : {Predicate::On, Predicate::Inside}) {
      for (const Placement* placement : knowledge.placements_of(object.category, relation))
        add(placement->receptacle, relation, placement->likelihood);
    }
  }
  const auto& nodes = workspace.scene().nodes;
  const std::vector<bool> usual_here = usual_rooms(workspace, *category);
  const auto is_of_use = [&](std::size_t node, bool inside) {
    if (workspace.home() == nullptr || nodes[node].movable) return true;
    const auto own = workspace.home()->places.find(nodes[node].id);
    return !own || unietp::is_of_use(*workspace.home(), *own, inside);
  };
  const auto suits = [&](std::size_t node) {
    if (household == nullptr) return workspace.is_in(node, usual_here) ? kUsualRoomFactor : 1;
    const Room* room = workspace.room_of(node);
    if (room != nullptr && !household->keeps(object.category, nodes[node].category, room->type)) return kLeastSuits;
    return std::max(kLeastSuits, room == nullptr ? 1 : household->in_room(object.category, room->type));
  };
  for (const auto& [name, receptacle] : receptacles) {
    const auto& there = workspace.places().of(name);
    const bool itself = name == object.category && workspace.places().find(object.id);
    const auto count = static_cast<double>(there.size() - (itself ? 1 : 0));
    const double on = receptacle.on / count, inside = receptacle.inside / count;
    for (const std::size_t node : there) {
      if (itself && nodes[node].id == object.id) continue;
      if (household != nullptr && nodes[node].movable &&
          !serves(*household, nodes[node], around(workspace, nodes[node]), object.category))
        continue;
      const double usual = suits(node) * (household != nullptr && nodes[node].movable ? kOnMovable : 1);
      if (on > 0 && is_of_use(node, false)) hosts.push_back({node, Predicate::On, on * usual});
      if (inside > 0 && is_of_use(node, true)) hosts.push_back({node, Predicate::Inside, inside * usual});
    }
  }
  return hosts;
}

int scatter_objects(Workspace& workspace, const LayoutRecipe& recipe, const ScatterOptions& options, Rng rng) {
  Scatterer scatterer(workspace, recipe, options);
  Rng draw = rng.fork("wishes", 0);
  int placed = 0;
  std::uint64_t tries = 0;
  const auto place = [&](const PlacementRequest& request) {
    const auto host = scatterer.place(request, rng.fork("object", tries++));
    if (!host) return;
    ++placed;
    for (int more = scatterer.draw_row(*host, *request.category, draw); more > 0 && placed < options.wanted; --more)
      placed += scatterer.continue_row(*host, *request.category, rng.fork("object", tries++)) ? 1 : 0;
  };
  for (const PlacementRequest& request : scatterer.draw_requests(draw)) {
    if (placed < options.wanted) place(request);
  }
  for (int more = 0; more < 2 * options.wanted && placed < options.wanted; ++more) {
    const auto request = scatterer.draw_request(draw);
    if (!request) break;
    place(*request);
  }
  return placed;
}

}  // namespace unietp
