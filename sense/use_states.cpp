#include "sense/use_states.h"

#include <algorithm>

#include "akb/row_reader.h"

namespace unietp {
namespace {

constexpr std::string_view kCarry = "carry:";

bool matches(const Role& pattern, const Role& use, const Kinds& kinds) {
  if (pattern.starts_with(kCarry) && use.starts_with(kCarry))
    return kinds.is_a(use.substr(kCarry.size()), pattern.substr(kCarry.size()));
  if (!pattern.ends_with('*')) return pattern == use;
  return use.starts_with(pattern.substr(0, pattern.size() - 1));
}

/// One of a group, without a substance.
bool is_plain_state(Predicate state) { return !info(state).group.empty() && state != Predicate::Filled; }

std::optional<Predicate> plain_state_named(std::string_view name) {
  const auto state = predicate_named(name);
  if (!state || !is_plain_state(*state)) return std::nullopt;
  return state;
}

std::vector<std::string> plain_states() {
  std::vector<std::string> names;
  for (const auto& known : all_predicates()) {
    if (is_plain_state(known.predicate)) names.emplace_back(known.name);
  }
  return names;
}

}  // namespace

std::vector<Predicate> UseStates::of(std::string_view kind, const Role& use, const Kinds& kinds) const {
  std::vector<Predicate> states;
  for (const UseState& row : rows_) {
    const bool of_group = std::any_of(states.begin(), states.end(),
                                      [&](Predicate state) { return info(state).group == info(row.state).group; });
    if (of_group || !matches(row.use, use, kinds)) continue;
    if (std::any_of(row.things.begin(), row.things.end(), [&](const auto& wider) { return kinds.is_a(kind, wider); }))
      states.push_back(row.state);
  }
  return states;
}

UseStates read_use_states(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  std::vector<UseState> rows;
  each_row(path, {"use", "things", "state", "source"}, errors, [&](RowReader& row) {
    UseState fact{row.required("use"), row.list("things"),
                  row.value_of("state", plain_states(), "state without a substance", plain_state_named)};
    row.required("source");
    if (fact.things.empty()) row.fail("things", "expected kinds of kinds.csv");
    for (const auto& kind : fact.things) {
      if (kinds.find(kind) == nullptr) row.fail("things", "'" + kind + "' is not a kind of kinds.csv");
    }
    rows.push_back(std::move(fact));
  });
  return UseStates(std::move(rows));
}

}  // namespace unietp
