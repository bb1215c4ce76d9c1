#include "sense/start_states.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "akb/row_reader.h"
#include "core/files.h"

namespace unietp {
namespace {

auto key_of(const LikelyState& row) { return std::tie(row.thing, row.place, row.state); }

/// The role itself, then the same of each wider kind of place, then anywhere.
std::vector<Role> wider_places(const Role& place, const Kinds& kinds) {
  std::vector<Role> all;
  if (const auto mark = place.find(':'); mark != Role::npos) {
    for (const Kind* kind : kinds.lineage(place.substr(mark + 1)))
      all.push_back(place.substr(0, mark + 1) + kind->name);
  }
  all.emplace_back();
  return all;
}

bool is_place(const Role& role, const Kinds& kinds) {
  const auto mark = role.find(':');
  const auto* kind = mark == Role::npos ? nullptr : kinds.find(role.substr(mark + 1));
  return kind != nullptr && kinds.place_role(role.substr(0, mark), kind->name) == role;
}

bool is_state(Predicate predicate) { return !info(predicate).group.empty() || predicate == Predicate::Covered; }

std::optional<Predicate> state_named(std::string_view name) {
  const auto predicate = predicate_named(name);
  if (!predicate || !is_state(*predicate)) return std::nullopt;
  return predicate;
}

std::vector<std::string> state_names() {
  std::vector<std::string> names;
  for (const auto& known : all_predicates()) {
    if (is_state(known.predicate)) names.emplace_back(known.name);
  }
  return names;
}

}  // namespace

StartStates::StartStates(const Kinds& kinds, std::vector<LikelyState> rows) : kinds_(kinds), rows_(std::move(rows)) {
  std::sort(rows_.begin(), rows_.end(),
            [](const LikelyState& a, const LikelyState& b) { return key_of(a) < key_of(b); });
}

std::vector<LikelyState> StartStates::of(std::string_view kind, const Role& place) const {
  const auto lineage = kinds_.lineage(kind);
  std::map<State, LikelyState> found;
  for (const auto& at : wider_places(place, kinds_)) {
    for (const Kind* wider : lineage) {
      const auto first = std::lower_bound(
          rows_.begin(), rows_.end(), std::tie(wider->name, at),
          [](const LikelyState& row, const auto& key) { return std::tie(row.thing, row.place) < key; });
      for (auto row = first; row != rows_.end() && row->thing == wider->name && row->place == at; ++row)
        found.try_emplace(row->state, *row);
    }
  }
  std::vector<LikelyState> all;
  for (auto& [state, row] : found) all.push_back(std::move(row));
  return all;
}

std::optional<double> StartStates::share(std::string_view kind, const Role& place, const State& state) const {
  for (const auto& row : of(kind, place)) {
    if (row.state == state) return row.share;
  }
  return std::nullopt;
}

StartStates read_start_states(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return {kinds, {}};
  }
  std::vector<LikelyState> rows;
  std::set<std::tuple<std::string, std::string, State>> seen;
  RowReader row(path.string(), *text, {"thing", "place", "state", "substance", "share", "source"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    LikelyState fact;
    fact.thing = row.required("thing");
    if (kinds.find(fact.thing) == nullptr) row.fail("thing", "'" + fact.thing + "' is not a kind of kinds.csv");
    fact.place = row.text("place");
    if (!fact.place.empty() && !is_place(fact.place, kinds))
      row.fail("place",
               "'" + fact.place + "' is no place; expected on: or in: and a kind of kinds.csv, such as in:sink");
    const auto predicate = row.value_of("state", state_names(), "state", state_named);
    const bool needs_substance = predicate == Predicate::Filled || predicate == Predicate::Covered;
    fact.state = {predicate, row.text("substance")};
    if (row.sound() && fact.state.symbol.empty() == needs_substance)
      row.fail("substance", needs_substance ? "expected the substance" : "expected nothing for this state");
    fact.share = row.number("share", 0, 1, true);
    fact.source = row.required("source");
    if (!row.sound()) continue;
    if (!seen.emplace(fact.thing, fact.place, fact.state).second) row.fail("state", "this row stands twice");
    rows.push_back(std::move(fact));
  }
  return {kinds, std::move(rows)};
}

}  // namespace unietp
