#include "akb/knowledge.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "akb/tables.h"

namespace unietp {
namespace {

using Key2 = std::tuple<std::string_view, std::string_view>;
using Key3 = std::tuple<std::string_view, std::string_view, std::string_view>;

Key2 by_category(const AffordanceFact& f) { return {f.category, f.affordance}; }
Key3 by_object(const Placement& p) { return {p.object, p.relation, p.receptacle}; }
Key3 by_tool(const Effect& e) { return {e.tool, e.effect, e.target}; }
Key2 by_kind(const Alias& a) { return {a.category, a.kind}; }

/// Row numbers of a table in the order of another key.
template <class Row, class KeyOf>
std::vector<std::uint32_t> order_by(const std::vector<Row>& rows, const KeyOf& key) {
  std::vector<std::uint32_t> order(rows.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(rows[a]) < key(rows[b]); });
  return order;
}

/// Rows of a sorted table whose key begins with `prefix`; `head` cuts a row's key to the prefix's length.
template <class Row, class Prefix, class Head>
std::vector<const Row*> range(const std::vector<Row>& rows, const Prefix& prefix, const Head& head) {
  std::vector<const Row*> found;
  auto at =
      std::lower_bound(rows.begin(), rows.end(), prefix, [&](const Row& r, const Prefix& p) { return head(r) < p; });
  for (; at != rows.end() && head(*at) == prefix; ++at) found.push_back(&*at);
  return found;
}
template <class Row, class Prefix, class Head>
std::vector<const Row*> range(const std::vector<Row>& rows, const std::vector<std::uint32_t>& order,
                              const Prefix& prefix, const Head& head) {
  std::vector<const Row*> found;
  auto at = std::lower_bound(order.begin(), order.end(), prefix,
                             [&](std::uint32_t i, const Prefix& p) { return head(rows[i]) < p; });
  for (; at != order.end() && head(rows[*at]) == prefix; ++at) found.push_back(&rows[*at]);
  return found;
}
template <class Row, class Key, class KeyOf>
const Row* first(const std::vector<Row>& rows, const Key& key, const KeyOf& key_of) {
  const auto at =
      std::lower_bound(rows.begin(), rows.end(), key, [&](const Row& r, const Key& k) { return key_of(r) < k; });
  return at != rows.end() && key_of(*at) == key ? &*at : nullptr;
}

}  // namespace

Knowledge::Knowledge(Simulator simulator, std::vector<Category> categories, std::vector<AffordanceFact> affordances,
                     std::vector<Placement> placements, std::vector<Effect> effects, std::vector<Alias> aliases,
                     std::vector<Asset> assets)
    : simulator_(simulator) {
  Tables tables{std::move(categories), std::move(affordances), std::move(placements),
                std::move(effects),    std::move(aliases),     std::move(assets)};
  sort_tables(tables);
  categories_ = std::move(tables.categories);
  affordances_ = std::move(tables.affordances);
  placements_ = std::move(tables.placements);
  effects_ = std::move(tables.effects);
  aliases_ = std::move(tables.aliases);
  assets_ = std::move(tables.assets);
  by_affordance_ = order_by(affordances_, [](const AffordanceFact& f) { return Key2{f.affordance, f.category}; });
  by_receptacle_ = order_by(placements_, [](const Placement& p) { return Key3{p.receptacle, p.relation, p.object}; });
  by_asset_ = order_by(assets_, [](const Asset& a) { return std::string_view(a.name); });
  by_target_ = order_by(effects_, [](const Effect& e) { return Key3{e.target, e.effect, e.tool}; });
}

const Category* Knowledge::find(std::string_view name) const {
  return first(categories_, name, [](const Category& c) { return std::string_view(c.name); });
}

bool Knowledge::has(std::string_view category, std::string_view affordance) const {
  return first(affordances_, Key2{category, affordance}, by_category) != nullptr;
}

std::vector<std::string> Knowledge::with_affordance(std::string_view affordance) const {
  std::vector<std::string> names;
  const auto head = [](const AffordanceFact& f) { return std::string_view(f.affordance); };
  for (const auto* fact : range(affordances_, by_affordance_, affordance, head)) names.push_back(fact->category);
  return names;
}

std::vector<std::string> Knowledge::affordances_of(std::string_view category) const {
  std::vector<std::string> names;
  const auto head = [](const AffordanceFact& f) { return std::string_view(f.category); };
  for (const auto* fact : range(affordances_, category, head)) names.push_back(fact->affordance);
  return names;
}

const Placement* Knowledge::placement(std::string_view object, std::string_view relation,
                                      std::string_view receptacle) const {
  return first(placements_, Key3{object, relation, receptacle}, by_object);
}

std::vector<const Placement*> Knowledge::placements_of(std::string_view object, std::string_view relation) const {
  return range(placements_, Key2{object, relation}, [](const Placement& p) { return Key2{p.object, p.relation}; });
}

std::vector<const Placement*> Knowledge::placements_at(std::string_view receptacle, std::string_view relation) const {
  return range(placements_, by_receptacle_, Key2{receptacle, relation}, [](const Placement& p) {
    return Key2{p.receptacle, p.relation};
  });
}

const Effect* Knowledge::effect(std::string_view tool, std::string_view effect, std::string_view target) const {
  return first(effects_, Key3{tool, effect, target}, by_tool);
}

std::vector<const Effect*> Knowledge::effects_on(std::string_view target, std::string_view effect) const {
  return range(effects_, by_target_, Key2{target, effect}, [](const Effect& e) { return Key2{e.target, e.effect}; });
}

std::vector<const Effect*> Knowledge::effects_of(std::string_view tool, std::string_view effect) const {
  return range(effects_, Key2{tool, effect}, [](const Effect& e) { return Key2{e.tool, e.effect}; });
}

std::vector<const Asset*> Knowledge::assets_of(std::string_view category) const {
  return range(assets_, category, [](const Asset& a) { return std::string_view(a.category); });
}

const Asset* Knowledge::asset(std::string_view name) const {
  const auto found = range(assets_, by_asset_, name, [](const Asset& a) { return std::string_view(a.name); });
  return found.empty() ? nullptr : found.front();
}

std::vector<const Alias*> Knowledge::aliases_of(std::string_view category, std::string_view kind) const {
  return range(aliases_, Key2{category, kind}, by_kind);
}

}  // namespace unietp
