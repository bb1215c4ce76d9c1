#include "expert/alternatives.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace unietp {
namespace {

constexpr std::size_t kMostPicks = 64;
constexpr double kNoWay = 1e6;

bool same_choice(const Alternative& a, const Alternative& b) {
  if (a.cost != b.cost || a.end != b.end || a.moments.size() != b.moments.size()) return false;
  for (std::size_t i = 0; i < a.moments.size(); ++i) {
    if (a.moments[i].literals != b.moments[i].literals || a.moments[i].after != b.moments[i].after) return false;
  }
  return a.keeps.size() == b.keeps.size();
}

void append_later_parts(Alternative& to, const Alternative& from) {
  const std::size_t offset = to.moments.size();
  for (Moment moment : from.moments) {
    for (std::size_t& before : moment.after) before += offset;
    to.moments.push_back(std::move(moment));
  }
  for (Keep keep : from.keeps) {
    if (keep.until != Keep::kAlways) keep.until += offset;
    to.keeps.push_back(std::move(keep));
  }
}

double price_of(const Choices::List& list) { return list.empty() ? kNoWay : list.front().cost; }

}  // namespace

Choices::List Choices::trimmed(List list) const {
  std::stable_sort(list.begin(), list.end(),
                   [](const Alternative& a, const Alternative& b) { return a.cost < b.cost; });
  List kept;
  for (Alternative& alternative : list) {
    if (kept.size() == beam_) break;
    const bool repeated = std::any_of(kept.begin(), kept.end(),
                                      [&](const Alternative& other) { return same_choice(other, alternative); });
    if (!repeated) kept.push_back(std::move(alternative));
  }
  return kept;
}

Choices::List Choices::single(Literal literal) const {
  Alternative alternative;
  alternative.end.push_back(std::move(literal));
  alternative.cost = estimate(alternative, situation_, experience_);
  return {std::move(alternative)};
}

Choices::List Choices::either(List a, List b) const {
  std::move(b.begin(), b.end(), std::back_inserter(a));
  return trimmed(std::move(a));
}

Choices::List Choices::both(const List& a, const List& b) const {
  List list;
  for (const Alternative& left : a) {
    for (const Alternative& right : b) {
      const bool contradiction = std::any_of(left.end.begin(), left.end.end(), [&](const Literal& one) {
        return std::any_of(right.end.begin(), right.end.end(),
                           [&](const Literal& other) { return clash(one, other, situation_); });
      });
      if (contradiction) continue;
      Alternative merged = left;
      merged.end.clear();
      std::set_union(left.end.begin(), left.end.end(), right.end.begin(), right.end.end(),
                     std::back_inserter(merged.end));
      append_later_parts(merged, right);
      merged.cost = estimate(merged, situation_, experience_);
      list.push_back(std::move(merged));
    }
  }
  return trimmed(std::move(list));
}

Choices::List Choices::in_turn(const List& a, const List& b) const {
  List list;
  for (const Alternative& left : a) {
    for (const Alternative& right : b) {
      Alternative merged;
      merged.moments.push_back({left.end, {}});
      merged.moments.push_back({right.end, {0}});
      merged.cost = estimate(merged, situation_, experience_);
      list.push_back(std::move(merged));
    }
  }
  return trimmed(std::move(list));
}

/// Which k of the members to take: the cheapest first, then neighbours of that choice.
std::vector<std::vector<bool>> Choices::picks(std::size_t k, const std::vector<double>& price) const {
  std::vector<std::size_t> order(price.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return price[a] < price[b]; });
  std::vector<bool> ranks(price.size(), false);  // by place in `order`
  std::fill(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(k), true);
  std::vector<std::vector<bool>> result;
  do {
    std::vector<bool> pick(price.size(), false);
    for (std::size_t i = 0; i < ranks.size(); ++i) pick[order[i]] = ranks[i];
    result.push_back(std::move(pick));
  } while (result.size() < kMostPicks && std::prev_permutation(ranks.begin(), ranks.end()));
  return result;
}

Choices::List Choices::exactly(int k, const std::vector<Member>& members) const {
  if (k < 0 || static_cast<std::size_t>(k) > members.size()) return none();
  std::vector<double> price;
  for (const Member& member : members) price.push_back(price_of(member.yes) - price_of(member.no));
  List result;
  for (const std::vector<bool>& pick : picks(static_cast<std::size_t>(k), price)) {
    List all = nothing_to_do();
    for (std::size_t i = 0; i < members.size() && !all.empty(); ++i) {
      all = both(all, pick[i] ? members[i].yes : members[i].no);
    }
    result = either(std::move(result), std::move(all));
  }
  return result;
}

Choices::List Choices::at_least(int k, const std::vector<Member>& members) const {
  if (k <= 0) return nothing_to_do();
  if (static_cast<std::size_t>(k) > members.size()) return none();
  std::vector<double> price;
  for (const Member& member : members) price.push_back(price_of(member.yes));
  List result;
  for (const std::vector<bool>& pick : picks(static_cast<std::size_t>(k), price)) {
    List all = nothing_to_do();
    for (std::size_t i = 0; i < members.size() && !all.empty(); ++i) {
      if (pick[i]) all = both(all, members[i].yes);
    }
    result = either(std::move(result), std::move(all));
  }
  return result;
}

Choices::List Choices::at_most(int k, const std::vector<Member>& members) const {
  std::vector<Member> turned;
  for (const Member& member : members) turned.push_back({member.no, member.yes});
  return at_least(static_cast<int>(members.size()) - k, turned);
}

}  // namespace unietp
