#include "akb/coverage.h"

#include <algorithm>
#include <set>

#include "akb/table_words.h"
#include "akb/tables.h"

namespace unietp {
namespace {

template <class Row>
FactCounts count(const std::vector<Row>& rows) {
  FactCounts counted;
  for (const Row& row : rows) counted.add(row.source);
  return counted;
}

template <class Test>
std::vector<std::string> categories_where(const Knowledge& knowledge, const Test& test) {
  std::vector<std::string> names;
  for (const auto& c : knowledge.categories()) {
    if (test(c)) names.push_back(c.name);
  }
  return names;
}

}  // namespace

std::string kind_of(const Source& source) { return source.source.substr(0, source.source.find(':')); }

void FactCounts::add(const Source& source) {
  ++facts;
  confidence_sum += source.confidence;
  ++by_kind[kind_of(source)];
  ++by_source[source.source];
}

Coverage coverage_of(const Knowledge& knowledge) {
  Coverage coverage;
  coverage.categories = knowledge.categories().size();
  FactCounts sizes, masses;
  for (const auto& c : knowledge.categories()) {
    sizes.add(c.size_source);
    masses.add(c.mass_source);
  }
  coverage.tables = {{"category", count(knowledge.categories())},
                     {"size", sizes},
                     {"mass", masses},
                     {"affordance", count(knowledge.affordances())},
                     {"relation", count(knowledge.placements())},
                     {"effect", count(knowledge.effects())},
                     {"alias", count(knowledge.aliases())},
                     {"asset", count(knowledge.assets())}};
  for (const auto& name : affordance_names()) coverage.affordances.emplace_back(name, FactCounts{});
  for (const auto& fact : knowledge.affordances()) {
    for (auto& [name, counted] : coverage.affordances) {
      if (name == fact.affordance) counted.add(fact.source);
    }
  }
  std::set<std::string, std::less<>> placed, named;
  for (const auto& p : knowledge.placements()) placed.insert({p.object, p.receptacle});
  for (const auto& a : knowledge.aliases()) named.insert(a.category);
  coverage.missing = {
      {"synset", categories_where(knowledge, [](const Category& c) { return c.synset.empty(); })},
      {"rooms", categories_where(knowledge, [](const Category& c) { return c.rooms.empty(); })},
      {"placements", categories_where(knowledge, [&](const Category& c) { return !placed.contains(c.name); })},
      {"aliases", categories_where(knowledge, [&](const Category& c) { return !named.contains(c.name); })}};
  return coverage;
}

}  // namespace unietp
