#include "scene/comparisons.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "scene/size_and_nearness.h"

namespace unietp {
namespace {

using Scope = std::vector<std::pair<std::string_view, const Domain*>>;

void collect(const Formula& formula, Scope& scope, Compared& compared) {
  if (formula.op == Formula::Op::Atom &&
      (formula.predicate == Predicate::Size || formula.predicate == Predicate::Nearest)) {
    for (const Term& term : formula.terms) {
      if (term.kind != Term::Kind::Variable) continue;
      const auto bound =
          std::find_if(scope.rbegin(), scope.rend(), [&](const auto& one) { return one.first == term.name; });
      if (bound == scope.rend() || bound->second->kind == Domain::Kind::Object) {
        compared.all = true;
      } else {
        for (const auto& member : bound->second->members) compared.categories.push_back(member.category);
      }
    }
  }
  const bool binds = !formula.variable.empty();
  if (binds) scope.emplace_back(formula.variable, &formula.domain);
  for (const Formula& where : formula.domain.where) collect(where, scope, compared);
  for (const Formula& child : formula.children) collect(child, scope, compared);
  if (binds) scope.pop_back();
}

/// Positions in the list of nodes of all things that are compared, with the others of their categories.
std::vector<std::size_t> places_of(const SharedList<Node>& nodes, const Compared& compared) {
  std::vector<std::size_t> places;
  const auto named = [&](const std::string& category) {
    return std::binary_search(compared.categories.begin(), compared.categories.end(), category);
  };
  std::set<std::string_view> categories;
  for (const Node& node : nodes) {
    if (compared.all || named(node.category) || (!node.whole_category.empty() && named(node.whole_category)))
      categories.insert(node.category);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (categories.contains(nodes[i].category)) places.push_back(i);
  }
  return places;
}

}  // namespace

void Compared::add(const Formula& formula) {
  Scope scope;
  collect(formula, scope, *this);
  std::sort(categories.begin(), categories.end());
  categories.erase(std::unique(categories.begin(), categories.end()), categories.end());
}

Facts with_comparisons(const Facts& facts, const Scene& scene, const FactReader& reader, const Compared& compared) {
  Facts with = facts;
  const auto places = places_of(scene.nodes, compared);
  std::map<std::size_t, EntityIndex> known;
  for (const std::size_t place : places) {
    if (const auto entity = reader.find(scene.nodes[place].id)) known.emplace(place, *entity);
  }
  for (const NearestPair& pair : nearest_pairs(scene.nodes, places)) {
    const auto winner = known.find(pair.winner), other = known.find(pair.other);
    if (winner != known.end() && other != known.end()) with.set(Predicate::Nearest, winner->second, other->second);
  }
  for (const auto& [place, size] : sizes_of(scene.nodes, places)) {
    if (const auto thing = known.find(place); thing != known.end()) with.set(Predicate::Size, thing->second, size);
  }
  return with;
}

Trace read_state(const Scene& scene, const Compared& compared) {
  FactReader reader;
  Facts facts = reader.read(scene);
  if (!compared.none()) facts = with_comparisons(facts, scene, reader, compared);
  return {reader.entities(), {std::move(facts)}};
}

}  // namespace unietp
