#include <algorithm>
#include <iterator>
#include <optional>

#include "logic/evaluate.h"

namespace unietp {
namespace {

/// Which of a goal's domains are empty, by their place in the text.
class EmptyDomains {
 public:
  explicit EmptyDomains(const Trace& trace) : trace_(trace) {}

  std::vector<std::string> find(const Formula& goal) {
    const auto places = walk(goal, 0, {});
    std::vector<std::string> result;
    for (const int place : places) result.push_back(texts_[static_cast<std::size_t>(place)]);
    return result;
  }

 private:
  using Places = std::vector<int>;  // sorted

  static Places united(const Places& a, const Places& b) {
    Places all;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
    return all;
  }
  static Places common(const Places& a, const Places& b) {
    Places both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
  }

  static int size_of(const Formula& formula) {
    int size = 1;
    for (const auto& where : formula.domain.where) size += size_of(where);
    for (const auto& child : formula.children) size += size_of(child);
    return size;
  }

  /// Whether a domain within the formula is another one for another value of the variable.
  static bool domains_depend_on(const std::string& variable, const Formula& formula) {
    const auto& wheres = formula.domain.where;
    return std::any_of(wheres.begin(), wheres.end(),
                       [&](const Formula& where) {
                         const auto free = free_variables(where);
                         return std::find(free.begin(), free.end(), variable) != free.end() ||
                                domains_depend_on(variable, where);
                       }) ||
           std::any_of(formula.children.begin(), formula.children.end(),
                       [&](const Formula& child) { return domains_depend_on(variable, child); });
  }

  /// `place` is the formula's number in the order of the text.
  Places walk(const Formula& formula, int place, const Assignment& assignment) {
    int next = place + 1;
    const int where_place = next;
    for (const auto& where : formula.domain.where) next += size_of(where);
    if (formula.variable.empty()) {
      Places result;
      for (const auto& child : formula.children) {
        result = united(result, walk(child, next, assignment));
        next += size_of(child);
      }
      return result;
    }
    if (static_cast<int>(texts_.size()) <= place) texts_.resize(static_cast<std::size_t>(place) + 1);
    auto& text = texts_[static_cast<std::size_t>(place)];
    if (text.empty()) text = to_text(formula.domain);
    auto members = members_of(formula.domain, formula.variable, trace_, assignment);
    Places result;
    if (members.empty() && formula.op != Formula::Op::Exists) result = {place};
    // What is the same for all of them is looked at once.
    if (members.size() > 1 && !domains_depend_on(formula.variable, formula)) members.resize(1);
    std::optional<Places> below;
    for (const EntityIndex e : members) {
      Assignment inner = assignment;
      inner.emplace_back(formula.variable, e);
      Places here = walk(formula.children.front(), next, inner);
      for (const auto& where : formula.domain.where) here = united(here, walk(where, where_place, inner));
      if (!below)
        below = std::move(here);
      else
        below = formula.op == Formula::Op::Forall ? common(*below, here) : united(*below, here);
    }
    return below ? united(result, *below) : result;
  }

  const Trace& trace_;
  std::vector<std::string> texts_;
};

}  // namespace

std::vector<std::string> empty_domains(const Formula& goal, const Trace& trace) {
  return EmptyDomains(trace).find(goal);
}

}  // namespace unietp
