#include "authoring/coverage.h"

#include <algorithm>
#include <set>

namespace unietp {
namespace {

void collect(const Formula& formula, std::set<std::string>& names) {
  if (formula.op == Formula::Op::Atom) names.emplace(info(formula.predicate).name);
  for (const auto& where : formula.domain.where) collect(where, names);
  for (const auto& child : formula.children) collect(child, names);
}

std::vector<std::pair<std::size_t, std::size_t>> cells_that(const std::vector<CoverageRow>& rows,
                                                            const std::function<bool(const CoverageCell&)>& holds) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t i = 0; i < kSimulators.size(); ++i) {
      if (holds(rows[row].cells[i])) found.emplace_back(row, i);
    }
  }
  return found;
}

}  // namespace

std::vector<CoverageRow> coverage_of(const Resources& resources, const std::vector<std::size_t>& positions) {
  std::vector<CoverageRow> rows;
  for (const auto position : positions) {
    const auto& source = resources.templates[position];
    std::set<std::string> predicates;
    collect(source.goal, predicates);
    CoverageRow row{source.name, source.split, {predicates.begin(), predicates.end()}, {}};
    for (const auto simulator : source.simulators) row.cells[static_cast<std::size_t>(simulator)].claimed = true;
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::pair<std::size_t, std::size_t>> claimed_cells(const std::vector<CoverageRow>& rows) {
  return cells_that(rows, [](const CoverageCell& cell) { return cell.claimed; });
}

std::vector<std::pair<std::size_t, std::size_t>> empty_cells(const std::vector<CoverageRow>& rows) {
  return cells_that(rows, [](const CoverageCell& cell) { return cell.claimed && cell.accepted == 0; });
}

std::vector<PredicateUse> predicate_uses(const std::vector<CoverageRow>& rows) {
  std::vector<PredicateUse> uses;
  for (const auto& predicate : all_predicates()) {
    PredicateUse use{std::string(predicate.name), {}};
    for (const auto& row : rows) {
      if (!std::binary_search(row.predicates.begin(), row.predicates.end(), use.predicate)) continue;
      for (std::size_t i = 0; i < kSimulators.size(); ++i) use.templates[i] += row.cells[i].claimed ? 1 : 0;
    }
    uses.push_back(std::move(use));
  }
  return uses;
}

std::string to_text(const CoverageCell& cell) {
  if (!cell.claimed) return "";
  if (cell.candidates == 0) return "yes";
  return std::to_string(cell.accepted) + "/" + std::to_string(cell.candidates);
}

}  // namespace unietp
