#include "validator/referents.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/text.h"
#include "logic/evaluate.h"
#include "scene/size_and_nearness.h"
#include "simulation/navigation.h"
#include "validator/conjuncts.h"
#include "validator/room_ways.h"

namespace unietp {
namespace {

using Op = Formula::Op;

std::string kind_of(Predicate predicate) {
  switch (predicate) {
    case Predicate::Nearest:
      return "nearness";
    case Predicate::Size:
      return "size";
    case Predicate::Color:
    case Predicate::Material:
      return "attribute";
    case Predicate::InRoom:
      return "room";
    case Predicate::On:
    case Predicate::Inside:
    case Predicate::OnFloor:
    case Predicate::Under:
    case Predicate::NextTo:
    case Predicate::Attached:
      return "relation";
    default:
      return "state";
  }
}

/// What a test says of the thing itself; of a landmark's own domain nothing.
void collect_kinds(const Formula& test, std::set<std::string>& kinds) {
  if (test.op == Op::Atom) kinds.insert(kind_of(test.predicate));
  for (const Formula& child : test.children) collect_kinds(child, kinds);
}

std::vector<Formula> tests_of(const Domain& domain) {
  const Formula& where = domain.where.front();
  return where.op == Op::And ? where.children : std::vector<Formula>{where};
}

/// The relation that a test says the thing has to some landmark.
std::optional<Predicate> relation_to_some(const Formula& test, const std::string& variable) {
  if (test.op != Op::Exists) return std::nullopt;
  const Formula& inner = test.children.front();
  for (const Predicate relation : {Predicate::Nearest, Predicate::NextTo}) {
    if (inner == atom(relation, {variable, test.variable})) return relation;
  }
  return std::nullopt;
}

/// On, in or under something is one kind of relation, beside something another.
bool is_of_one_kind(Predicate a, Predicate b) { return (a == Predicate::NextTo) == (b == Predicate::NextTo); }

/// The relation that a test says the thing has to another thing, not to a room.
std::optional<Predicate> relation_to_a_thing(const Formula& test, const std::string& variable) {
  if (test.op != Op::Exists || test.domain.kind != Domain::Kind::Categories) return std::nullopt;
  for (const Predicate relation : {Predicate::On, Predicate::Inside, Predicate::Under, Predicate::NextTo}) {
    if (test.children.front() == atom(relation, {variable, test.variable})) return relation;
  }
  return std::nullopt;
}

class Walker {
 public:
  Walker(const Scene& scene, const Profile& profile)
      : scene_(scene), grid_(scene, profile), reached_(grid_.reached_from(grid_.cell_at(scene.agent.position))) {}

  const Room* room_of(const std::string& id) const {
    const auto here = std::find_if(scene_.rooms.begin(), scene_.rooms.end(), [&](const Room& room) {
      return scene_.edges.contains({Predicate::InRoom, id, room.id});
    });
    return here == scene_.rooms.end() ? nullptr : &*here;
  }

  /// Those of the ids in the landmark's room that can be walked to from it there, with the meters, nearest first.
  std::vector<std::pair<double, std::string>> from(const std::string& landmark,
                                                   const std::vector<std::string>& ids) const {
    std::vector<std::pair<double, std::string>> ways;
    const Room* room = room_of(landmark);
    if (room == nullptr) return ways;
    const RoomWays floor(grid_, reached_, *room, place_of(landmark));
    for (const std::string& id : ids) {
      if (room_of(id) != room) continue;
      if (const auto way = floor.meters(place_of(id))) ways.emplace_back(*way, id);
    }
    std::sort(ways.begin(), ways.end());
    return ways;
  }

 private:
  Vec2 place_of(const std::string& id) const { return find_node(scene_, id)->pose.position.head<2>(); }

  const Scene& scene_;
  NavigationGrid grid_;
  CellSet reached_;
};

class ReferentReader {
 public:
  ReferentReader(const Scene& scene, const Trace& start, const Profile& profile)
      : scene_(scene), start_(start), profile_(profile) {}

  Referents read(const ReferringDomain& one) const {
    Referents found;
    found.phrase = to_text(one.domain);
    found.means = ids_of(one.domain, one.variable);
    const auto tests = tests_of(one.domain);
    std::set<std::string> kinds;
    for (const Formula& test : tests) collect_kinds(test, kinds);
    found.kind = join({kinds.begin(), kinds.end()}, "+");
    for (std::size_t i = 0; i < tests.size(); ++i) {
      Domain others = one.domain;
      others.where.clear();
      auto rest = tests;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      if (rest.size() == 1) others.where = rest;
      if (rest.size() > 1) {
        others.where.push_back(one.domain.where.front());
        others.where.front().children = rest;
      }
      if (one.certain && ids_of(others, one.variable).size() <= found.means.size())
        found.idle.push_back(to_text(tests[i]));
      if (const auto relation = relation_to_some(tests[i], one.variable)) walk(tests[i], *relation, one, found);
      const auto relation = relation_to_a_thing(tests[i], one.variable);
      if (one.certain && relation && !another_has_one(*relation, one, found))
        found.unrelated.push_back(to_text(tests[i]));
    }
    return found;
  }

