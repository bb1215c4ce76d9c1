#include "akb/knowledge.h"

#include "akb/fit.h"
#include "akb/table_words.h"
#include "akb/tables.h"

namespace unietp {
namespace {

template <class Row>
std::vector<const Row*> pointers(const std::vector<Row>& rows, std::span<const std::uint32_t> numbers) {
  std::vector<const Row*> found;
  found.reserve(numbers.size());
  for (const auto number : numbers) found.push_back(&rows[number]);
  return found;
}
template <class Row>
const Row* first(const std::vector<Row>& rows, std::span<const std::uint32_t> numbers) {
  return numbers.empty() ? nullptr : &rows[numbers.front()];
}

/// Gives names their numbers. A name that is not in the table is kept for a second round.
class Numbering {
 public:
  explicit Numbering(std::vector<std::string> names) : table_(std::move(names)) {}
  std::uint32_t operator()(const std::string& name) {
    const auto number = table_.number(name);
    if (number == NameTable::kNone) strangers_.push_back(name);
    return number;
  }
  bool complete() const { return strangers_.empty(); }
  void take_strangers() {
    auto names = table_.names();
    names.insert(names.end(), strangers_.begin(), strangers_.end());
    *this = Numbering(std::move(names));
  }
  NameTable table() && { return std::move(table_); }

