#include "grounding/new_places.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr int kMostRoomsOfAType = 3;
constexpr std::size_t kMostRooms = 12;

/// A relation that the body asks of the new piece: with a certain thing or room, or with any of some categories.
struct Asked {
  Predicate relation = Predicate::NextTo;
  std::string id;
  std::vector<std::string> categories;
};

class Relations {
 public:
  Relations(const std::string& variable, const std::vector<std::pair<std::string, std::string>>& names)
      : variable_(variable), names_(names) {}

  void collect(const Formula& formula) {
    if (formula.op == Op::And || formula.op == Op::AtEnd) {
      for (const Formula& child : formula.children) collect(child);
    } else if (formula.op == Op::Exists) {
      scope_.push_back(&formula);
      collect(formula.children.front());
      scope_.pop_back();
    } else if (formula.op == Op::Atom && formula.terms.size() == 2) {
      const auto is_new = [&](const Term& term) { return term.kind == Term::Kind::Variable && term.name == variable_; };
      const bool first = is_new(formula.terms[0]), second = is_new(formula.terms[1]);
      if (formula.predicate == Predicate::NextTo && first != second) add(formula, formula.terms[first ? 1 : 0]);
      if (formula.predicate == Predicate::InRoom && first) add(formula, formula.terms[1]);
    }
  }

  const std::vector<Asked>& asked() const { return asked_; }

 private:
  void add(const Formula& atom, const Term& other) {
    if (other.kind != Term::Kind::Variable) return;
    Asked asked{atom.predicate, {}, {}};
    const auto bound =
        std::find_if(scope_.rbegin(), scope_.rend(), [&](const Formula* one) { return one->variable == other.name; });
    if (bound != scope_.rend()) {
      for (const auto& member : (*bound)->domain.members) asked.categories.push_back(member.category);
    } else {
      const auto name =
          std::find_if(names_.rbegin(), names_.rend(), [&](const auto& one) { return one.first == other.name; });
      if (name == names_.rend()) return;
      asked.id = name->second;
    }
    asked_.push_back(std::move(asked));
  }

  const std::string& variable_;
  const std::vector<std::pair<std::string, std::string>>& names_;
  std::vector<const Formula*> scope_;
  std::vector<Asked> asked_;
};

bool contains_one(const std::vector<std::string>& list, const std::string& one) {
  return std::find(list.begin(), list.end(), one) != list.end();
}

}  // namespace

std::vector<NewPlace> places_for_new(const Formula& quantifier,
                                     const std::vector<std::pair<std::string, std::string>>& names,
                                     const Category& category, const Workspace& workspace, Rng& rng) {
  const Scene& scene = workspace.scene();
  std::vector<NewPlace> places(scene.rooms.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i].room = i;
  rng.shuffle(places);
  const auto rank = [&](const NewPlace& place) {
    const auto& type = scene.rooms[place.room].type;
    return std::find(category.rooms.begin(), category.rooms.end(), type) - category.rooms.begin();
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](const NewPlace& a, const NewPlace& b) { return rank(a) < rank(b); });
  Relations relations(quantifier.variable, names);
  relations.collect(quantifier.children.front());
  for (const auto& [relation, id, categories] : relations.asked()) {
    if (relation == Predicate::InRoom) {
      std::erase_if(places, [&, id = &id, types = &categories](const NewPlace& place) {
        const Room& room = scene.rooms[place.room];
        return id->empty() ? !contains_one(*types, room.type) : room.id != *id;
      });
    } else if (!id.empty()) {
      const auto node = workspace.places().find(id);
      if (!node || scene.nodes[*node].movable) continue;
      const Room* room = workspace.room_of(*node);
      std::erase_if(places, [&](const NewPlace& place) { return &scene.rooms[place.room] != room; });
      for (NewPlace& place : places) place.beside = scene.nodes[*node].category;
    } else {
      // Rooms that have such a thing already come first.
      std::map<const Room*, std::string> there;
      for (const std::string& other : categories) {
        for (const std::size_t node : workspace.places().of(other))
          if (!scene.nodes[node].movable) there.emplace(workspace.room_of(node), other);
      }
      for (NewPlace& place : places) {
        const auto found = there.find(&scene.rooms[place.room]);
        if (found != there.end()) place.beside = found->second;
      }
      std::stable_partition(places.begin(), places.end(), [](const NewPlace& place) { return !place.beside.empty(); });
    }
  }
  std::map<std::string_view, int> tried;  // of each type
  std::erase_if(places,
                [&](const NewPlace& place) { return ++tried[scene.rooms[place.room].type] > kMostRoomsOfAType; });
  if (places.size() > kMostRooms) places.resize(kMostRooms);
  return places;
}

}  // namespace unietp