 private:
  /// Whether one that is not meant has a relation of the kind to something.
  bool another_has_one(Predicate relation, const ReferringDomain& one, const Referents& found) const {
    Domain all = one.domain;
    all.where.clear();
    const auto kind = ids_of(all, one.variable);
    return std::any_of(kind.begin(), kind.end(), [&](const std::string& id) {
      if (std::find(found.means.begin(), found.means.end(), id) != found.means.end()) return false;
      return std::any_of(scene_.edges.begin(), scene_.edges.end(), [&](const Edge& edge) {
        const bool between_things = edge.relation == Predicate::On || edge.relation == Predicate::Inside ||
                                    edge.relation == Predicate::Under || edge.relation == Predicate::NextTo;
        return edge.from == id && between_things && is_of_one_kind(edge.relation, relation);
      });
    });
  }

  std::vector<std::string> ids_of(const Domain& domain, const std::string& variable) const {
    std::vector<std::string> ids;
    for (const EntityIndex one : members_of(domain, variable, start_)) ids.push_back(start_.entities[one].id);
    return ids;
  }

  bool holds(Predicate relation, const std::string& first, const std::string& second) const {
    const auto index = [&](const std::string& id) {
      std::size_t i = 0;
      while (start_.entities[EntityIndex(i)].id != id) ++i;
      return EntityIndex(i);
    };
    return start_.states.front().holds(relation, index(first), index(second));
  }

  void walk(const Formula& test, Predicate relation, const ReferringDomain& one, Referents& found) const {
    Domain all = one.domain;
    all.where.clear();
    const auto kind = ids_of(all, one.variable);
    std::set<std::string> missed(found.means.begin(), found.means.end());
    for (const std::string& landmark : ids_of(test.domain, test.variable)) {
      if (relation == Predicate::NextTo) {
        std::erase_if(missed, [&](const std::string& id) {
          return holds(relation, id, landmark) && walker().room_of(id) == walker().room_of(landmark);
        });
        continue;
      }
      const auto ways = walker().from(landmark, kind);
      if (ways.empty() || (ways.size() > 1 && !clearly_nearer(ways[0].first, ways[1].first))) continue;
      const std::string& nearest = ways.front().second;
      if (std::find(found.means.begin(), found.means.end(), nearest) == found.means.end()) {
        found.rivals.push_back(nearest);
      } else if (holds(relation, nearest, landmark)) {
        missed.erase(nearest);
      }
    }
    found.beyond_wall.insert(found.beyond_wall.end(), missed.begin(), missed.end());
  }

  const Walker& walker() const {
    if (!walker_) walker_.emplace(scene_, profile_);
    return *walker_;
  }

  const Scene& scene_;
  const Trace& start_;
  const Profile& profile_;
  mutable std::optional<Walker> walker_;  // only phrases about nearness and neighbors need it
};

}  // namespace

std::vector<Referents> referents_of(const Formula& goal, const Scene& scene, const Trace& start,
                                    const Profile& profile) {
  std::vector<Referents> all;
  const auto domains = referring_domains(goal);
  if (domains.empty()) return all;
  const ReferentReader reader(scene, start, profile);
  for (const ReferringDomain& one : domains) all.push_back(reader.read(one));
  return all;
}

void ReferentCounts::add(const Referents& one) {
  const int count = static_cast<int>(one.means.size());
  ++phrases;
  referents += count;
  by_kind[one.kind] += count;
  beyond_wall += static_cast<int>(one.beyond_wall.size());
  rivals += one.rivals.empty() ? 0 : 1;
  without_alternative += one.idle.empty() ? 0 : count;
  without_relation += one.unrelated.empty() ? 0 : count;
}

void ReferentCounts::add(const ReferentCounts& more) {
  phrases += more.phrases;
  referents += more.referents;
  for (const auto& [kind, count] : more.by_kind) by_kind[kind] += count;
  beyond_wall += more.beyond_wall;
  rivals += more.rivals;
  without_alternative += more.without_alternative;
  without_relation += more.without_relation;
}

}  // namespace unietp