 private:
  NameTable table_;
  std::vector<std::string> strangers_;
};

/// Enums are their own numbers.
template <class Enum>
std::uint32_t number_of(Enum value) {
  return static_cast<std::uint32_t>(value);
}

/// The numbers of the names by which rows are found.
struct Keys {
  std::vector<RowKey> categories, affordances, placements, effects, aliases, assets;
};
template <class Row, class KeyOf>
std::vector<RowKey> keys_of(const std::vector<Row>& rows, const KeyOf& key_of) {
  std::vector<RowKey> keys;
  keys.reserve(rows.size());
  for (const Row& row : rows) keys.push_back(key_of(row));
  return keys;
}
Keys keys_of(const Tables& tables, Numbering& name, Numbering& word) {
  Keys keys;
  keys.categories = keys_of(tables.categories, [&](const Category& c) -> RowKey { return {name(c.name)}; });
  keys.affordances = keys_of(tables.affordances, [&](const AffordanceFact& f) -> RowKey {
    return {name(f.category), word(f.affordance)};
  });
  keys.placements = keys_of(tables.placements, [&](const Placement& p) -> RowKey {
    return {name(p.object), number_of(p.relation), name(p.receptacle)};
  });
  keys.effects = keys_of(tables.effects, [&](const Effect& e) -> RowKey {
    return {name(e.tool), number_of(e.treatment), name(e.target)};
  });
  keys.aliases = keys_of(tables.aliases, [&](const Alias& a) -> RowKey {
    return {name(a.category), number_of(a.kind)};
  });
  keys.assets = keys_of(tables.assets, [&](const Asset& a) -> RowKey { return {name(a.category)}; });
  return keys;
}

std::vector<RowKey> backwards(std::vector<RowKey> keys) {
  for (auto& key : keys) std::swap(key.first, key.third);
  return keys;
}

std::vector<std::string> category_names(const Tables& tables) {
  std::vector<std::string> names;
  for (const auto& c : tables.categories) names.push_back(c.name);
  return names;
}
}  // namespace

Knowledge::Knowledge(Simulator simulator, std::vector<Category> categories, std::vector<AffordanceFact> affordances,
                     std::vector<Placement> placements, std::vector<Effect> effects, std::vector<Alias> aliases,
                     std::vector<Asset> assets)
    : simulator_(simulator) {
  Tables tables{std::move(categories), std::move(affordances), std::move(placements),
                std::move(effects),    std::move(aliases),     std::move(assets)};
  sort_tables(tables);
  Numbering names(category_names(tables)), words(affordance_names());
  Keys keys = keys_of(tables, names, words);
  if (!names.complete() || !words.complete()) {
    names.take_strangers();
    words.take_strangers();
    keys = keys_of(tables, names, words);
  }
  names_ = std::move(names).table();
  words_ = std::move(words).table();

  category_of_ = RowIndex(keys.categories, names_.size());
  by_category_ = RowIndex(keys.affordances, names_.size());
  by_object_ = RowIndex(keys.placements, names_.size());
  by_tool_ = RowIndex(keys.effects, names_.size());
  by_alias_ = RowIndex(keys.aliases, names_.size());
  assets_of_ = RowIndex(keys.assets, names_.size());
  for (auto& key : keys.affordances) std::swap(key.first, key.second);
  by_affordance_ = RowIndex(keys.affordances, words_.size());
  by_receptacle_ = RowIndex(backwards(std::move(keys.placements)), names_.size());
  by_target_ = RowIndex(backwards(std::move(keys.effects)), names_.size());
  categories_ = std::move(tables.categories);
  affordances_ = std::move(tables.affordances);
  placements_ = std::move(tables.placements);
  effects_ = std::move(tables.effects);
  aliases_ = std::move(tables.aliases);
  assets_ = std::move(tables.assets);
  asset_named_ = NameSlots(assets_.size(), [&](std::uint32_t row) -> std::string_view { return assets_[row].name; });
}

const Category* Knowledge::find(std::string_view name) const {
  return first(categories_, category_of_.with(names_.number(name)));
}

bool Knowledge::has(std::string_view category, std::string_view affordance) const {
  return !by_category_.with(names_.number(category), words_.number(affordance)).empty();
}

std::vector<std::string> Knowledge::with_affordance(std::string_view affordance) const {
  std::vector<std::string> names;
  for (const auto row : by_affordance_.with(words_.number(affordance))) names.push_back(affordances_[row].category);
  return names;
}

std::vector<std::string> Knowledge::affordances_of(std::string_view category) const {
  std::vector<std::string> names;
  for (const auto row : by_category_.with(names_.number(category))) names.push_back(affordances_[row].affordance);
  return names;
}

std::vector<const AffordanceFact*> Knowledge::affordance_facts_of(std::string_view category) const {
  return pointers(affordances_, by_category_.with(names_.number(category)));
}

const Placement* Knowledge::placement(std::string_view object, Predicate relation, std::string_view receptacle) const {
  return first(placements_, by_object_.with(names_.number(object), number_of(relation), names_.number(receptacle)));
}

std::vector<const Placement*> Knowledge::placements_of(std::string_view object, Predicate relation) const {
  return pointers(placements_, by_object_.with(names_.number(object), number_of(relation)));
}

std::vector<const Placement*> Knowledge::placements_at(std::string_view receptacle, Predicate relation) const {
  return pointers(placements_, by_receptacle_.with(names_.number(receptacle), number_of(relation)));
}

const Effect* Knowledge::effect(std::string_view tool, Treatment treatment, std::string_view target) const {
  return first(effects_, by_tool_.with(names_.number(tool), number_of(treatment), names_.number(target)));
}

std::vector<const Effect*> Knowledge::effects_on(std::string_view target, Treatment treatment) const {
  return pointers(effects_, by_target_.with(names_.number(target), number_of(treatment)));
}

std::vector<const Effect*> Knowledge::effects_of(std::string_view tool, Treatment treatment) const {
  return pointers(effects_, by_tool_.with(names_.number(tool), number_of(treatment)));
}

std::vector<const Asset*> Knowledge::assets_of(std::string_view category) const {
  auto found = asset_rows_of(category);
  const Category* own = find(category);
  std::erase_if(found, [&](const Asset* a) { return own == nullptr || !usable(*a, *own); });
  return found;
}

std::vector<const Asset*> Knowledge::asset_rows_of(std::string_view category) const {
  return pointers(assets_, assets_of_.with(names_.number(category)));
}

const Asset* Knowledge::asset(std::string_view name) const {
  const auto row = asset_named_.find(name, [&](std::uint32_t at) -> std::string_view { return assets_[at].name; });
  return row == NameSlots::kNone ? nullptr : &assets_[row];
}

std::vector<const Alias*> Knowledge::aliases_of(std::string_view category, AliasKind kind) const {
  return pointers(aliases_, by_alias_.with(names_.number(category), number_of(kind)));
}

}  // namespace unietp
